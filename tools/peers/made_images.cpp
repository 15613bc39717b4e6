#include "peers/made_images.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "image/image_file.h"

namespace hearth {

namespace {

constexpr int kWavesSize = 256;
constexpr int kDiscSize = 64;
constexpr int kHolePitch = 16;  ///< pixels between the centres of holes
constexpr double kHoleRadius = 4;

Rgb shaded(Rgb color, Rgb by) {
  const auto product = [](int a, int b) { return static_cast<std::uint8_t>(a * b / 255); };
  return {product(color.r, by.r), product(color.g, by.g), product(color.b, by.b)};
}

/// Of a wave, -1..1.
std::uint8_t shade(double wave) { return static_cast<std::uint8_t>(std::lround(191 + 64 * wave)); }

double distanceTo(double center, int x, int y) {
  return std::hypot(x + 0.5 - center, y + 0.5 - center);
}

/// With so many waves across and down.
Image wavesImage(int across, int down, Rgb color) {
  constexpr double kTurn = 2 * std::numbers::pi / kWavesSize;
  Image image(kWavesSize, kWavesSize);
  for (int y = 0; y < kWavesSize; ++y)
    for (int x = 0; x < kWavesSize; ++x) {
      const double u = std::sin(kTurn * across * x);
      const double v = std::sin(kTurn * down * y);
      image.at(x, y) = shaded(color, {shade(u), shade(v), shade(u * v)});
    }
  return image;
}

Image discImage(Rgb color) {
  Image image(kDiscSize, kDiscSize, color);
  for (int y = 0; y < kDiscSize; ++y)
    for (int x = 0; x < kDiscSize; ++x) {
      const double fromCenter = distanceTo(kDiscSize / 2.0, x, y);
      image.at(x, y) = shaded(color, {255, shade(-fromCenter / kDiscSize), 255});
      if (fromCenter > kDiscSize / 2.0 ||
          distanceTo(kHolePitch / 2.0, x % kHolePitch, y % kHolePitch) < kHoleRadius)
        image.makeHole(x, y);
    }
  return image;
}

}  // namespace

tl::expected<void, std::string> writeImages(const std::filesystem::path& folder) {
  create_directories(folder);
  for (const auto& [name, image] : {std::pair{"paint.png", wavesImage(2, 3, {255, 200, 120})},
                                    std::pair{"plaster.png", wavesImage(3, 1, {150, 220, 255})},
                                    std::pair{"disc.png", discImage({255, 80, 60})}})
    if (auto written = writePng(folder / name, image); !written) return written;
  return {};
}

}  // namespace hearth
