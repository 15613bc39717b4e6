#include "import/doom/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/doom/patch.h"

namespace hearth::doom {

namespace {

constexpr std::size_t kNameBytes = 8;
constexpr std::size_t kFlatBytes = std::size_t{kFlatPixels} * kFlatPixels;

/// The names in PNAMES, by which textures call their patches (https://doomwiki.org/wiki/PNAMES): a
/// 32-bit count, then eight bytes each. None where there is no such lump.
tl::expected<Bytes, std::string> readPatchNames(const Wad& wad) {
  if (!wad.find("PNAMES")) return Bytes{};
  const Bytes bytes = wad.bytesOf("PNAMES");
  if (bytes.size() < 4) return tl::unexpected<std::string>("PNAMES is cut short: it has no count");
  const std::int64_t count = int32At(bytes, 0);
  const Bytes names = bytes.subspan(4);
  if (count < 0 || static_cast<std::size_t>(count) > names.size() / kNameBytes)
    return tl::unexpected(
        fmt::format("PNAMES is cut short: {} names do not fit in {} bytes", count, bytes.size()));
  return names.first(static_cast<std::size_t>(count) * kNameBytes);
}

}  // namespace

tl::expected<Pictures, std::string> Pictures::read(const Wad& wad) {
  const auto palette = readPalette(wad);
  if (!palette) return tl::unexpected(palette.error());
  auto walls = readWallTextures(wad);
  if (!walls) return tl::unexpected(std::move(walls.error()));
  const auto patchNames = readPatchNames(wad);
  if (!patchNames) return tl::unexpected(patchNames.error());
  return Pictures(wad, *palette, std::move(*walls), *patchNames);
}

// Flats lie between markers, lumps without bytes. Those of extensions begin with FF_START, which
// may be closed by either end. Markers between them, such as F1_START, part the flats of episodes.
Pictures::Pictures(const Wad& wad, const Palette& palette, WallTextures walls, Bytes patchNames)
    : palette_(palette), walls_(std::move(walls)), patchNames_(patchNames), sprites_(wad) {
  int depth = 0;
  for (const auto& [name, bytes] : wad.lumps()) {
    if (name == "F_START" || name == "FF_START") {
      ++depth;
    } else if (name == "F_END" || name == "FF_END") {
      depth = std::max(0, depth - 1);
    } else if (depth == 0) {
      patches_[name] = bytes;
    } else if (!name.ends_with("_START") && !name.ends_with("_END")) {
      flats_[name] = bytes;
    }
  }
}

std::optional<ImageSize> Pictures::sizeOfWall(const std::string& name) const {
  const auto found = walls_.find(name);
  if (found == walls_.end() || !found->second) return std::nullopt;
  return found->second->size();
}

tl::expected<Picture, std::string> Pictures::wall(const std::string& name) const {
  const auto found = walls_.find(name);
  if (found == walls_.end())
    return tl::unexpected(fmt::format("there is no wall texture {}", name));
  if (!found->second) return tl::unexpected(found->second.error());
  const WallTexture& texture = *found->second;
  const std::vector<int> patches = patchesByColumn(texture);
  Picture picture(texture.size(), palette_[0]);
  for (std::size_t i = 0; i < texture.countPlacements(); ++i)
    if (auto mistake = drawPlaced(texture.placement(i), patches, picture))
      picture.mistakes.push_back(fmt::format("wall texture {}: its patch {}{}", name, i, *mistake));
  return picture;
}

std::vector<int> Pictures::patchesByColumn(const WallTexture& texture) const {
  std::vector<int> counts(static_cast<std::size_t>(texture.size().width), 0);
  for (std::size_t i = 0; i < texture.countPlacements(); ++i) {
    const WallTexture::Placement placed = texture.placement(i);
    const auto patch = patchOf(placed);
    const int end =
        patch ? std::min(placed.left + widthOfPatch(patch->bytes), texture.size().width) : 0;
    for (int x = std::max(placed.left, 0); x < end; ++x) ++counts[static_cast<std::size_t>(x)];
  }
  return counts;
}

/// The mistake says what is wrong with the patch, to follow its number.
tl::expected<Pictures::Patch, std::string> Pictures::patchOf(
    const WallTexture::Placement& placed) const {
  const std::size_t count = patchNames_.size() / kNameBytes;
  if (placed.patch < 0 || static_cast<std::size_t>(placed.patch) >= count)
    return tl::unexpected(fmt::format(" has number {}: PNAMES has {} names", placed.patch, count));
  const std::string name = nameAt(patchNames_, static_cast<std::size_t>(placed.patch) * kNameBytes);
  const auto found = patches_.find(name);
  if (found == patches_.end()) return tl::unexpected(fmt::format(", {}, is missing", name));
  return Patch{name, found->second};
}

/// As in Doom, a patch that is alone in a column is at the top there, wherever it is placed.
std::optional<std::string> Pictures::drawPlaced(const WallTexture::Placement& placed,
                                                const std::vector<int>& patches,
                                                Picture& picture) const {
  const auto patch = patchOf(placed);
  if (!patch) return patch.error();
  std::vector<int> tops;
  for (const int count : patches) tops.push_back(count > 1 ? placed.top : 0);
  const auto mistake = drawPatch(patch->bytes, placed.left, tops, palette_, picture);
  if (!mistake) return std::nullopt;
  return fmt::format(", {}, {}", patch->name, *mistake);
}

tl::expected<Picture, std::string> Pictures::flat(const std::string& name) const {
  const auto found = flats_.find(name);
  if (found == flats_.end()) return tl::unexpected(fmt::format("there is no flat {}", name));
  const Bytes pixels = found->second;
  if (pixels.size() < kFlatBytes)
    return tl::unexpected(
        fmt::format("flat {} has {} bytes: {} are needed", name, pixels.size(), kFlatBytes));
  Picture picture({kFlatPixels, kFlatPixels}, palette_[0]);
  std::size_t i = 0;
  for (int y = 0; y < kFlatPixels; ++y)
    for (int x = 0; x < kFlatPixels; ++x) picture.draw(x, y, palette_[pixels[i++]]);
  return picture;
}

}  // namespace hearth::doom
