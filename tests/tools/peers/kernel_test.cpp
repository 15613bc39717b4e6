// That the kernel which frames are measured against does what a frame does.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "loaded.h"
#include "peers/kernel_frames.h"

namespace hearth {
namespace {

constexpr ImageSize kSize{320, 200};
constexpr Pixel kUntouched = 0xFF000000;  // no drawn pixel has these bits

int difference(Pixel pixel, Rgb color) {
  const Rgb drawn = colorOf(pixel);
  return std::abs(drawn.r - color.r) + std::abs(drawn.g - color.g) + std::abs(drawn.b - color.b);
}

class KernelOfTheTutorial : public testing::Test {
 protected:
  PeerLevel level_{loaded("levels/tutorial.json")};
  KernelFrames kernel_{level_, kSize};
};

TEST_F(KernelOfTheTutorial, HasEveryPixelOfEachFrameOnce) {
  for (const KernelFrame& frame : kernel_.frames()) {
    std::vector<Pixel> drawn(frame.width * frame.height);
    for (const KernelSpan& span : frame.spans)
      for (std::size_t row = span.rowBegin; row < span.rowEnd; ++row)
        ++drawn[row * frame.width + span.column];
    EXPECT_EQ(std::ranges::count(drawn, 1U), std::ssize(drawn));
  }
}

TEST_F(KernelOfTheTutorial, DrawsNearlyTheSameColors) {
  const std::vector<Camera> cameras = camerasOf(level_.loaded.level);
  ASSERT_EQ(kernel_.frames().size(), cameras.size());
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    Camera camera = cameras[i];
    camera.width = kSize.width;
    camera.height = kSize.height;
    const Image picture = level_.renderer.draw(camera, LightMode::Both);
    std::vector<Pixel> strip;
    std::vector<Pixel> pixels(picture.pixels().size(), kUntouched);
    drawKernelFrame(kernel_.frames()[i], strip, pixels);
    EXPECT_EQ(std::ranges::count(pixels, kUntouched), 0);
    double sum = 0;
    for (std::size_t k = 0; k < pixels.size(); ++k)
      sum += difference(pixels[k], picture.pixels()[k]);
    EXPECT_LT(sum / (3 * static_cast<double>(pixels.size())), 0.5) << "levels, shot " << i;
  }
}

}  // namespace
}  // namespace hearth
