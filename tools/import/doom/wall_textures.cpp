#include "import/doom/wall_textures.h"

#include <fmt/format.h>

#include <optional>

#include "import/doom/picture.h"

namespace hearth::doom {

namespace {

constexpr std::size_t kCount = 4;
constexpr std::size_t kOffset = 4;
constexpr std::size_t kTextureHeader = 22;
constexpr std::size_t kPlacement = 10;

/// Of one lump: the largest games have about a thousand.
constexpr std::int64_t kMaxTextures = 1 << 16;

/// Columns of patches in one texture, counting each patch as wide as the texture: six times as many
/// as in any of Freedoom's. It bounds the time that broken ones take, to some seconds.
constexpr std::int64_t kMaxColumns = 1 << 16;

/// `bytes` begin with the header.
tl::expected<WallTexture, std::string> readDefinition(Bytes bytes) {
  const auto refused = [&](const std::string& why) {
    return tl::unexpected(fmt::format("wall texture {} {}", nameAt(bytes, 0), why));
  };
  const ImageSize size{int16At(bytes, 12), int16At(bytes, 14)};
  if (size.width < 1 || size.height < 1 || size.width > kMaxSide || size.height > kMaxSide)
    return refused(fmt::format("has a side of {} x {} pixels that is not within 1..{}", size.width,
                               size.height, kMaxSide));
  const std::int64_t count = int16At(bytes, 20);
  const Bytes rest = bytes.subspan(kTextureHeader);
  if (count < 0 || static_cast<std::size_t>(count) > rest.size() / kPlacement)
    return refused(
        fmt::format("is cut short: its {} patches do not fit in {} bytes", count, rest.size()));
  if (count * size.width > kMaxColumns)
    return refused(
        fmt::format("has too many patches: {} for a width of {} pixels", count, size.width));
  return WallTexture(size, rest.first(static_cast<std::size_t>(count) * kPlacement));
}

/// Adds the definitions of a lump. Returns what is wrong with it as a whole.
std::optional<std::string> addDefinitions(Bytes lump, WallTextures& textures) {
  if (lump.size() < kCount) return "is cut short: it has no count";
  const std::int64_t count = int32At(lump, 0);
  const auto size = static_cast<std::int64_t>(lump.size());
  if (count < 0 ||
      static_cast<std::int64_t>(kCount) + count * static_cast<std::int64_t>(kOffset) > size)
    return fmt::format("is cut short: {} textures do not fit in {} bytes", count, size);
  if (count > kMaxTextures)
    return fmt::format("has {} textures, more than {}", count, kMaxTextures);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t begin = int32At(lump, kCount + static_cast<std::size_t>(i) * kOffset);
    if (begin < 0 || begin + static_cast<std::int64_t>(kTextureHeader) > size)
      return fmt::format("has texture {} at byte {} of {}", i, begin, size);
    const Bytes definition = lump.subspan(static_cast<std::size_t>(begin));
    textures.try_emplace(nameAt(definition, 0), readDefinition(definition));
  }
  return std::nullopt;
}

}  // namespace

std::size_t WallTexture::countPlacements() const { return placements_.size() / kPlacement; }

WallTexture::Placement WallTexture::placement(std::size_t i) const {
  const Bytes bytes = placements_.subspan(i * kPlacement, kPlacement);
  return {int16At(bytes, 0), int16At(bytes, 2), int16At(bytes, 4)};
}

tl::expected<WallTextures, std::string> readWallTextures(const Wad& wad) {
  WallTextures textures;
  for (const char* name : {"TEXTURE1", "TEXTURE2"}) {
    const auto found = wad.find(name);
    if (!found) continue;
    if (auto mistake = addDefinitions(wad.lumps()[*found].bytes, textures))
      return tl::unexpected(fmt::format("{} {}", name, *mistake));
  }
  return textures;
}

}  // namespace hearth::doom
