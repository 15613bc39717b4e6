#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>

#include "import/doom/wad.h"

namespace hearth::doom {

/// A frame of a sprite as seen from one side: a patch, or its mirror image.
struct SpriteSide {
  std::string lump;  ///< name
  Bytes patch;
  bool isMirrored = false;
};

/// Doom's rotations 1 to 8: seen from where the front faces, and from an eighth of a turn further
/// to the thing's left each. None where the WAD has no image.
using SpriteSides = std::array<std::optional<SpriteSide>, 8>;

/// Whether a frame looks alike from all sides.
bool isSameFromAllSides(const SpriteSides& sides);

/// The images of a WAD's sprites: lumps between S_START and S_END, or SS_START and SS_END in
/// extensions. Their names consist of four letters for the sprite, one for the frame, and a digit
/// for the rotation, with 0 for all of them. A second letter and digit may follow, for another
/// rotation or frame that shows the mirror image (https://doomwiki.org/wiki/Sprite). A later lump
/// replaces an earlier one side by side. The WAD must stay alive; it may be moved.
class SpriteLumps {
 public:
  explicit SpriteLumps(const Wad& wad);

  /// Null if there is no lump of the frame; it is named by the letters of sprite and frame.
  const SpriteSides* find(const std::string& frame) const;

 private:
  void add(const Wad::Lump& lump, std::size_t at, bool isMirrored);

  std::unordered_map<std::string, SpriteSides> frames_;
};

}  // namespace hearth::doom
