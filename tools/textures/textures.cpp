#include "textures/textures.h"

namespace hearth::textures {

std::vector<Texture> makeAll() {
  return {{"brick", makeBrick()}, {"plaster", makePlaster()}, {"roof", makeRoof()},
          {"sky", makeSky()},     {"stone", makeStone()},     {"wood", makeWood()}};
}

}  // namespace hearth::textures
