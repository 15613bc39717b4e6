// Views of the renderer's own numbers that were looked at and kept. The same bytes must come out of
// every build. (The shots of the tutorial are held by `hearth check`: see tests/tools.)
//
// After a change that is meant to be seen, look at the new pictures and keep them with
//   HEARTH_UPDATE_GOLDENS=1 build/release/tests/render/test_render --gtest_filter='Golden*'

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "image/compare.h"
#include "image/image_file.h"
#include "load/load.h"
#include "render/renderer.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

constexpr double kRadians = 3.141592653589793 / 180;

class Golden : public testing::Test {
 protected:
  Golden()
      : loaded_(loadLevel(test::inTree("levels/tutorial.json")).loaded.value()),
        light_(bake(loaded_.scene(), loaded_.level.bake, 2)),
        renderer_(loaded_.scene(), loaded_.textures, light_) {}

  void expectGolden(const std::filesystem::path& file, const Image& drawn) const {
    if (std::getenv("HEARTH_UPDATE_GOLDENS")) {
      std::filesystem::create_directories(file.parent_path());
      ASSERT_TRUE(writePng(file, drawn));
      return;
    }
    const auto golden = readImage(file, 1 << 24);
    ASSERT_TRUE(golden) << golden.error();
    ASSERT_EQ(golden->width(), drawn.width());
    ASSERT_EQ(golden->height(), drawn.height());
    const PictureDifference difference = compare(*golden, drawn);
    if (difference.differing == 0) return;
    const auto actual = std::filesystem::path(testing::TempDir()) / file.filename();
    (void)writePng(actual, drawn);
    ADD_FAILURE() << fmt::format("{}: {} pixels differ, {} by more than 8; drawn: {}",
                                 file.string(), difference.differing, difference.over8,
                                 actual.string());
  }

  LoadedLevel loaded_;
  BakedLight light_;
  Renderer renderer_;
};

TEST_F(Golden, channelsAreAsKept) {
  constexpr std::pair<std::string_view, Channel> kChannels[] = {
      {"sector", Channel::Sector},    {"surface", Channel::Surface},
      {"depth", Channel::Depth},      {"uv", Channel::Uv},
      {"normal", Channel::Normal},    {"light", Channel::Light},
      {"overdraw", Channel::Overdraw}};
  const std::filesystem::path folder = test::inTree("tests/render/golden");
  for (const std::string_view name : {"arrival", "gallery", "cellar"})
    for (const Shot& shot : loaded_.level.shots)
      for (const auto& [channelName, channel] : kChannels) {
        if (shot.name != name) continue;
        Camera camera = cameraOf(shot);
        camera.width = 160;
        camera.height = 100;
        expectGolden(folder / fmt::format("{}-{}.png", name, channelName),
                     renderer_.draw(camera, channel));
      }
}

TEST_F(Golden, lightModesAreAsKept) {
  const std::filesystem::path folder = test::inTree("tests/render/golden");
  const Shot& shot = loaded_.level.shots.front();
  expectGolden(folder / "arrival-none.png", renderer_.draw(cameraOf(shot), LightMode::None));
  expectGolden(folder / "arrival-only.png", renderer_.draw(cameraOf(shot), LightMode::Only));
}

/// Column by column, each in the middle of a narrow picture: as casters of grids do, which turn by
/// the same angle from column to column, and correct the depth by its cosine.
Image drawnAtEvenAngles(const Renderer& renderer, const Camera& camera) {
  constexpr int kNarrow = 5;
  const double distancePx = camera.width / 2.0 / std::tan(camera.fov / 2 * kRadians);
  Image picture(camera.width, camera.height);
  for (int column = 0; column < camera.width; ++column) {
    const double angle = ((column + 0.5) / camera.width - 0.5) * camera.fov;
    Camera narrow = camera;
    narrow.width = kNarrow;
    narrow.angle += angle;
    narrow.fov = 2 * std::atan(kNarrow / 2.0 * std::cos(angle * kRadians) / distancePx) / kRadians;
    const Image drawn = renderer.draw(narrow, LightMode::None);
    for (int row = 0; row < camera.height; ++row)
      picture.at(column, row) = drawn.at(kNarrow / 2, row);
  }
  return picture;
}

/// Why Hearth sends its rays through the columns: engine/PERFORMANCE.md shows the picture.
TEST_F(Golden, raysAtEvenAnglesBendStraightWalls) {
  LoadedLevel maze = loadLevel(test::inTree("levels/maze.json")).loaded.value();
  maze.level.lights.clear();
  const BakedLight dark = bake(maze.scene(), maze.level.bake, 1);
  const Renderer renderer(maze.scene(), maze.textures, dark);
  Camera camera = cameraOf(maze.level.shots.front());
  camera.eye = {3, 3.2, 1.6};  // before the corner of a passage
  camera.angle = 40;
  camera.pitch = 0;
  const Image straight = renderer.draw(camera, LightMode::None);
  const Image bent = drawnAtEvenAngles(renderer, camera);
  constexpr int kGap = 8;
  Image both(2 * camera.width + kGap, camera.height, {255, 255, 255});
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      both.at(column, row) = straight.at(column, row);
      both.at(column + camera.width + kGap, row) = bent.at(column, row);
    }
  expectGolden(test::inTree("engine/even-angles.png"), both);
}

TEST_F(Golden, threadsDrawWhatOneDraws) {
  FrameScratch scratch;
  PixelBuffer memory;
  for (const Shot& shot : loaded_.level.shots)
    for (const int threads : {2, 7}) {
      const Camera camera = cameraOf(shot);
      const PixelRows picture = memory.rows(camera.width, camera.height);
      Workers workers(threads);
      renderer_.draw(camera, LightMode::Both, scratch, picture, &workers);
      EXPECT_EQ(imageOf(picture), renderer_.draw(camera, LightMode::Both)) << shot.name;
    }
}

TEST_F(Golden, twoThreadsAndSevenBakeTheSame) {
  for (const int threads : {1, 7}) {
    const BakedLight again = bake(loaded_.scene(), loaded_.level.bake, threads);
    for (std::size_t i = 0; i < light_.lightmaps.size(); ++i) {
      ASSERT_EQ(again.lightmaps[i].has_value(), light_.lightmaps[i].has_value());
      if (again.lightmaps[i]) {
        EXPECT_EQ(again.lightmaps[i]->levels, light_.lightmaps[i]->levels);
      }
    }
  }
}

}  // namespace
}  // namespace hearth
