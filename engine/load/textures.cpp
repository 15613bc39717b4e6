#include "load/textures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <tl/expected.hpp>
#include <utility>

#include "image/image_file.h"
#include "load/json/fields.h"
#include "load/suggest.h"
#include "math/parallel.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kExtensions{".png", ".jpg", ".bmp", ".tga"};

bool hasKnownExtension(const fs::path& path) {
  return std::ranges::find(kExtensions, path.extension().string()) != kExtensions.end();
}

class ImageFinder {
 public:
  explicit ImageFinder(const TexturePlace& place) : files_(place.files) {
    const fs::path home = place.level.parent_path();
    if (place.folder)
      folders_ = {home / place.folder->name};
    else
      folders_ = {home / ".." / "textures", home};
  }

  std::optional<fs::path> find(const std::string& name) const {
    for (const fs::path& folder : folders_)
      if (auto file = withExtension(folder / name)) return file;
    return std::nullopt;
  }

  /// The image whose path this is without its extension.
  std::optional<fs::path> withExtension(const fs::path& path) const {
    for (const std::string_view extension : kExtensions) {
      fs::path candidate = path;
      candidate += extension;
      if (files_.kindOf(candidate) == FileKind::Regular) return candidate;
    }
    return std::nullopt;
  }

  /// Names of all images that could be meant.
  std::vector<std::string> known() const {
    std::vector<std::string> names;
    for (const fs::path& folder : folders_)
      for (const fs::path& name : files_.namesIn(folder))
        if (hasKnownExtension(name) && files_.kindOf(folder / name) == FileKind::Regular)
          names.push_back(name.stem().string());
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
  }

  std::string searched() const {
    std::vector<std::string> names;
    for (const fs::path& folder : folders_)
      names.push_back((folder.empty() ? "." : folder.lexically_normal().string()) +
                      (exists(folder) ? "" : " (which does not exist)"));
    return fmt::format("{}", fmt::join(names, " or "));
  }

  /// The one that the level names.
  std::string named() const { return folders_.front().lexically_normal().string(); }

  bool hasFolder() const {
    return std::ranges::any_of(folders_, [this](const fs::path& folder) { return exists(folder); });
  }

 private:
  bool exists(const fs::path& folder) const {
    return files_.kindOf(folder.empty() ? "." : folder) == FileKind::Folder;
  }

  const FileSource& files_;
  std::vector<fs::path> folders_;
};

/// What is no image, and was meant for a colour.
std::optional<std::string> adviceOnColor(const std::string& name) {
  constexpr std::array<std::string_view, 14> kNames{"black",  "blue", "brown",   "cyan",   "gray",
                                                    "green",  "grey", "magenta", "orange", "pink",
                                                    "purple", "red",  "white",   "yellow"};
  if (parseColor("#" + name)) return fmt::format("did you mean \"#{}\"?", name);
  if (std::ranges::find(kNames, name) == kNames.end()) return std::nullopt;
  return "write a colour as \"#rrggbb\"";
}

/// What is named with the scale of a wall's texture, where an image's name alone is wanted.
std::optional<std::string> adviceOnScale(const std::string& name, const ImageFinder& finder) {
  const std::string image = name.substr(0, name.find(' '));
  if (image == name || !finder.find(image)) return std::nullopt;
  return fmt::format("write the image's name alone: \"{}\"", image);
}

std::string adviceOn(const std::string& name, const ImageFinder& finder) {
  if (const auto advice = adviceOnScale(name, finder)) return *advice;
  const bool isFileName = hasKnownExtension(name);
  const std::string stem = isFileName ? fs::path(name).stem().string() : name;
  if (finder.find(stem)) return fmt::format("leave out the extension: \"{}\"", stem);
  const std::vector<std::string> known = finder.known();
  const std::vector<std::string_view> views(known.begin(), known.end());
  if (!nearestName(stem, views))
    if (const auto color = adviceOnColor(name)) return *color;
  return suggest(stem, views,
                 fmt::format("{}give the folder of the images as \"textures\", or put it into {}",
                             isFileName ? "leave out the extension, and " : "", finder.searched()));
}

void reportMissing(Report& report, const NameReference& name, const ImageFinder& finder) {
  if (report.isFull()) return report.error(name.place, "", "");
  report.error(name.place, fmt::format("there is no image \"{}\"", name.name),
               adviceOn(name.name, finder));
}

/// Reports a folder that is named and does not exist, which explains all images that are missing.
void reportMissingFolder(Report& report, const NameReference& folder, const ImageFinder& finder) {
  report.error(folder.place, fmt::format("there is no folder {}", finder.named()),
               "give the folder of the images, seen from the folder of this file");
}

/// Reports textures of which there is no file.
class MissingReporter {
 public:
  MissingReporter(Report& report, const TexturePlace& place, const ImageFinder& finder)
      : report_(report), place_(place), finder_(finder) {}

  void tell(const NamedTexture& texture) {
    if (texture.foreign) return tellForeign(texture.place, *texture.foreign);
    if (isFolderMissing_) return;
    isFolderMissing_ = place_.folder && !finder_.hasFolder();
    if (isFolderMissing_)
      reportMissingFolder(report_, *place_.folder, finder_);
    else
      reportMissing(report_, texture, finder_);
  }

 private:
  void tellForeign(Place place, const ForeignImage& image) {
    const std::optional<fs::path> meant = finder_.withExtension(image.file);
    report_.error(
        place,
        fmt::format("there is no file {}, which {} names", image.file.string(), image.namedAt),
        meant ? fmt::format("did you mean {}?", meant->filename().string())
              : "put the image there, or correct its path, which is relative to the file that "
                "names it");
  }

  Report& report_;
  const TexturePlace& place_;
  const ImageFinder& finder_;
  bool isFolderMissing_ = false;  // reported once
};

struct Mistake {
  std::string message;
  std::string advice;
};

/// None of an image of which only the header is read.
using ImageRead = tl::expected<std::optional<Image>, Mistake>;

ImageRead readFrom(const FileSource& files, const fs::path& path, bool isWorn,
                   const LoadLimits& limits) {
  const auto mistake = [](std::string message, std::string advice) {
    return tl::unexpected(Mistake{std::move(message), std::move(advice)});
  };
  const auto size = readImageSize(path, files);
  if (!size) return mistake(size.error(), "replace the image");
  if (std::int64_t{size->width} * size->height > limits.imagePixels)
    return mistake(fmt::format("{} has {} x {} pixels, more than {}", path.string(), size->width,
                               size->height, limits.imagePixels),
                   "raise the limit with --max-image-pixels");
  if (!isWorn) return std::nullopt;
  auto image = readImage(path, limits.imagePixels, files);
  if (!image) return mistake(image.error(), "replace the image");
  return *std::move(image);
}

/// The surfaces that show, and those that may while flats move.
std::vector<SurfaceId> surfacesToShow(const Scene& scene) {
  const Level& level = scene.level();
  std::vector<SurfaceId> surfaces = scene.shownSurfaces();
  const auto add = [&](const Segment& segment) {
    for (const WallSurfaces& wall : level.surfacesOf(segment))
      for (const auto& surface : {wall.solid, wall.lower, wall.upper, wall.maskedMiddle,
                                  wall.floorSidewall, wall.ceilingSidewall})
        if (surface) surfaces.push_back(*surface);
  };
  for (const Mover& mover : level.movers)
    for (const SectorId sector : mover.sectors) {
      for (const Segment& segment : level.segmentsOf(level[sector])) add(segment);
      for (const SegmentId entrance : level.entrancesOf(level[sector])) add(level[entrance]);
    }
  return surfaces;
}

/// By TextureId.
std::vector<bool> wornIn(const Scene& scene, std::size_t textures) {
  std::vector<bool> worn(textures);
  for (const SurfaceId id : surfacesToShow(scene)) worn[scene[id].mapping.texture.index()] = true;
  for (const Sprite& sprite : scene.level().sprites)
    for (const std::vector<SpriteView>& views : sprite.frames)
      for (const SpriteView& view : views) worn[view.texture.index()] = true;
  for (const MeshFace& face : scene.level().meshFaces) worn[face.texture.index()] = true;
  for (const SwitchTexture& texture : scene.level().switchTextures) worn[texture.on.index()] = true;
  return worn;
}

bool isColor(const NamedTexture& texture) {
  return !texture.foreign && texture.name.starts_with('#');
}
bool isPath(const NamedTexture& texture) {
  return !texture.foreign && texture.name.find_first_of("/\\") != std::string::npos;
}

/// None of what is no image, or of one that is not found.
std::optional<fs::path> pathOf(const NamedTexture& texture, const ImageFinder& finder,
                               const FileSource& files) {
  if (isColor(texture) || isPath(texture)) return std::nullopt;
  if (!texture.foreign) return finder.find(texture.name);
  const fs::path& file = texture.foreign->file;
  return files.kindOf(file) == FileKind::Regular ? std::optional(file) : std::nullopt;
}

/// The image of a colour; one of a mistake, which is reported.
Image imageOfColor(Report& report, const NameReference& name) {
  if (const std::optional<Rgb> color = parseColor(name.name)) return Image(1, 1, *color);
  report.error(name.place, fmt::format("\"{}\" is no colour", name.name),
               "write \"#rrggbb\" with hexadecimal digits");
  return Image(1, 1);
}

/// By TextureId.
std::vector<ImageRead> readAll(const FileSource& files,
                               std::span<const std::optional<fs::path>> paths,
                               const std::vector<bool>& worn, const LoadLimits& limits) {
  // Each may take as much memory for a while as a decoder is allowed.
  constexpr int kMaxThreads = 4;
  std::vector<ImageRead> reads(paths.size());
  parallelFor(paths.size(), std::min(kMaxThreads, availableThreads()), [&](std::size_t i) {
    if (paths[i]) reads[i] = readFrom(files, *paths[i], worn[i], limits);
  });
  return reads;
}

TexelHoles holesOf(const Image& image) {
  if (!image.hasHoles()) return {};
  TexelHoles holes(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (image.isHole(x, y)) holes.setHole(x, y);
  return holes;
}

}  // namespace

TextureMapping TextureTable::link(const TextureDescription& texture) {
  TextureMapping mapping;
  mapping.texture = idOf(texture.name);
  mapping.repeat = texture.scale;
  mapping.offsetTexels = texture.offset;
  mapping.along = texture.along;
  mapping.zRef = texture.zRef;
  return mapping;
}

TextureMapping TextureTable::standIn() {
  TextureMapping mapping;
  mapping.texture = idOf({"#ff00ff", {}});
  return mapping;
}

TextureId TextureTable::idOf(const NameReference& name) {
  const auto [found, isNew] = ids_.emplace(name.name, TextureId(textures_.size()));
  if (isNew) textures_.push_back({name, std::nullopt});
  return usedAt(found->second, name.place);
}

TextureId TextureTable::idOf(const NameReference& name, const ForeignImage& image) {
  const auto [found, isNew] = foreign_.emplace(image.file.string(), TextureId(textures_.size()));
  if (isNew) textures_.push_back({name, image});
  return usedAt(found->second, name.place);
}

TextureId TextureTable::usedAt(TextureId id, Place place) {
  Place& firstUse = textures_[id.index()].place;
  firstUse = std::min(firstUse, place);
  return id;
}

TextureFiles readTextures(Report& report, const TextureTable& table, const Scene& scene,
                          const TexturePlace& place, const LoadLimits& limits) {
  const ImageFinder finder(place);
  const std::vector<NamedTexture>& named = table.textures();
  std::vector<std::optional<fs::path>> paths;
  for (const NamedTexture& texture : named) paths.push_back(pathOf(texture, finder, place.files));
  std::vector<ImageRead> reads = readAll(place.files, paths, wornIn(scene, named.size()), limits);
  MissingReporter missing(report, place, finder);
  TextureFiles textures;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const NamedTexture& texture = named[i];
    Image& image = textures.images.emplace_back(1, 1);
    if (isColor(texture)) {
      image = imageOfColor(report, texture);
    } else if (isPath(texture)) {
      report.error(texture.place, fmt::format("\"{}\" is a path", texture.name),
                   "write the name of an image of the textures folder");
    } else if (!paths[i]) {
      missing.tell(texture);
    } else {
      textures.files.push_back(*paths[i]);
      if (!reads[i]) {
        const auto& [message, advice] = reads[i].error();
        report.error(
            texture.place,
            texture.foreign ? fmt::format("{}: {}", texture.foreign->namedAt, message) : message,
            advice);
      } else if (*reads[i]) {
        ++textures.decoded;
        image = **std::move(reads[i]);
      }
    }
  }
  return textures;
}

void sizeSprites(Level& level, const std::vector<Image>& images) {
  constexpr double kTexelsPerMetre = 64;
  for (Sprite& sprite : level.sprites)
    for (std::vector<SpriteView>& views : sprite.frames)
      for (SpriteView& view : views) {
        const Image& image = images[view.texture.index()];
        if (view.size == Vec2{})
          view.size = {image.width() / kTexelsPerMetre, image.height() / kTexelsPerMetre};
      }
}

Vec3 reflectanceOf(const Image& image) {
  std::array<std::uint64_t, 3> sums{};
  std::uint64_t count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (image.isHole(x, y)) continue;
      const Rgb pixel = image.at(x, y);
      sums[0] += pixel.r;
      sums[1] += pixel.g;
      sums[2] += pixel.b;
      ++count;
    }
  const double full = 255.0 * static_cast<double>(std::max<std::uint64_t>(count, 1));
  const auto mean = [&](std::size_t channel) { return static_cast<double>(sums[channel]) / full; };
  return {mean(0), mean(1), mean(2)};
}

std::vector<TexelHoles> holesOfMaskedMiddles(const Scene& scene, const std::vector<Image>& images) {
  std::vector<TexelHoles> holes(images.size());
  for (const SurfaceId id : surfacesToShow(scene)) {
    const Surface& surface = scene[id];
    if (surface.kind != SurfaceKind::MaskedMiddle) continue;
    TexelHoles& found = holes[surface.mapping.texture.index()];
    if (found.bits().empty()) found = holesOf(images[surface.mapping.texture.index()]);
  }
  return holes;
}

}  // namespace hearth
