#include "textures/paint.h"

#include <algorithm>

namespace hearth::textures {
namespace {

constexpr int kSteps = 12;
constexpr std::array<std::array<int, 4>, 4> kBayer{
    {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};

}  // namespace

Rgb shade(const Ramp& ramp, int tone, int x, int y) {
  const auto threshold = kBayer[static_cast<std::size_t>(y & 3)][static_cast<std::size_t>(x & 3)];
  // Dithering over the middle half of a step only, so that flat tones stay flat.
  const int scaled = std::clamp(tone, 0, 255) * kSteps * 16 / 255;
  const int step = std::min(kSteps, (scaled + 4 + threshold / 2) / 16);
  const int position = step * (static_cast<int>(ramp.size()) - 1) * 256 / kSteps;
  const auto stop = std::min(static_cast<std::size_t>(position / 256), ramp.size() - 2);
  return blend(ramp[stop], ramp[stop + 1], position - static_cast<int>(stop) * 256);
}

Rgb blend(Rgb a, Rgb b, int weight256) {
  const auto mix = [weight256](int from, int to) {
    return static_cast<std::uint8_t>((from * (256 - weight256) + to * weight256 + 128) / 256);
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

int edgeDistance(BlockPixel pixel) {
  return std::min({pixel.x, pixel.y, pixel.width - 1 - pixel.x, pixel.height - 1 - pixel.y});
}

int bevel(BlockPixel pixel, int strength) {
  const int fromLight = std::min(pixel.x, pixel.y);
  const int fromShade = std::min(pixel.width - 1 - pixel.x, pixel.height - 1 - pixel.y);
  if (fromShade == 0) return -strength;
  if (fromLight == 0) return strength;
  if (fromShade == 1) return -strength / 2;
  if (fromLight == 1) return strength / 2;
  return 0;
}

Image paintTile(Rgb (*pixelAt)(int x, int y), int height) {
  Image image(kTileSide, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < kTileSide; ++x) image.at(x, y) = pixelAt(x, y);
  }
  return image;
}

bool inCorner(BlockPixel pixel) {
  const int x = std::min(pixel.x, pixel.width - 1 - pixel.x);
  const int y = std::min(pixel.y, pixel.height - 1 - pixel.y);
  return x + y < 1;
}

}  // namespace hearth::textures
