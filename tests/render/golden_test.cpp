// Views of the renderer's own numbers that were looked at and kept. The same bytes must come out of
// every build. (The shots of the tutorial are held by `hearth check`: see tests/tools.)
//
// After a change that is meant to be seen, look at the new pictures and keep them with
//   HEARTH_UPDATE_GOLDENS=1 build/release/tests/render/test_render --gtest_filter='Golden*'

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "image/compare.h"
#include "image/image_file.h"
#include "load/load.h"
#include "render/renderer.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

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
