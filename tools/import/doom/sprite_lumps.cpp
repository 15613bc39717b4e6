#include "import/doom/sprite_lumps.h"

#include <algorithm>

namespace hearth::doom {

namespace {

constexpr std::size_t kSpriteName = 4;  // letters
constexpr std::size_t kOneSide = 6;     // letters of a lump's name for one frame and rotation, ...
constexpr std::size_t kTwoSides = 8;    // ... and for two

}  // namespace

bool isSameFromAllSides(const SpriteSides& sides) {
  return std::ranges::all_of(sides, [&](const auto& side) {
    return side && sides.front() && side->patch.data() == sides.front()->patch.data() &&
           side->isMirrored == sides.front()->isMirrored;
  });
}

SpriteLumps::SpriteLumps(const Wad& wad) {
  bool isInside = false;
  for (const Wad::Lump& lump : wad.lumps()) {
    if (lump.name == "S_START" || lump.name == "SS_START") {
      isInside = true;
    } else if (lump.name == "S_END" || lump.name == "SS_END") {
      isInside = false;
    } else if (isInside) {
      if (lump.name.size() == kOneSide || lump.name.size() == kTwoSides)
        add(lump, kSpriteName, false);
      if (lump.name.size() == kTwoSides) add(lump, kOneSide, true);
    }
  }
}

/// `at` is where the letter of the frame is in the lump's name.
void SpriteLumps::add(const Wad::Lump& lump, std::size_t at, bool isMirrored) {
  const char rotation = lump.name[at + 1];
  if (rotation < '0' || rotation > '8') return;
  SpriteSides& sides = frames_[lump.name.substr(0, kSpriteName) + lump.name[at]];
  const SpriteSide side{lump.name, lump.bytes, isMirrored};
  if (rotation == '0')
    sides.fill(side);
  else
    sides[static_cast<std::size_t>(rotation - '1')] = side;
}

const SpriteSides* SpriteLumps::find(const std::string& frame) const {
  const auto found = frames_.find(frame);
  return found == frames_.end() ? nullptr : &found->second;
}

}  // namespace hearth::doom
