#include "import/doom/materials.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "image/image_file.h"
#include "import/doom/pieces.h"

namespace hearth::doom {

namespace {

using Json = nlohmann::ordered_json;

/// In the place of images that are missing.
constexpr const char* kPlain = "#606060";
constexpr std::string_view kGrey = "it is grey";

constexpr double kFlatSide = kFlatPixels * kUnit;

// The sky of Doom hangs so that 1024 columns go round and 160 rows up to 45 degrees, and has its
// hundredth row at eye level.
constexpr double kSkyColumns = 1024;
constexpr double kSkyRows = 160;
constexpr double kSkyHorizon = 100;

/// https://doomwiki.org/wiki/Sky: one for each episode, or for each third of Doom II.
std::string skyOf(const std::string& map) {
  if (map.size() == 4 && map[0] == 'E' && map[2] == 'M') return fmt::format("SKY{}", map[1]);
  if (map.size() != 5 || !map.starts_with("MAP")) return "SKY1";
  const int number = (map[3] - '0') * 10 + (map[4] - '0');
  return number < 12 ? "SKY1" : number < 21 ? "SKY2" : "SKY3";
}

}  // namespace

std::string fileName(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z')
      result += static_cast<char>(c - 'A' + 'a');
    else if ((c >= '0' && c <= '9') || c == '_' || c == '-')
      result += c;
    else
      result += fmt::format("+{:02x}", static_cast<unsigned char>(c));
  }
  return result;
}

std::string wallImage(const std::string& texture) { return "wall-" + fileName(texture); }

std::string flatImage(const std::string& flat) { return "flat-" + fileName(flat); }

Materials::Materials(const Pictures& pictures, const std::string& map, Findings& findings,
                     std::size_t maxPixels)
    : pictures_(pictures), skyName_(skyOf(map)), findings_(findings), pixelsLeft_(maxPixels) {}

Json Materials::wall(const std::string& name, const Hanging& hanging) {
  const std::string file = wallImage(name);
  return draw(file, Kind::Wall, name, kGrey) ? hung(file, hanging) : Json(kPlain);
}

std::optional<Json> Materials::middle(const std::string& name, const Hanging& hanging) {
  const std::string file = wallImage(name);
  if (!draw(file, Kind::Wall, name, "it is left out")) return std::nullopt;
  return hung(file, hanging);
}

Json Materials::hung(const std::string& file, const Hanging& hanging) const {
  const Image& image = images_.at(file);
  Json texture{{"name", file}, {"scale", {image.width() * kUnit, image.height() * kUnit}}};
  if (hanging.xOffset != 0 || hanging.yOffset != 0)
    texture["offset"] = {-hanging.xOffset, -hanging.yOffset};
  if (hanging.along != 0) texture["along"] = hanging.along;
  if (hanging.top) texture["zref"] = *hanging.top;
  return texture;
}

std::optional<std::string> Materials::switched(const std::string& name) {
  if (!name.starts_with("SW1") && !name.starts_with("SW2")) return std::nullopt;
  std::string other = name;
  other[2] = name[2] == '1' ? '2' : '1';
  if (!pictures_.hasWall(other)) return std::nullopt;
  std::string file = wallImage(other);
  if (!draw(file, Kind::Wall, other, "it does not change")) return std::nullopt;
  return file;
}

Json Materials::flat(const std::string& name) {
  const std::string file = flatImage(name);
  if (!draw(file, Kind::Flat, name, kGrey)) return kPlain;
  return fmt::format("{} {:g},{:g}", file, kFlatSide, kFlatSide);
}

Json Materials::sky() {
  const std::string file = skyFile();
  const bool isFirst = !images_.contains(file);
  if (!draw(file, Kind::Wall, skyName_, kGrey)) return kPlain;
  Image& image = images_.at(file);
  if (isFirst) image = mirrored(image);  // Doom's columns of the sky go round to the left
  return Json{{"name", file},
              {"scale", {image.width() / kSkyColumns, image.height() / kSkyRows}},
              {"offset", {0, image.height() - kSkyHorizon}}};
}

const Image* Materials::skyImage() const { return find(skyFile()); }

const Image* Materials::find(const std::string& file) const {
  const auto found = images_.find(file);
  return found == images_.end() ? nullptr : &found->second;
}

bool Materials::takePixels(ImageSize size) {
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  if (pixels > pixelsLeft_) return false;
  pixelsLeft_ -= pixels;
  return true;
}

void Materials::add(const std::string& file, Image image) {
  images_.emplace(file, std::move(image));
}

double Materials::heightOf(const std::string& name) const {
  const auto size = pictures_.sizeOfWall(name);
  return size ? size->height * kUnit : 0;
}

tl::expected<void, std::string> Materials::write(const std::filesystem::path& folder) const {
  std::error_code error;  // is told by the writing
  std::filesystem::create_directories(folder, error);
  for (const auto& [file, image] : images_)
    if (auto written = writePng(folder / (file + ".png"), image); !written) return written;
  return {};
}

/// Whether there is an image for a file; what it misses is told once, with what is there instead.
bool Materials::draw(const std::string& file, Kind kind, const std::string& name,
                     std::string_view otherwise) {
  if (images_.contains(file)) return true;
  if (undrawn_.contains(file)) return false;
  const auto tell = [&](const std::string& what) {
    findings_.push_back({Outcome::Repaired, Part::Texture, 0, what});
  };
  auto picture = decode(kind, name);
  if (!picture) {
    undrawn_.insert(file);
    tell(fmt::format("{}: {}", picture.error(), otherwise));
    return false;
  }
  for (const std::string& mistake : picture->mistakes) tell(mistake);
  images_.emplace(file, withHoles(std::move(*picture)));
  return true;
}

tl::expected<Picture, std::string> Materials::decode(Kind kind, const std::string& name) {
  const ImageSize size = kind == Kind::Wall ? pictures_.sizeOfWall(name).value_or(ImageSize{})
                                            : ImageSize{kFlatPixels, kFlatPixels};
  if (!takePixels(size))
    return tl::unexpected(
        fmt::format("{} {} and the images before it have more pixels than a level's images may",
                    kind == Kind::Wall ? "wall texture" : "flat", name));
  return kind == Kind::Wall ? pictures_.wall(name) : pictures_.flat(name);
}

}  // namespace hearth::doom
