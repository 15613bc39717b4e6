#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/sprites.h"

namespace hearth::textures {
namespace {

constexpr Ramp kFire{
    {{132, 34, 16}, {206, 74, 20}, {244, 138, 32}, {255, 204, 84}, {255, 246, 196}}};

/// A flame that licks upwards. Noise drives it that moves up by one of its cells from frame to
/// frame, so that the last frame leads to the first.
struct Fire {
  int width;    ///< of the image, in pixels
  int height;   ///< likewise; a cell for each frame
  int cell;     ///< side of the cells of noise
  int foot;     ///< pixels from the flame's axis to its side, at the bottom
  int belly;    ///< where it is widest
  int bellyUp;  ///< pixels up to there
  int unrest;   ///< how much noise tears it, in percent
  std::uint32_t seed;
};

constexpr Fire kTorch{64, 96, 16, 9, 19, 22, 100, 231};
constexpr Fire kCandle{24, 48, 12, 3, 6, 12, 30, 241};

constexpr int kUnits = 16;  // of a pixel

/// Units from the axis to the side.
int reachAt(const Fire& fire, int up) {
  if (up < fire.bellyUp) return kUnits * (fire.foot + (fire.belly - fire.foot) * up / fire.bellyUp);
  const int t = 256 * (up - fire.bellyUp) / (fire.height - 4 - fire.bellyUp);
  return kUnits * fire.belly * (256 - t) / 256 * (384 + t) / 384;
}

/// 0 or less where there is no flame.
int heatAt(const Fire& fire, int x, int y, int frame) {
  const int up = fire.height - 1 - y;
  const int moving = y + fire.cell * frame;
  const Grain broad{fire.width, fire.height, fire.width, fire.cell};
  const Grain fine{fire.width, fire.height, fire.cell, fire.cell};
  const Grain finest{fire.width, fire.height, fire.cell / 2, fire.cell / 2};
  const int sway =
      kUnits * smoothNoise(0, moving, broad, fire.seed) * up / 160 * fire.belly / fire.height;
  const int aside = std::abs((2 * x - fire.width + 1) * kUnits / 2 - sway);
  const int tongues = 2 * smoothNoise(x, moving, fine, fire.seed + 1) +
                      smoothNoise(x, moving, finest, fire.seed + 2);
  const int unrest = std::min(fire.height / 4 + up, 3 * std::max(fire.height - 4 - up, 0));
  const int torn = tongues * fire.unrest / 300 * unrest / fire.height;
  return 256 / kUnits * (reachAt(fire, up) - aside) / fire.belly + torn;
}

Image flame(const Fire& fire, int frame) {
  Image image(fire.width, fire.height);
  for (int y = 0; y < fire.height; ++y)
    for (int x = 0; x < fire.width; ++x) {
      const int heat = heatAt(fire, x, y, frame);
      const int cooling = 90 * (fire.height - 1 - y) / fire.height;
      image.at(x, y) = shade(kFire, 56 + heat - cooling, x, y);
      const bool isRim = x == 0 || y == 0 || x == fire.width - 1;
      if (heat <= 0 || isRim) image.makeHole(x, y);
    }
  return image;
}

}  // namespace

Image makeFlame(int frame) { return flame(kTorch, frame); }

Image makeCandleFlame(int frame) { return flame(kCandle, frame); }

}  // namespace hearth::textures
