// Grids against the same sectors written out: the same levels, light and pictures, to the byte.

#include <gtest/gtest.h>

#include <stdexcept>

#include "light/saved_bake.h"
#include "load/load.h"
#include "random_grid.h"
#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "support/temporary_folder.h"

namespace hearth {
namespace {

LoadedLevel loaded(const std::filesystem::path& file) {
  LoadResult result = loadLevel(file);
  std::string errors;
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.isError) errors += format(diagnostic) + "\n";
  if (!result.loaded) throw std::runtime_error(errors);  // a failure of the test
  return *std::move(result.loaded);
}

void expectSameLevel(const Level& level, const Level& expected) {
  ASSERT_EQ(level.sectors.size(), expected.sectors.size());
  for (std::size_t i = 0; i < level.sectors.size(); ++i) {
    EXPECT_EQ(level.sectors[i].name, expected.sectors[i].name);
    EXPECT_EQ(level.sectors[i].loops.size(), expected.sectors[i].loops.size());
  }
  ASSERT_EQ(level.segments.size(), expected.segments.size());
  for (std::size_t i = 0; i < level.segments.size(); ++i) {
    EXPECT_EQ(level.segments[i].p0, expected.segments[i].p0);
    EXPECT_EQ(level.segments[i].p1, expected.segments[i].p1);
    EXPECT_EQ(level.segments[i].wallIndex, expected.segments[i].wallIndex);
  }
}

class RandomGrids : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    ASSERT_TRUE(writeRandomLevelTextures(folder().path() / "textures"));
  }
  static const test::TemporaryFolder& folder() {
    static const test::TemporaryFolder kFolder;
    return kFolder;
  }

  static void expectAsWrittenOut(std::uint64_t seed) {
    SCOPED_TRACE(seed);
    const test::GridLevel texts = test::gridLevel(test::makeRandomGrid(seed), seed);
    SCOPED_TRACE(texts.withGrid);
    folder().write("grid.lights.json", texts.lights);
    folder().write("written.lights.json", texts.lights);
    const std::string textures = "{\"textures\": \"textures\", ";
    const LoadedLevel grid =
        loaded(folder().write("grid.json", textures + texts.withGrid.substr(1)));
    const LoadedLevel written =
        loaded(folder().write("written.json", textures + texts.writtenOut.substr(1)));
    expectSameLevel(grid.level, written.level);
    const BakedLight gridLight = bake(grid.scene(), grid.level.bake, 1);
    const BakedLight writtenLight = bake(written.scene(), written.level.bake, 1);
    EXPECT_EQ(encodeBake(grid.scene(), gridLight, grid.level.bake.texel, ""),
              encodeBake(written.scene(), writtenLight, written.level.bake.texel, ""));
    const Renderer gridRenderer(grid.scene(), grid.textures, gridLight, {});
    const Renderer writtenRenderer(written.scene(), written.textures, writtenLight, {});
    for (std::size_t shot = 0; shot < grid.level.shots.size(); ++shot)
      EXPECT_EQ(
          gridRenderer.draw(cameraOf(grid.level.shots[shot]), LightMode::Both).pixels(),
          writtenRenderer.draw(cameraOf(written.level.shots[shot]), LightMode::Both).pixels());
  }
};

TEST_F(RandomGrids, AreTheSameAsTheirSectorsWrittenOut) {
  for (std::uint64_t seed = 0; seed < HEARTH_RANDOM_GRIDS; ++seed) {
    ASSERT_NO_FATAL_FAILURE(expectAsWrittenOut(seed));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace hearth
