#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <unordered_map>
#include <vector>

#include "import/doom/palette.h"
#include "import/doom/picture.h"
#include "import/doom/sprite_lumps.h"
#include "import/doom/wad.h"
#include "import/doom/wall_textures.h"

namespace hearth::doom {

/// A side of a flat, in pixels.
inline constexpr int kFlatPixels = 64;

/// The pictures of a WAD's walls, flats and sprites, decoded when they are asked for. All names are
/// in upper case, as `nameAt` has them. The WAD must stay alive; it may be moved.
class Pictures {
 public:
  /// Errors are one sentence that begins with the lump. A WAD without textures or flats is none.
  static tl::expected<Pictures, std::string> read(const Wad& wad);

  /// Whether there is a definition, be it one that `wall` refuses.
  bool hasWall(const std::string& name) const { return walls_.contains(name); }
  /// None where there is no such texture, or only one that `wall` refuses.
  std::optional<ImageSize> sizeOfWall(const std::string& name) const;
  /// Pixels that no patch covers are holes, and have colour 0 of the palette: black, in the games.
  /// A patch that is missing or broken is a mistake of the picture and takes nothing of the others.
  /// An error is one sentence that names the texture.
  tl::expected<Picture, std::string> wall(const std::string& name) const;

  bool hasFlat(const std::string& name) const { return flats_.contains(name); }
  /// What floors and ceilings wear: 64 rows of 64 pixels (https://doomwiki.org/wiki/Flat). Of
  /// longer lumps, which other games have, the first 64 rows. Flats have no holes.
  tl::expected<Picture, std::string> flat(const std::string& name) const;

  const SpriteLumps& sprites() const { return sprites_; }
  const Palette& palette() const { return palette_; }

  /// All there are, in no order.
  const WallTextures& walls() const { return walls_; }
  const std::unordered_map<std::string, Bytes>& flats() const { return flats_; }

 private:
  Pictures(const Wad& wad, const Palette& palette, WallTextures walls, Bytes patchNames);
  struct Patch {
    std::string name;
    Bytes bytes;
  };
  tl::expected<Patch, std::string> patchOf(const WallTexture::Placement& placed) const;
  /// How many patches of a texture each of its columns has.
  std::vector<int> patchesByColumn(const WallTexture& texture) const;
  std::optional<std::string> drawPlaced(const WallTexture::Placement& placed,
                                        const std::vector<int>& patches, Picture& picture) const;

  Palette palette_;
  WallTextures walls_;
  Bytes patchNames_;  ///< eight bytes each
  std::unordered_map<std::string, Bytes> flats_;
  std::unordered_map<std::string, Bytes> patches_;  ///< and all other lumps that are no flats
  SpriteLumps sprites_;
};

}  // namespace hearth::doom
