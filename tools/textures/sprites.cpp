#include "textures/sprites.h"

#include <string>

namespace hearth::textures {

std::vector<Texture> makeSprites() {
  std::vector<Texture> all{
      {"chain", makeChain()}, {"gonfalon", makeGonfalon()}, {"straw", makeStraw()}};
  for (int frame = 0; frame < kFlameFrames; ++frame)
    all.push_back({"flame-" + std::to_string(frame + 1), makeFlame(frame)});
  for (int frame = 0; frame < kCandleFlameFrames; ++frame)
    all.push_back({"candle-" + std::to_string(frame + 1), makeCandleFlame(frame)});
  return all;
}

}  // namespace hearth::textures
