#include "textures/textures.h"

#include <utility>

#include "textures/turn.h"

namespace hearth::textures {
namespace {

void addTurned(std::vector<Texture>& all) {
  all.push_back({"post", turned(makeBeam())});
  all.push_back({"roof-n", turned(turned(makeRoof()))});
  Image straight = makeSlate();
  Image aslant = diagonal(straight);
  all.push_back({"slate-se", aslant});
  for (const auto& [side, corner] : {std::pair{"w", "sw"}, {"n", "nw"}, {"e", "ne"}}) {
    straight = turned(straight);
    aslant = turned(aslant);
    all.push_back({std::string("slate-") + side, straight});
    all.push_back({std::string("slate-") + corner, aslant});
  }
}

}  // namespace

std::vector<Texture> makeAll() {
  std::vector<Texture> all{
      {"ashlar", makeAshlar()},     {"banner", makeBanner()},   {"beam", makeBeam()},
      {"brick", makeBrick()},       {"carpet", makeCarpet()},   {"cobble", makeCobble()},
      {"grille", makeGrille()},     {"dirt", makeDirt()},       {"door", makeDoor()},
      {"dressed", makeDressed()},   {"ember", makeEmber()},     {"glass", makeGlass()},
      {"grass", makeGrass()},       {"hay", makeHay()},         {"hewn", makeHewn()},
      {"iron", makeIron()},         {"marble", makeMarble()},   {"mossline", makeMossline()},
      {"mossy", makeMossy()},       {"plaster", makePlaster()}, {"roof", makeRoof()},
      {"sky", makeSky()},           {"slate", makeSlate()},     {"stone", makeStone()},
      {"tapestry", makeTapestry()}, {"water", makeWater()},     {"window", makeWindow()},
      {"wood", makeWood()}};
  addTurned(all);
  return all;
}

}  // namespace hearth::textures
