#include "render/views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "load/load.h"
#include "render/line.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {

namespace {

constexpr Rgb kWall = {255, 255, 255};
constexpr Rgb kWayOn = {255, 160, 48};
constexpr View kViews[] = {View::World, View::Camera, View::DepthSpace, View::Screen,
                           View::Wireframe};

LoadedLevel loaded(const std::string& path) {
  LoadResult result = loadLevel(test::inTree(path));
  return std::move(result.loaded).value();
}

/// In the hall of the test level, 4 m x 4 m x 3 m with a window in its eastern wall, looking east.
/// With these 200 columns and 90 degrees the picture plane is 100 pixels away.
Camera eastward(const Level& level) {
  Camera camera;
  camera.sector = level.player->sector;
  camera.eye = {1, 2, 1.5};
  camera.width = 200;
  camera.height = 120;
  return camera;
}

int count(const Image& image, Rgb color) {
  return static_cast<int>(std::ranges::count(image.pixels(), color));
}

bool isNear(const Image& image, int x, int y, Rgb color) {
  for (int j = std::max(0, y - 1); j <= std::min(image.height() - 1, y + 1); ++j)
    for (int i = std::max(0, x - 1); i <= std::min(image.width() - 1, x + 1); ++i)
      if (image.at(i, j) == color) return true;
  return false;
}

class Views : public testing::Test {
 protected:
  Image draw(View view) const { return drawView(scene, eastward(level), view); }

  LoadedLevel rooms = loaded("tests/levels/rooms.json");
  const Level& level = rooms.level;
  const Scene scene = rooms.scene();
};

TEST_F(Views, TheMapHasSouthBelowAndTheWayOutInTheEast) {
  const Image image = draw(View::World);
  // The plan is 8 m x 8 m, so 120 pixels with 6 % margins are 13.2 pixels a metre about (4, 4).
  const auto pixel = [](double x, double y) {
    return std::pair(static_cast<int>(100 + 13.2 * (x - 4)), static_cast<int>(60 + 13.2 * (y - 4)));
  };
  const auto [westX, westY] = pixel(0, 2);
  EXPECT_TRUE(isNear(image, westX, westY, kWall));
  const auto [windowX, windowY] = pixel(4, 2);
  EXPECT_TRUE(isNear(image, windowX, windowY, kWayOn));
  const auto [endX, endY] = pixel(2, 8);
  EXPECT_TRUE(isNear(image, endX, endY, kWall));
}

TEST_F(Views, TheCameraLooksUpThePicture) {
  const Image image = draw(View::Camera);
  // The far end of the garden, 7 m ahead, is the topmost wall; the wall behind the eye is dim.
  int first = 0;
  while (count(image, kWall) > 0 && image.at(100, first) != kWall) ++first;
  EXPECT_LT(first, 20);
  int window = first;
  while (window < 120 && image.at(100, window) != kWayOn) ++window;
  // The eye's row is 108: depths of 7 m and 3 m.
  EXPECT_NEAR((108.0 - window) / (108.0 - first), 3.0 / 7.0, 0.02);
}

TEST_F(Views, InDepthSpaceAWallStraightAheadIsLevel) {
  const Image image = draw(View::DepthSpace);
  // The eastern wall, 3 m ahead, reaches from y = 0 to 4: columns 100 -+ 100 * 2 / 3.
  int row = 0;
  while (row < 120 && image.at(60, row) != kWall) ++row;
  ASSERT_LT(row, 120);
  EXPECT_TRUE(isNear(image, 36, row, kWall));
  EXPECT_TRUE(isNear(image, 164, row, kWall));
  EXPECT_TRUE(isNear(image, 100, row, kWayOn));
}

TEST_F(Views, OnTheScreenEdgesAreWhereTheProjectionHasThem) {
  const Image image = draw(View::Screen);
  // The foot of the eastern wall, 3 m ahead and 1.5 m below: row 60 + 50; its corners.
  for (const int column : {40, 100, 160}) EXPECT_TRUE(isNear(image, column, 110, kWall)) << column;
  for (const int row : {30, 60, 90}) EXPECT_TRUE(isNear(image, 33, row, kWall)) << row;
  // The window's sill, 0.5 m below the eye: row 60 + 100 * 0.5 / 3.
  EXPECT_TRUE(isNear(image, 100, 77, kWayOn));
}

TEST(ViewsOfAFarHorizon, AreFilledByWhatIsNear) {
  // A room that opens to a lake of 2 km.
  const LoadedLevel loaded = test::levelFrom(
      "{'light': 1, 'shots': [{'name': 'in', 'camera': [1, 2, 1.5, 0, 0]}, "
      "{'name': 'out', 'camera': [3, 2, 1.5, 0, 0]}], 'sectors': {" +
      test::sectorText("room", "0,0, 4,0, 4,4, 0,4", 0, 3,
                       "[{'texture': '#808080'}, {'next': 'lake'}, {'texture': '#808080'}, "
                       "{'texture': '#808080'}]") +
      "," +
      test::sectorText("lake", "4,0, 2000,-1000, 2000,1000, 4,4", 0, 3,
                       "[{'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}, "
                       "{'next': 'room'}]") +
      "}}");
  Camera camera = cameraOf(loaded.level.shots.front());
  camera.width = 200;
  camera.height = 120;
  // 4 m in 120 pixels with 6 % margins are 26.4 pixels a metre about (2, 2).
  const Image world = drawView(loaded.scene(), camera, View::World);
  EXPECT_TRUE(isNear(world, 47, 60, kWall));
  EXPECT_TRUE(isNear(world, 153, 60, kWayOn));
  // The way out, 3 m ahead, is as far up as the picture has room: the eye's row is 108.
  const Image turned = drawView(loaded.scene(), camera, View::Camera);
  EXPECT_TRUE(isNear(turned, 120, 6, kWayOn));
}

/// Whether a line passes a pixel or one beside it, bright enough for a wall at that depth.
bool hasLine(const Image& image, int x, int y) {
  for (int j = y - 1; j <= y + 1; ++j)
    for (int i = x - 1; i <= x + 1; ++i)
      if (image.at(i, j) != Rgb{}) return true;
  return false;
}

TEST_F(Views, TheWireframeHasWhatIsHidden) {
  const Image image = draw(View::Wireframe);
  // The foot of the garden's far wall, 7 m ahead, behind the parapet: row 60 + 100 * 1.5 / 7.
  for (const int column : {90, 100, 110}) EXPECT_TRUE(hasLine(image, column, 81)) << column;
  for (const int column : {90, 100, 110}) EXPECT_FALSE(hasLine(image, column, 87)) << column;
  // Nearer lines are brighter: the foot of the wall 3 m ahead.
  const auto brightest = [&](int column, int row) {
    return std::max(
        {image.at(column, row - 1).b, image.at(column, row).b, image.at(column, row + 1).b});
  };
  EXPECT_GT(brightest(50, 110), brightest(100, 81));
}

TEST_F(Views, TheWireframeHasNothingBehindTheEye) {
  Camera camera = eastward(level);
  camera.eye.x = 7.999;  // before the last wall, which has no edges in this narrow view
  camera.sector = SectorId(1);
  camera.fov = 30;
  EXPECT_EQ(count(drawView(scene, camera, View::Wireframe), Rgb{}), 200 * 120);
}

TEST_F(Views, ArePicturesOfTheCamerasSize) {
  for (const View view : kViews)
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 200}, {33, 7}}) {
      Camera camera = eastward(level);
      camera.width = width;
      camera.height = height;
      const Image image = drawView(scene, camera, view);
      EXPECT_EQ(image.width(), width);
      EXPECT_EQ(image.height(), height);
    }
}

TEST_F(Views, TakeEveryFieldOfViewAndPlace) {
  for (const View view : kViews)
    for (const double fov : {1.0, 179.0})
      for (const Vec3 eye : {Vec3{0, 0, 0}, Vec3{4, 2, 1.5}, Vec3{1e-9, 2, 1.5}, Vec3{2, 4, 3}}) {
        Camera camera = eastward(level);
        camera.fov = fov;
        camera.pitch = 60;
        camera.eye = eye;
        const Rgb background = view == View::Wireframe ? Rgb{} : Rgb{16, 18, 28};
        EXPECT_GT(count(drawView(scene, camera, view), background), 0);
      }
}

// --- Lines -----------------------------------------------------------------------------------

using Pixels = std::set<std::pair<int, int>>;

Pixels pixelsOf(Vec2 a, Vec2 b) {
  Pixels pixels;
  forEachPixelOfLine(a, b, 40, 30, [&](int x, int y, double fraction) {
    EXPECT_TRUE(x >= 0 && x < 40 && y >= 0 && y < 30) << x << ' ' << y;
    EXPECT_TRUE(fraction >= 0 && fraction <= 1) << fraction;
    pixels.emplace(x, y);
  });
  return pixels;
}

TEST(Line, HasAPixelInEveryColumnOrRowItPasses) {
  EXPECT_EQ(pixelsOf({0.5, 3.5}, {39.5, 9.5}).size(), 40U);
  EXPECT_EQ(pixelsOf({5.5, 29.5}, {9.5, 0.5}).size(), 30U);
  EXPECT_EQ(pixelsOf({7.5, 7.5}, {7.5, 7.5}), (Pixels{{7, 7}}));
}

TEST(Line, IsClippedToThePicture) {
  EXPECT_TRUE(pixelsOf({-10, -1}, {100, -1}).empty());
  EXPECT_TRUE(pixelsOf({-10, 5}, {-1, 25}).empty());
  EXPECT_TRUE(pixelsOf({30, -20}, {60, 10}).empty());
  EXPECT_EQ(pixelsOf({-1e6, 10.5}, {1e6, 10.5}).size(), 40U);
}

TEST(Line, StaysInThePictureHoweverFarItsEndsAre) {
  const double huge = std::numeric_limits<double>::max();
  for (const double far : {1e9, 1e18, 1e200, huge}) {
    pixelsOf({-far, -far}, {far, far});
    pixelsOf({20, 15}, {far, -far});
    pixelsOf({far, 3}, {-far, 4});
  }
}

TEST(Line, OfNoNumberIsLeftOut) {
  const double infinite = std::numeric_limits<double>::infinity();
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(pixelsOf({1, 1}, {infinite, 1}).empty());
  EXPECT_TRUE(pixelsOf({1, none}, {9, 9}).empty());
}

TEST(Line, FractionGrowsEvenlyAlongIt) {
  double last = -1;
  forEachPixelOfLine({-20, 5}, {60, 5}, 40, 30, [&](int x, int, double fraction) {
    EXPECT_NEAR(fraction, (20.0 + x) / 80, 1.0 / 80);
    EXPECT_GT(fraction, last);
    last = fraction;
  });
}

}  // namespace

}  // namespace hearth
