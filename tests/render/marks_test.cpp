// What is marked on the lit picture: texels, outlines, pixels that are not drawn once.

#include "render/marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "light/bakery.h"
#include "load/load.h"
#include "render/renderer.h"
#include "render/segment_colors.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

/// A level with its light, on coarse texels where these do not matter.
class Lit {
 public:
  Lit(const std::string& path, double texel)
      : loaded_(loadLevel(test::inTree(path)).loaded.value()) {
    BakeSettings settings = loaded_.level.bake;
    settings.texel = texel;
    light_ = bake(loaded_.scene(), settings, 2);
  }

  const Level& level() const { return loaded_.level; }
  Renderer renderer(DrawSettings settings = {}) const {
    return {loaded_.scene(), loaded_.textures, light_, settings};
  }

 private:
  LoadedLevel loaded_;
  BakedLight light_;
};

/// In the hall of tests/levels/rooms.json, 4 m x 4 m, looking east at a wall 3 m ahead. With these
/// 200 columns and 90 degrees the picture plane is 100 pixels away.
Camera eastward(const Level& level) {
  return {level.player->sector, {1, 2, 1.5}, 0, 0, 90, 200, 120};
}

bool isNear(const Image& image, int x, int y, Rgb color) {
  for (int j = std::max(0, y - 1); j <= std::min(image.height() - 1, y + 1); ++j)
    for (int i = std::max(0, x - 1); i <= std::min(image.width() - 1, x + 1); ++i)
      if (image.at(i, j) == color) return true;
  return false;
}

int countOther(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) count += !(a.pixels()[i] == b.pixels()[i]);
  return count;
}

// --- Texels --------------------------------------------------------------------------------------

/// The pixels of a row that differ between two pictures, in [begin, end).
std::vector<int> differingIn(const Image& a, const Image& b, int row, int begin, int end) {
  std::vector<int> columns;
  for (int x = begin; x < end; ++x)
    if (!(a.at(x, row) == b.at(x, row))) columns.push_back(x);
  return columns;
}

TEST(MarkedTexels, HaveALineWhereTheNextOneBegins) {
  const Lit lit("tests/levels/rooms.json", 0.5);
  const Renderer renderer = lit.renderer();
  const Camera camera = eastward(lit.level());
  const Image plain = renderer.draw(camera, LightMode::Both);
  const Image grid = renderer.draw(camera, Marks::Texels);
  // The wall's north end, y from 0 to 1, is in columns 33.3 to 66.7; its texels are 16.7 wide.
  EXPECT_EQ(differingIn(plain, grid, 70, 36, 66), (std::vector<int>{50}));
}

TEST(MarkedTexels, AreMoreStronglyPartedAtEveryEighth) {
  const Lit lit("tests/levels/rooms.json", 0.125);
  const Renderer renderer = lit.renderer();
  Camera camera = eastward(lit.level());
  camera.width = 2000;
  camera.height = 8;
  camera.angle = 270;  // at a wall from x = 0 to 4, 2 m ahead: 62.5 pixels to a texel
  const Image plain = renderer.draw(camera, LightMode::Both);
  const Image grid = renderer.draw(camera, Marks::Texels);
  const auto strength = [&](int x) {
    int most = 0;
    for (int column = x - 2; column <= x + 2; ++column)
      most = std::max(most, grid.at(column, 2).b - plain.at(column, 2).b);
    return most;
  };
  // One metre to the right of the eye is 500 pixels; x = 2 is there. Row 4 would be that of z
  // = 1.5, a line of its own.
  EXPECT_GT(strength(1500), strength(1500 - 63));
  EXPECT_GT(strength(1500 - 63), 0);
  EXPECT_EQ(strength(1500 - 31), 0);
}

TEST(MarkedTexels, LeaveMostOfAPictureAsItIsHoweverSmallTheyAre) {
  for (const double texel : {0.25, 0.015625}) {
    const Lit lit("tests/levels/rooms.json", texel);
    const Renderer renderer = lit.renderer();
    const Camera camera = eastward(lit.level());
    const int marked =
        countOther(renderer.draw(camera, LightMode::Both), renderer.draw(camera, Marks::Texels));
    EXPECT_GT(marked, 0) << texel;
    EXPECT_LT(marked, camera.width * camera.height / 3) << texel;
  }
}

TEST(MarkedTexels, HaveNoLineWhereAnotherSurfaceBegins) {
  const Lit lit("levels/tutorial.json", 0.5);
  const Renderer renderer = lit.renderer();
  int corners = 0;
  for (const Shot& shot : lit.level().shots) {
    const Image plain = renderer.draw(cameraOf(shot), LightMode::Both);
    const Image surfaces = renderer.draw(cameraOf(shot), Channel::Surface);
    const Image grid = renderer.draw(cameraOf(shot), Marks::Texels);
    for (int y = 1; y < plain.height(); ++y)
      for (int x = 1; x < plain.width(); ++x) {
        const Rgb surface = surfaces.at(x, y);
        if (surface == surfaces.at(x - 1, y) || surface == surfaces.at(x, y - 1)) continue;
        ++corners;
        ASSERT_EQ(grid.at(x, y), plain.at(x, y)) << shot.name << ' ' << x << ',' << y;
      }
  }
  EXPECT_GT(corners, 100);
}

// --- Outlines ------------------------------------------------------------------------------------

class MarkedOutlines : public testing::Test {
 protected:
  Lit rooms_{"tests/levels/rooms.json", 0.5};
  Image image_ = rooms_.renderer().draw(eastward(rooms_.level()), Marks::Outlines);
};

TEST_F(MarkedOutlines, OfWallsAreWhite) {
  for (const int column : {40, 60, 140, 160})
    EXPECT_TRUE(isNear(image_, column, 110, kWallColor)) << column;
  for (const int row : {30, 60, 90}) EXPECT_TRUE(isNear(image_, 33, row, kWallColor)) << row;
}

TEST_F(MarkedOutlines, OfWallsBesideOpeningsAreWhiteAlongTheCeiling) {
  Camera camera = eastward(rooms_.level());
  camera.sector = SectorId(3);
  camera.eye = {2, 7.5, 2};
  camera.angle = 270;  // down the ramp, whose side walls end at the hall
  const Image image = rooms_.renderer().draw(camera, Marks::Outlines);
  for (const double depth : {2.2, 2.5, 2.8, 3.1})
    for (const double lateral : {-2.0, 2.0}) {
      const int x = static_cast<int>(100 + 100 * lateral / depth);
      const int y = static_cast<int>(60 - 100 / depth);
      EXPECT_TRUE(isNear(image, x, y, kWallColor)) << x << ' ' << y;
      EXPECT_FALSE(isNear(image, x, y, kWayOnColor)) << x << ' ' << y;
    }
}

TEST_F(MarkedOutlines, OfOpeningsAreOrangeAllRound) {
  EXPECT_TRUE(isNear(image_, 100, 77, kWayOnColor)) << "sill";
  for (const int column : {67, 133}) EXPECT_TRUE(isNear(image_, column, 60, kWayOnColor)) << column;
}

TEST_F(MarkedOutlines, OfFlatPortalsAreGreen) {
  for (const int column : {40, 60, 140, 160})
    EXPECT_TRUE(isNear(image_, column, 10, kFlatPortalColor)) << column;
}

TEST(MarkedOutlinesOfStacks, AreGreenBetweenTheirParts) {
  const LoadedLevel loaded = test::levelFrom(
      "{'light': 1, 'sectors': {" +
      test::sectorText(
          "a", "0,0, 4,0, 4,4, 0,4", 0, 3,
          "[{'texture': '#808080'}, {'walls': [{'z': 1, 'texture': '#404040'}, "
          "{'texture': '#808080'}]}, {'texture': '#808080'}, {'texture': '#808080'}]") +
      "}}");
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const Image image = Renderer(loaded.scene(), loaded.textures, light)
                          .draw({SectorId(0), {1, 2, 1.5}, 0, 0, 90, 200, 120}, Marks::Outlines);
  for (const int column : {40, 100, 160})
    EXPECT_TRUE(isNear(image, column, 77, kFlatPortalColor)) << column;
  EXPECT_TRUE(isNear(image, 100, 110, kWallColor)) << "nothing leads on there";
}

TEST(MarkedOutlinesOfLevels, LieExactlyWhereTheSurfaceChanges) {
  const Lit lit("levels/tutorial.json", 1);
  const Renderer renderer = lit.renderer();
  for (const Shot& shot : lit.level().shots) {
    const Image plain = renderer.draw(cameraOf(shot), LightMode::Both);
    const Image surfaces = renderer.draw(cameraOf(shot), Channel::Surface);
    const Image outlines = renderer.draw(cameraOf(shot), Marks::Outlines);
    const Image depths = renderer.draw(cameraOf(shot), Channel::Depth);
    const auto isParted = [&](int x, int y, int otherX, int otherY) {
      const bool areSky = depths.at(x, y) == Rgb{} && depths.at(otherX, otherY) == Rgb{};
      return !areSky && !(surfaces.at(x, y) == surfaces.at(otherX, otherY));
    };
    for (int y = 1; y < plain.height(); ++y)
      for (int x = 1; x < plain.width(); ++x)
        ASSERT_EQ(outlines.at(x, y) != plain.at(x, y),
                  isParted(x, y, x - 1, y) || isParted(x, y, x, y - 1))
            << shot.name << ' ' << x << ',' << y;
  }
}

// --- Coverage ------------------------------------------------------------------------------------

TEST(MarkedCoverage, SignalsPixelsThatNobodyDrawsOrSomeTwice) {
  Strip strip;
  strip.begin(3, 4, Rgb{200, 100, 40});
  const int column = 3 * Strip::kColumns + 5;
  ShownColumns<ShownTimes> shown(4);
  shown.here() = {{1}, {0}, {1}, {2}};
  const Level level{};
  const Geometry geometry{};
  mark({level, geometry}, shown, strip, column);
  constexpr Rgb kDimmed = {70, 35, 14};
  const auto colorIn = [&](int row) { return fromXrgb(*strip.at(column, row)); };
  EXPECT_EQ(colorIn(0), kDimmed);
  EXPECT_EQ(colorIn(1), kHole);
  EXPECT_EQ(colorIn(2), kDimmed);
  EXPECT_EQ(colorIn(3), (Rgb{255, 0, 0}));
}

TEST(MarkedCoverage, IsQuietInSoundLevels) {
  for (const char* path : {"levels/tutorial.json", "levels/gaol.json"}) {
    const Lit lit(path, 1);
    const Renderer renderer = lit.renderer();
    for (const Shot& shot : lit.level().shots) {
      const Image plain = renderer.draw(cameraOf(shot), LightMode::Both);
      const Image coverage = renderer.draw(cameraOf(shot), Marks::Coverage);
      for (std::size_t i = 0; i < plain.pixels().size(); ++i)
        ASSERT_NEAR(coverage.pixels()[i].r, 0.35 * plain.pixels()[i].r, 1) << shot.name;
    }
  }
}

// --- All -----------------------------------------------------------------------------------------

TEST(Marks, AreDrawnPixelByPixelWhateverTheSettings) {
  const Lit lit("tests/levels/rooms.json", 0.5);
  const Camera camera = eastward(lit.level());
  for (const Marks marks : {Marks::Texels, Marks::Outlines, Marks::Coverage})
    EXPECT_EQ(lit.renderer({.pixelSize = 3}).draw(camera, marks),
              lit.renderer().draw(camera, marks));
}

TEST(Marks, DoNotDependOnTheNumberOfThreads) {
  const Lit lit("levels/gaol.json", 0.5);
  const Renderer renderer = lit.renderer();
  for (const Shot& shot : lit.level().shots)
    for (const Marks marks : {Marks::Texels, Marks::Outlines, Marks::Coverage})
      for (const int threads : {2, 5, 64}) {
        Workers workers(threads);
        EXPECT_EQ(renderer.draw(cameraOf(shot), marks, &workers),
                  renderer.draw(cameraOf(shot), marks))
            << shot.name << ' ' << threads;
      }
}

TEST(Marks, ArePicturesOfTheCamerasSize) {
  const Lit lit("tests/levels/rooms.json", 0.5);
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 200}, {33, 7}})
    for (const Marks marks : {Marks::Texels, Marks::Outlines, Marks::Coverage}) {
      Camera camera = eastward(lit.level());
      camera.width = width;
      camera.height = height;
      const Image image = lit.renderer().draw(camera, marks);
      EXPECT_EQ(image.width(), width);
      EXPECT_EQ(image.height(), height);
    }
}

}  // namespace
}  // namespace hearth
