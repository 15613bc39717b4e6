// Marks and views of whole levels: drawn as lines, whatever the level.

#include "render/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "changes.h"
#include "lit_level.h"
#include "render/renderer.h"
#include "support/in_tree.h"

namespace hearth::extremes {
namespace {

constexpr View kViews[] = {View::World, View::Camera, View::DepthSpace, View::Screen,
                           View::Wireframe};

bool hasLineNear(const Image& lines, int x, int y) {
  for (int j = std::max(0, y - 1); j <= std::min(lines.height() - 1, y + 1); ++j)
    for (int i = std::max(0, x - 1); i <= std::min(lines.width() - 1, x + 1); ++i)
      if (lines.at(i, j) != Rgb{}) return true;
  return false;
}

/// Two ways to the same lines: where the surface changes from pixel to pixel an edge runs, which
/// the wireframe has from the level's vertices.
void expectOutlinesOnWireframe(const Renderer& renderer, const Scene& scene, const Camera& camera) {
  const Image lit = renderer.draw(camera, LightMode::Both);
  const Image outlines = renderer.draw(camera, Marks::Outlines);
  const Image wireframe = drawView(scene, camera, View::Wireframe);
  for (int y = 0; y < lit.height(); ++y)
    for (int x = 0; x < lit.width(); ++x)
      ASSERT_TRUE(outlines.at(x, y) == lit.at(x, y) || hasLineNear(wireframe, x, y))
          << scene.level().name << ' ' << x << ',' << y;
}

void expectQuietCoverage(const Renderer& renderer, const Camera& camera) {
  const Image coverage = renderer.draw(camera, Marks::Coverage);
  for (const Rgb signal : {kHole, Rgb{255, 0, 0}})
    EXPECT_EQ(std::ranges::count(coverage.pixels(), signal), 0);
}

void expectSaneViews(const Renderer& renderer, const Scene& scene) {
  for (const Shot& shot : scene.level().shots) {
    Camera camera = cameraOf(shot);
    expectOutlinesOnWireframe(renderer, scene, camera);
    expectQuietCoverage(renderer, camera);
    for (const double fov : {1.0, 179.0}) {
      camera.fov = fov;
      EXPECT_EQ(renderer.draw(camera, Marks::Texels).width(), camera.width);
      for (const View view : kViews) EXPECT_EQ(drawView(scene, camera, view).width(), camera.width);
    }
  }
}

TEST(ViewsOfShippedLevels, haveTheirOutlinesOnTheWireframe) {
  for (const std::string name : {"tutorial", "gaol", "keep"}) {
    const LoadedLevel loaded = loadLevel(test::inTree("levels/" + name + ".json")).loaded.value();
    BakeSettings coarse = loaded.level.bake;
    coarse.texel = 4;
    const BakedLight light = bake(loaded.scene(), coarse, 2);
    expectSaneViews(Renderer(loaded.scene(), loaded.textures, light), loaded.scene());
  }
}

TEST(ViewsOfRandomLevels, areSaneWhereverAndOfWhateverSize) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const LevelFiles files = randomFiles(seed);
    const std::vector<LevelFiles> family = {files,
                                            moved(files, {3e6, -3e6, 100}),
                                            scaled(files, 0x1p-10),
                                            turned(files, 37.3),
                                            mirrored(files),
                                            withWallsCut(files)};
    for (const LevelFiles& member : family) {
      const LitLevel lit(member);
      expectSaneViews(lit.renderer(), lit.scene());
    }
  }
}

}  // namespace
}  // namespace hearth::extremes
