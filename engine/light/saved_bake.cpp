#include "light/saved_bake.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>

#include "light/baking/sprite_light.h"
#include "light/byte_stream.h"
#include "light/file_frame.h"
#include "light/geometry_hash.h"
#include "light/grid/texel_limits.h"
#include "math/check.h"

namespace hearth {

namespace {

// The layout, of which saved_bake.md has the table. Numbers are little-endian.
constexpr FileFrame kBakeFrame{
    .begin = "\x89HEARTH\n",
    .kind = "saved bake",
    // To be raised with the layout, and with the rules of surfaces, their order and texel grids.
    .version = 5,
    .headerBytes = 52};
/// Surface, i0, j0, width, height and channels, before the texels of each lightmap.
constexpr std::size_t kMapNumbers = 6;
constexpr std::size_t kShortBytes = 5;  ///< at most

/// Of zlib, 1 to 9: the best that takes no more than about twice the time of the quickest, as
/// engine/README.md tells.
constexpr int kPackingLevel = 4;

using Mistake = std::optional<std::string>;

const Bytef* zlibBytes(std::string_view bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

Bytef* zlibBytes(std::string& bytes) { return reinterpret_cast<Bytef*>(bytes.data()); }

std::string packed(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  // Not set to zero, which would take memory for bytes that none of the packed ones fills.
  const auto packed = std::make_unique_for_overwrite<Bytef[]>(size);
  const int result = compress2(packed.get(), &size, zlibBytes(bytes), bytes.size(), kPackingLevel);
  if (result == Z_MEM_ERROR) throw std::bad_alloc();
  CHECK(result == Z_OK, result);
  return {packed.get(), packed.get() + size};
}

/// What was packed, if it is `size` bytes, or what is wrong with it.
tl::expected<std::string, std::string> unpacked(std::string_view packed, std::size_t size) {
  std::string bytes(size + 1, '\0');  // one more, to see whether there are more
  uLongf written = bytes.size();
  uLong taken = packed.size();
  const int result = uncompress2(zlibBytes(bytes), &written, zlibBytes(packed), &taken);
  if (result == Z_MEM_ERROR) throw std::bad_alloc();
  if (result == Z_BUF_ERROR || (result == Z_OK && written > size))
    return tl::unexpected(
        fmt::format("has lightmaps of more than the {} bytes that it counts", size));
  if (result != Z_OK) return tl::unexpected(std::string("has lightmaps that cannot be unpacked"));
  if (taken < packed.size())
    return tl::unexpected(fmt::format("has {} bytes after its lightmaps", packed.size() - taken));
  if (written < size)
    return tl::unexpected(
        fmt::format("has lightmaps of {} bytes, and not of the {} that it counts", written, size));
  bytes.resize(size);
  return bytes;
}

std::size_t texelsIn(const TexelRect& rect) {
  return static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
}

/// Visits the bytes of a lightmap from the second texel on, in order, each with that from which its
/// difference is saved: the same channel of the texel above it or, in the first row, to its left.
template <typename Visit>
void visitDifferences(const TexelRect& rect, std::size_t channels, std::size_t bytes, Visit visit) {
  const std::size_t row = static_cast<std::size_t>(rect.width) * channels;
  for (std::size_t i = channels; i < std::min(row, bytes); ++i) visit(i, i - channels);
  for (std::size_t i = row; i < bytes; ++i) visit(i, i - row);
}

/// As differences, which are small numbers where light is smooth, and pack well.
void putTexels(std::string& bytes, const Lightmap& map) {
  const auto channels = static_cast<std::size_t>(map.channels);
  const std::size_t begin = bytes.size();
  bytes.append(map.levels.begin(), map.levels.end());
  visitDifferences(map.rect, channels, map.levels.size(), [&](std::size_t i, std::size_t from) {
    bytes[begin + i] = static_cast<char>(map.levels[i] - map.levels[from]);
  });
  // Of even light there is the first texel, from which no other differs.
  if (map.isUniform()) bytes.append(channels * (texelsIn(map.rect) - 1), '\0');
}

void put(std::string& bytes, std::uint32_t surface, const Lightmap& map) {
  const TexelRect& rect = map.rect;
  for (const std::uint32_t number :
       {surface, folded(rect.i0), folded(rect.j0), static_cast<std::uint32_t>(rect.width),
        static_cast<std::uint32_t>(rect.height), static_cast<std::uint32_t>(map.channels)})
    putShort(bytes, number);
  putTexels(bytes, map);
}

/// No less than put() adds.
std::size_t bytesOf(const Lightmap& map) {
  return kMapNumbers * kShortBytes + static_cast<std::size_t>(map.channels) * texelsIn(map.rect);
}

struct Header {
  std::uint32_t settingsBytes;
  std::uint64_t fileBytes;
  std::uint64_t geometry;
  double texel;
  std::uint32_t lightmaps;
  std::uint64_t lightmapBytes;  ///< unpacked
};

Header takeHeader(ByteReader& in) {
  Header header;
  header.settingsBytes = in.take32();
  header.fileBytes = in.take64();
  header.geometry = in.take64();
  header.texel = std::bit_cast<double>(in.take64());
  header.lightmaps = in.take32();
  header.lightmapBytes = in.take64();
  return header;
}

/// One of the bakes of a file.
struct BakeBlock {
  Header header;
  std::string_view settings;
  std::string_view body;  ///< packed
};

/// The bytes up to the next bake, if one begins where the first ends; else all.
std::string_view firstBlock(std::string_view bytes) {
  if (bytes.size() < kBakeFrame.headerBytes) return bytes;
  ByteReader in(bytes.substr(FileFrame::kVersionEnd));
  const std::uint64_t length = takeHeader(in).fileBytes;
  if (length < kBakeFrame.headerBytes || length >= bytes.size()) return bytes;
  return bytes.substr(length).starts_with(kBakeFrame.begin) ? bytes.substr(0, length) : bytes;
}

tl::expected<BakeBlock, std::string> blockOf(std::string_view bytes) {
  if (auto mistake = mistakeInFrame(kBakeFrame, bytes)) return tl::unexpected(*std::move(mistake));
  const std::string_view framed = bytes.substr(0, bytes.size() - FileFrame::kChecksumBytes);
  ByteReader in(framed.substr(FileFrame::kVersionEnd));
  const Header header = takeHeader(in);
  if (const std::size_t most = std::min(kMaxSettingsBytes, in.left()); header.settingsBytes > most)
    return tl::unexpected(fmt::format("has settings of {} bytes, where at most {} can be",
                                      header.settingsBytes, most));
  const std::string_view settings = in.take(header.settingsBytes);
  return BakeBlock{header, settings, in.take(in.left())};
}

/// The first bake of a file that was baked for the scene's geometry. All of the file is checked.
tl::expected<BakeBlock, std::string> blockFor(const Scene& scene, std::string_view bytes) {
  std::optional<BakeBlock> first;
  std::optional<BakeBlock> found;
  std::uint64_t geometry = 0;
  do {
    const std::string_view begin = firstBlock(bytes);
    const auto block = blockOf(begin);
    if (!block) return tl::unexpected(block.error());
    const double texel = block->header.texel;
    if (first && texel != first->header.texel)
      return tl::unexpected(std::string("has bakes with texels of several sizes"));
    if (!first) {
      if (const auto mistake = mistakeInTexel(scene, texel))
        return tl::unexpected(fmt::format("has texels that cannot be: {}", *mistake));
      geometry = geometryHash(scene, texel);
      first = *block;
    }
    if (!found && block->header.geometry == geometry) found = *block;
    bytes.remove_prefix(begin.size());
  } while (!bytes.empty());
  if (found) return *found;
  return tl::unexpected(
      fmt::format("was baked for other geometry than the level has now, with the settings {:?}",
                  first->settings));
}

/// As many bytes as the lightmaps of all surfaces can have.
std::uint64_t maxLightmapBytes(const BakedLight& light, std::size_t sprites) {
  constexpr std::uint64_t kBytesPerTexel = 3;
  std::uint64_t bytes = 0;
  const auto add = [&](const TexelRect& texels) {
    bytes += kMapNumbers * kShortBytes + kBytesPerTexel * texelsIn(texels);
  };
  for (const auto& surface : light.surfaces)
    if (surface) add(surface->texels);
  for (const LitMesh& mesh : light.meshes) add(mesh.texels);
  for (std::size_t i = 0; i < sprites; ++i) add(kSpriteTexel);
  return bytes;
}

/// That no more memory is needed for the lightmaps than there is light in the level, and allowed.
std::optional<BakeMistake> mistakeInSize(const Header& header, const BakedLight& light,
                                         std::size_t sprites, std::uint64_t maxLightBytes) {
  const std::uint64_t most = maxLightmapBytes(light, sprites);
  if (header.lightmapBytes > most)
    return BakeMistake{fmt::format("has lightmaps of {} bytes, where at most {} can be",
                                   header.lightmapBytes, most)};
  if (header.lightmapBytes > maxLightBytes)
    return BakeMistake{
        fmt::format("has lightmaps of {} bytes, more than {}", header.lightmapBytes, maxLightBytes),
        true};
  return std::nullopt;
}

/// Takes the lightmaps of a file whose frame and geometry are right.
class LightmapReader {
 public:
  LightmapReader(const Scene& scene, BakedLight& light, std::string_view bytes)
      : scene_(scene), surfaces_(scene.shownSurfaces()), light_(light), in_(bytes) {}

  Mistake readAll(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (in_.left() == 0)
        return fmt::format("has only {} of the {} lightmaps that it counts", i, count);
      if (auto mistake = readOne()) return mistake;
    }
    if (in_.left() > 0) return fmt::format("has {} bytes after its lightmaps", in_.left());
    return std::nullopt;
  }

 private:
  Mistake readOne() {
    std::array<std::uint32_t, kMapNumbers> numbers{};
    for (std::uint32_t& number : numbers) {
      const auto taken = in_.takeShort();
      if (!taken) return "has a lightmap that does not begin with six numbers";
      number = *taken;
    }
    const auto [surface, i0, j0, width, height, channels] = numbers;
    if (surface >= surfaces_.size())
      return fmt::format("has a lightmap for surface {}, of a level with {}", surface,
                         surfaces_.size());
    const std::size_t index = surfaces_[surface].index();
    std::optional<Lightmap>& map = light_.lightmaps[index];
    const TexelRect* const expected = texelsOf(surfaces_[surface]);
    if (!expected) return wrong(surface, "that never shows light");
    if (map) return wrong(surface, "that has one already");
    const TexelRect rect{unfolded(i0), unfolded(j0), static_cast<int>(width),
                         static_cast<int>(height)};
    if (rect != *expected)
      return wrong(surface,
                   fmt::format("with texels {} instead of {}", words(rect), words(*expected)));
    if (channels != 1 && channels != 3)
      return wrong(surface, fmt::format("with {} channels instead of 1 or 3", channels));
    if (in_.left() / channels < texelsIn(rect)) return wrong(surface, "that is cut short");
    map = compacted({rect, takeTexels(rect, channels), static_cast<int>(channels)});
    return std::nullopt;
  }

  /// None of a surface that takes no light.
  const TexelRect* texelsOf(SurfaceId id) const {
    const SurfaceKind kind = scene_[id].kind;
    if (isSprite(kind)) return &kSpriteTexel;
    if (kind == SurfaceKind::Mesh) return &light_.meshes[scene_.level().meshIndexOf(id)].texels;
    const auto& lit = light_.surfaces[id.index()];
    return lit ? &lit->texels : nullptr;
  }

  std::vector<std::uint8_t> takeTexels(const TexelRect& rect, std::size_t channels) {
    const std::string_view differences = in_.take(channels * texelsIn(rect));
    std::vector<std::uint8_t> texels(differences.begin(), differences.end());
    visitDifferences(rect, channels, texels.size(), [&](std::size_t i, std::size_t from) {
      texels[i] = static_cast<std::uint8_t>(texels[i] + texels[from]);
    });
    return texels;
  }

  std::string wrong(std::uint32_t surface, std::string_view what) const {
    return fmt::format("has a lightmap for surface {} ({}) {}", surface,
                       name(scene_[surfaces_[surface]].kind), what);
  }

  static std::string words(const TexelRect& rect) {
    return fmt::format("({}, {}) {} x {}", rect.i0, rect.j0, rect.width, rect.height);
  }

  Scene scene_;
  std::vector<SurfaceId> surfaces_;  ///< by their numbers in the file
  BakedLight& light_;
  ByteReader in_;
};

}  // namespace

std::string encodeBake(const Scene& scene, const BakedLight& light, double texel,
                       std::string_view settings) {
  CHECK(settings.size() <= kMaxSettingsBytes, settings);
  std::string lightmaps;
  std::uint32_t count = 0;
  const std::vector<SurfaceId> surfaces = scene.shownSurfaces();
  std::size_t mostBytes = 0;
  for (const SurfaceId surface : surfaces)
    if (const auto& map = light.lightmaps[surface.index()]) mostBytes += bytesOf(*map);
  lightmaps.reserve(mostBytes);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const std::optional<Lightmap>& map = light.lightmaps[surfaces[i].index()];
    if (!map) continue;
    put(lightmaps, static_cast<std::uint32_t>(i), *map);
    ++count;
  }
  const std::string body = packed(lightmaps);
  std::string bytes(kBakeFrame.begin);
  put(bytes, kBakeFrame.version);
  put(bytes, static_cast<std::uint32_t>(settings.size()));
  put(bytes, std::uint64_t{kBakeFrame.headerBytes + settings.size() + body.size() +
                           FileFrame::kChecksumBytes});
  put(bytes, geometryHash(scene, texel));
  put(bytes, std::bit_cast<std::uint64_t>(texel));
  put(bytes, count);
  put(bytes, std::uint64_t{lightmaps.size()});
  bytes += settings;
  bytes += body;
  put(bytes, checksum(bytes));
  return bytes;
}

tl::expected<BakedLight, BakeMistake> decodeBake(const Scene& scene, std::string_view bytes,
                                                 std::uint64_t maxLightBytes) {
  const auto refused = [](std::string what) {
    return tl::unexpected(BakeMistake{std::move(what)});
  };
  const auto block = blockFor(scene, bytes);
  if (!block) return refused(block.error());
  const Header& header = block->header;

  BakedLight light;
  light.surfaces = makeLitSurfaces(scene, header.texel);
  light.meshes = makeLitMeshes(scene.level(), header.texel, 1);
  light.lightmaps.resize(light.surfaces.size());
  const std::size_t sprites = scene.level().sprites.size();
  if (auto mistake = mistakeInSize(header, light, sprites, maxLightBytes))
    return tl::unexpected(std::move(*mistake));
  const auto lightmaps = unpacked(block->body, header.lightmapBytes);
  if (!lightmaps) return refused(lightmaps.error());
  if (auto mistake = LightmapReader(scene, light, *lightmaps).readAll(header.lightmaps))
    return refused(std::move(*mistake));
  light.stats = statsOf(light);
  return light;
}

}  // namespace hearth
