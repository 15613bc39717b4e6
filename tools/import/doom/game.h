#pragma once

#include "import/doom/map.h"

namespace hearth::doom {

inline constexpr int kMinSkill = 1;
inline constexpr int kMaxSkill = 5;

/// The game in which a map is played. Its things may be there in some games only.
struct Game {
  int skill = 3;  ///< 1, the easiest, to 5
  bool isMultiplayer = false;
};

/// By the flags of a thing (https://doomwiki.org/wiki/Thing): 1 for skills 1 and 2, 2 for skill 3,
/// 4 for skills 4 and 5, and 16 if it is there in multiplayer games only.
bool isThere(const Thing& thing, const Game& game);

}  // namespace hearth::doom
