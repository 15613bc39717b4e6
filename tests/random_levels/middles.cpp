#include "random_levels/middles.h"

#include "random_levels/random_level.h"
#include "random_levels/texture_uses.h"

namespace hearth::random_levels {
namespace {

/// Most of them have holes, and most hang where something of them shows.
TextureUse middleTexture(Random& random, const Sector& sector) {
  TextureUse use = wallTexture(random);
  if (random.chance(0.8)) use.name = random.pickFrom(kRandomLevelMiddles).name;
  use.isObject = true;
  if (use.zref) use.zref = metres(sector.floor.z) + random.real(0, 1.2) * metres(sector.height());
  return use;
}

}  // namespace

void hangMiddles(Random& random, Model& model, double fraction) {
  for (Sector& sector : model.sectors)
    for (Loop& loop : sector.loops) {
      if (loop.hasOneWall) continue;
      for (Wall& wall : loop.walls)
        for (Piece& piece : wall.pieces)
          if (auto* portal = std::get_if<PortalPiece>(&piece.kind))
            if (random.chance(fraction)) portal->maskedMiddle = middleTexture(random, sector);
    }
}

}  // namespace hearth::random_levels
