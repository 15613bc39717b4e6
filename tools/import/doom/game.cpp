#include "import/doom/game.h"

namespace hearth::doom {

bool isThere(const Thing& thing, const Game& game) {
  constexpr unsigned kMultiplayerOnly = 0x10;
  const unsigned ofSkill = game.skill < 3 ? 1 : game.skill == 3 ? 2 : 4;
  return (thing.flags & ofSkill) != 0 &&
         (game.isMultiplayer || (thing.flags & kMultiplayerOnly) == 0);
}

}  // namespace hearth::doom
