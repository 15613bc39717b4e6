#include "as_truth.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "truth/truth_view.h"

namespace hearth::extremes {

namespace {

constexpr double kEdgePx = 0.02;  ///< pixels so near to an edge may show either side

Shot shotOf(const Camera& camera) {
  return {"",           camera.sector, camera.eye,   camera.angle,
          camera.pitch, camera.fov,    camera.width, camera.height};
}

std::string describe(const LoadedLevel& loaded, const Camera& camera) {
  return fmt::format("{}x{} at {},{},{} in {} angle {} pitch {} fov {}", camera.width,
                     camera.height, camera.eye.x, camera.eye.y, camera.eye.z,
                     loaded.level[camera.sector].name, camera.angle, camera.pitch, camera.fov);
}

}  // namespace

BakedLight noLightOf(const Level& level) {
  BakedLight light;
  light.surfaces.resize(level.surfaces.size());
  light.lightmaps.resize(level.surfaces.size());
  return light;
}

int holesIn(const LoadedLevel& loaded, const Camera& camera) {
  const BakedLight light = noLightOf(loaded.level);
  const Image drawn =
      Renderer(loaded.scene(), loaded.textures, light).draw(camera, Channel::Overdraw);
  return static_cast<int>(std::ranges::count(drawn.pixels(), kHole));
}

void expectAsTruth(const LoadedLevel& loaded, const Camera& camera, int stride) {
  EXPECT_EQ(holesIn(loaded, camera), 0) << describe(loaded, camera);
  const BakedLight light = noLightOf(loaded.level);
  const Image drawn =
      Renderer(loaded.scene(), loaded.textures, light).draw(camera, LightMode::None);
  const TruthView truth(loaded.level, loaded.textures, shotOf(camera));
  for (int pixel = 0; pixel < camera.width * camera.height; pixel += stride) {
    const int i = pixel % camera.width;
    const int j = pixel / camera.width;
    const Rgb expected = truth.pixel(i + 0.5, j + 0.5, TruthLightMode::None).color;
    const Rgb actual = drawn.at(i, j);
    ASSERT_TRUE(actual == expected || !truth.isClear(i + 0.5, j + 0.5, kEdgePx))
        << fmt::format("pixel {},{} is {},{},{} instead of {},{},{}: {}", i, j, actual.r, actual.g,
                       actual.b, expected.r, expected.g, expected.b, describe(loaded, camera));
  }
}

}  // namespace hearth::extremes
