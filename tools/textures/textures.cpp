#include "textures/textures.h"

namespace hearth::textures {

std::vector<Texture> makeAll() {
  return {{"ashlar", makeAshlar()},   {"beam", makeBeam()},     {"brick", makeBrick()},
          {"carpet", makeCarpet()},   {"cobble", makeCobble()}, {"dirt", makeDirt()},
          {"glass", makeGlass()},     {"grass", makeGrass()},   {"grate", makeGrate()},
          {"iron", makeIron()},       {"marble", makeMarble()}, {"mossy", makeMossy()},
          {"plaster", makePlaster()}, {"roof", makeRoof()},     {"sky", makeSky()},
          {"slate", makeSlate()},     {"stone", makeStone()},   {"water", makeWater()},
          {"wood", makeWood()}};
}

}  // namespace hearth::textures
