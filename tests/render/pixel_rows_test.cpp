// Pictures drawn straight into memory of others.

#include "image/pixel_rows.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "load/load.h"
#include "render/renderer.h"
#include "support/in_tree.h"
#include "support/padded_rows.h"

namespace hearth {
namespace {

using test::kUntouched;
using test::PaddedRows;

void expectTheSame(const Image& expected, const PaddedRows& memory) {
  int different = 0;
  for (int y = 0; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x)
      if (fromXrgb(*memory.rows.at(x, y)) != expected.at(x, y)) ++different;
    for (int x = expected.width(); x < expected.width() + PaddedRows::kPadding; ++x)
      if (*memory.rows.at(x, y) != kUntouched) ++different;
  }
  EXPECT_EQ(different, 0) << expected.width() << 'x' << expected.height();
}

TEST(PixelRows, HaveThePixelsOfAnImageAndNoOthersAreWritten) {
  const LoadedLevel loaded = loadLevel(test::inTree("levels/tutorial.json")).loaded.value();
  BakeSettings coarse = loaded.level.bake;
  coarse.texel = 0.5;
  const BakedLight light = bake(loaded.scene(), coarse, 2);
  Camera camera = cameraOf(loaded.level.shots.front());
  for (const int pixelSize : {1, 3}) {
    DrawSettings settings;
    settings.pixelSize = pixelSize;
    const Renderer renderer(loaded.scene(), loaded.textures, light, settings);
    for (const auto& [width, height] : {std::pair(64, 40), {67, 43}, {5, 3}}) {
      camera.width = width;
      camera.height = height;
      FrameScratch scratch;
      Workers workers(2);
      PaddedRows memory(width, height);
      renderer.draw(camera, LightMode::Both, scratch, memory.rows, &workers);
      expectTheSame(renderer.draw(camera, LightMode::Both), memory);
    }
  }
}

}  // namespace
}  // namespace hearth
