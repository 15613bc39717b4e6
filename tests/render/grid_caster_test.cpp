// Numbers that hold for every caster of rays through a grid, as in tutorials that draw a picture of
// 240 x 160 pixels of a map of cells of 64 units: one column after the other, each from the wall
// that its ray meets. Here the map is a level's grid, and a unit is a metre.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "math/trig.h"
#include "render/frame_scratch.h"
#include "render/renderer.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr double kPrinted = 6e-5;  // half of the last digit, a little more
constexpr double kDegrees = 180 / 3.141592653589793238462643;
constexpr int kColumns = 240;
constexpr int kRows = 160;
constexpr double kCell = 64;
constexpr double kEyeHeight = 32;

/// Twelve by twelve cells: a border, pillars in the corners, and a box with a niche.
const LoadedLevel& map() {
  static const LoadedLevel kMap = test::levelFrom(
      "{'light': 1, 'grid': {'cell': 64, 'rows': ['111111111111', '133......331', '133......331', "
      "'1..........1', '1...444....1', '1...464....1', '1...4.4....1', '1..........1', "
      "'1..........1', '133......331', '133......331', '122255522221'], 'legend': {'1': {'wall': "
      "'#000001'}, '2': {'wall': '#000002'}, '3': {'wall': '#000003'}, '4': {'wall': '#000004'}, "
      "'5': {'wall': '#000005'}, '6': {'wall': '#000006'}, '.': {'floor': {'texture': '#808080'}, "
      "'ceiling': {'z': 64, 'texture': '#404040'}}}}}");
  return kMap;
}

/// What the ray in the middle of a picture meets, at the height of the eye.
struct Hit {
  double distance;
  int cell;  ///< the character of the map
  Vec2 at;
  bool facesX;  ///< the wall runs along y
};

Hit cast(Vec2 eye, double angle) {
  const Scene scene = map().scene();
  static const BakedLight kDark = bake(scene, {}, 1);
  static const Renderer kRenderer(scene, map().textures, kDark);
  Camera camera;
  camera.sector = SectorId(0);
  camera.eye = {eye.x, eye.y, kEyeHeight};
  camera.angle = angle;
  camera.width = camera.height = 1;
  FrameScratch scratch;
  kRenderer.findSpans(camera, scratch);
  Hit hit{};
  scratch.forEachSpan([&](const Span& span) {
    const Surface& surface = scene[span.surface];
    if (!surface.segment) return;
    const Segment& segment = scene[*surface.segment];
    const std::string& texture =
        map().level.textures[std::get<Solid>(segment.wall).texture.texture.index()];
    hit = {span.depth, texture.back() - '0', lerp(segment.p0, segment.p1, span.fraction),
           segment.p0.x == segment.p1.x};
  });
  return hit;
}

/// The texel that such a caster shows of a wall's image, which is as wide as a cell.
int texelAt(const Hit& hit) {
  return static_cast<int>(std::fmod(hit.facesX ? hit.at.y : hit.at.x, kCell));
}

Projection projectionOf(double fov, Vec3 eye = {0, 0, kEyeHeight}) {
  Camera camera;
  camera.fov = fov;
  camera.width = kColumns;
  camera.height = kRows;
  return {camera, eye};
}

double cosDegrees(double angle) { return sinCosDegrees(angle).cos; }
double sinDegrees(double angle) { return sinCosDegrees(angle).sin; }

/// Directions of rays in columns of a picture, in degrees from the middle.
double evenAngle(double column, double fov) { return (column / kColumns - 0.5) * fov; }
double trueAngle(double column, double fov) {
  return std::atan(projectionOf(fov).slantOf(column)) * kDegrees;
}

// --- Rays ----------------------------------------------------------------------------------------

TEST(GridCaster, raysMeetTheseWalls) {
  struct Ray {
    Vec2 eye;
    double angle;
    double distance;
    int cell;
    int texel;
    bool facesX;
    Vec2 at;
  };
  const Vec2 a{352, 544};
  const Vec2 b{544, 288};
  for (const Ray& ray :
       {Ray{a, 0, 352, 1, 32, true, {704, 544}}, Ray{a, 90, 160, 5, 32, false, {352, 704}},
        Ray{a, 180, 288, 1, 32, true, {64, 544}}, Ray{a, 270, 160, 6, 32, false, {352, 384}},
        Ray{a, 15, 231.9019, 3, 28, true, {576, 604.0206}},
        Ray{a, 75, 165.6442, 5, 10, false, {394.8719, 704}},
        Ray{a, 200, 306.4832, 1, 55, true, {64, 439.1766}},
        Ray{a, 247.5, 103.9097, 4, 56, false, {312.2355, 448}},
        Ray{a, 300, 110.8513, 4, 23, false, {407.4256, 448}},
        Ray{a, 330, 406.4546, 1, 20, true, {704, 340.7727}}}) {
    SCOPED_TRACE(ray.angle);
    const Hit hit = cast(ray.eye, ray.angle);
    EXPECT_NEAR(hit.distance, ray.distance, kPrinted);
    EXPECT_EQ(hit.cell, ray.cell);
    EXPECT_EQ(texelAt(hit), ray.texel);
    EXPECT_EQ(hit.facesX, ray.facesX);
    EXPECT_NEAR(hit.at.x, ray.at.x, kPrinted);
    EXPECT_NEAR(hit.at.y, ray.at.y, kPrinted);
  }
  for (const Ray& ray :
       {Ray{b, 0, 160, 1, 32, true, {}}, Ray{b, 90, 416, 2, 32, false, {}},
        Ray{b, 180, 96, 4, 32, true, {}}, Ray{b, 270, 224, 1, 32, false, {}},
        Ray{b, 15, 165.6442, 1, 10, true, {}}, Ray{b, 75, 298.1595, 3, 45, false, {}},
        Ray{b, 200, 374.5906, 3, 31, true, {}}, Ray{b, 247.5, 242.4559, 1, 3, false, {}},
        Ray{b, 300, 110.8513, 3, 23, false, {}}, Ray{b, 330, 184.7521, 1, 3, true, {}}}) {
    SCOPED_TRACE(ray.angle);
    const Hit hit = cast(ray.eye, ray.angle);
    EXPECT_NEAR(hit.distance, ray.distance, kPrinted);
    EXPECT_EQ(hit.cell, ray.cell);
    EXPECT_EQ(texelAt(hit), ray.texel);
    EXPECT_EQ(hit.facesX, ray.facesX);
  }
}

TEST(GridCaster, noRayIsLongerThanTheDiagonal) {
  EXPECT_NEAR(length(Vec2{12 * kCell, 12 * kCell}), 1086.116, 6e-4);
}

TEST(GridCaster, cellsHoldTheseUnits) {
  for (const auto& [cell, first, last] : {std::tuple{0, 0, 63}, {1, 64, 127}, {2, 128, 191}}) {
    EXPECT_EQ(std::floor(first / kCell), cell);
    EXPECT_EQ(std::floor(last / kCell), cell);
  }
}

// --- The picture ---------------------------------------------------------------------------------

TEST(GridCaster, thePictureStandsThisFarFromTheEye) {
  EXPECT_NEAR(projectionOf(60).distancePx(), 207.846097, 6e-7);
  EXPECT_NEAR(kCell * projectionOf(60).distancePx(), 13302.150202, 6e-7);
  EXPECT_NEAR(projectionOf(90).distancePx(), 120, 1e-12);
  EXPECT_EQ(projectionOf(60).horizonRow(), 80);
}

TEST(GridCaster, wallsAreThisHigh) {
  struct Wall {
    double distance;
    double rows;
    double top;
    double texelsPerRow;
  };
  const Projection projection = projectionOf(60);
  for (const Wall& wall :
       {Wall{64, 207.8461, -23.923, 0.30792}, Wall{83.1384, 160, 0, 0.4},
        Wall{100, 133.0215, 13.489, 0.481126}, Wall{128, 103.923, 28.038, 0.615841},
        Wall{207.8461, 64, 48, 1}, Wall{500, 26.6043, 66.698, 2.40563},
        Wall{1086, 12.2488, 73.876, 5.22502}}) {
    SCOPED_TRACE(wall.distance);
    const double top = projection.rowOf(kCell, wall.distance);
    const double rows = projection.rowOf(0, wall.distance) - top;
    EXPECT_NEAR(rows, wall.rows, 1e-4);
    EXPECT_NEAR(top, wall.top, 1e-3);
    EXPECT_NEAR(kCell / rows, wall.texelsPerRow, 1e-5);
  }
}

TEST(GridCaster, aWallOfFortyRowsBeginsAtRowSixty) {
  const Projection projection = projectionOf(60);
  const double rows = projection.rowOf(0, 330) - projection.rowOf(kCell, 330);
  EXPECT_NEAR(rows, 40.3095, kPrinted);
  const int whole = static_cast<int>(rows + 0.5);  // 40.8095 before it is cut
  EXPECT_EQ(whole, 40);
  EXPECT_EQ(kRows / 2 - whole / 2, 60);
  EXPECT_EQ(kCell / whole, 1.6);
}

TEST(GridCaster, aColumnHalfWayToTheEdgeLooksThisFarAside) {
  EXPECT_NEAR(tanDegrees(evenAngle(180, 60)), 0.267949, 6e-7);
  EXPECT_NEAR(projectionOf(60).slantOf(180), 0.288675, 6e-7);
  EXPECT_NEAR(trueAngle(180, 60), 16.1021, kPrinted);
}

// --- Rays at even angles -------------------------------------------------------------------------
// Such casters turn from column to column by the same angle. Through the columns of a flat picture
// the rays are denser at its sides. What a ray at an even angle shows belongs into another column.

double columnOfAngle(double degrees, double fov) {
  return projectionOf(fov).columnOf({cosDegrees(degrees), sinDegrees(degrees)});
}

TEST(GridCaster, raysAtEvenAnglesMissTheirColumnsByThis) {
  struct Miss {
    double fov;
    double column;
    double degrees;
    double columns;
  };
  for (const Miss& miss :
       {Miss{60, 30, 0.9132, 3.907}, Miss{60, 60, 1.1021, 4.308}, Miss{60, 90, 0.7132, 2.637},
        Miss{60, 120, 0, 0}, Miss{60, 239, -0.0428, -0.206}, Miss{90, 30, 3.1199, 9.819},
        Miss{90, 60, 4.0651, 10.294}, Miss{90, 90, 2.7862, 6.131},
        Miss{90, 239, -0.1353, -0.561}}) {
    SCOPED_TRACE(miss.column);
    const double even = evenAngle(miss.column, miss.fov);
    EXPECT_NEAR(even - trueAngle(miss.column, miss.fov), miss.degrees, kPrinted);
    EXPECT_NEAR(columnOfAngle(even, miss.fov) - miss.column, miss.columns, 6e-4);
    EXPECT_NEAR(evenAngle(kColumns - miss.column, miss.fov), -even, 1e-12);
  }
}

struct Worst {
  double degrees = 0;
  double columns = 0;
};

Worst worstMiss(double fov) {
  Worst worst;
  for (double column = 0; column <= kColumns; column += 1.0 / 64) {
    const double even = evenAngle(column, fov);
    worst.degrees = std::max(worst.degrees, std::abs(even - trueAngle(column, fov)));
    worst.columns = std::max(worst.columns, std::abs(columnOfAngle(even, fov) - column));
  }
  return worst;
}

TEST(GridCaster, atMostRaysAtEvenAnglesMissByThis) {
  EXPECT_NEAR(worstMiss(60).degrees, 1.117, 6e-4);
  EXPECT_NEAR(worstMiss(60).columns, 4.47, 6e-3);
  EXPECT_NEAR(worstMiss(90).degrees, 4.074, 6e-4);
  EXPECT_NEAR(worstMiss(90).columns, 10.86, 6e-3);
}

TEST(GridCaster, aFrameOfRaysAtEvenAngles) {
  struct Column {
    double column;
    double distance;
    double depth;
    double rows;  ///< 0: not printed
  };
  for (const Column& column :
       {Column{0, 406.4546, 352, 37.790}, Column{60, 364.4172, 352, 0}, Column{120, 352, 352, 0},
        Column{180, 231.9019, 224, 59.385}, Column{239, 258.0054, 224, 0}}) {
    SCOPED_TRACE(column.column);
    const double angle = evenAngle(column.column, 60);
    const double distance = cast({352, 544}, angle).distance;
    EXPECT_NEAR(distance, column.distance, kPrinted);
    EXPECT_NEAR(distance * cosDegrees(angle), column.depth, kPrinted);  // without "fish eye"
    if (column.rows > 0) {
      EXPECT_NEAR(kCell * projectionOf(60).distancePx() / column.depth, column.rows, 6e-4);
    }
  }
}

TEST(GridCaster, theSameFrameOfRaysThroughItsColumns) {
  struct Column {
    double column;
    double distance;
    int texel;  ///< -1: not printed
  };
  for (const Column& column :
       {Column{60, 366.3732, 58}, Column{180, 233.1466, 32}, Column{239, 258.1157, -1}}) {
    SCOPED_TRACE(column.column);
    const Hit hit = cast({352, 544}, trueAngle(column.column, 60));
    EXPECT_NEAR(hit.distance, column.distance, kPrinted);
    if (column.texel >= 0) {
      EXPECT_EQ(texelAt(hit), column.texel);
    }
  }
}

// --- What else such casters do, and Hearth does not ----------------------------------------------

/// The part of a wall that shows, when it is higher than the picture.
TEST(GridCaster, aStripScaledAfterItIsClampedShowsAllOfItsImage) {
  const Projection projection = projectionOf(60);
  const double rows = 207.8461;  // of a wall 64 units away
  const double clamped = std::min(rows, 1.0 * kRows);
  EXPECT_EQ(kCell / clamped, 0.4);  // texels a row: all 64 in 160 rows
  const auto texelAtRow = [&](double row) {
    return kCell - (kEyeHeight + projection.raySlopeAt(row) * 64);
  };
  EXPECT_NEAR(texelAtRow(0), 7.366, 6e-4);  // what shows in truth
  EXPECT_NEAR((texelAtRow(kRows) - texelAtRow(0)) / kRows, 0.30792, 6e-6);
}

TEST(GridCaster, stepsOf16BitsDriftByHalfATexel) {
  const double perRow = 0.30792;
  const auto step = static_cast<std::uint16_t>(perRow * 256);  // 8 bits behind the point
  EXPECT_EQ(step, 78);
  const double drift = kRows * (perRow - step / 256.0);
  EXPECT_NEAR(drift, 0.5172, 6e-5);
}

TEST(GridCaster, aStepOfTheirPlayerIsCutToWholeUnits) {
  struct Step {
    double angle;
    int x;
    int y;
  };
  for (const Step& step :
       {Step{0, 16, 0}, Step{3.5, 15, 0}, Step{45, 11, 11}, Step{90, 0, 16}, Step{135, -11, 11},
        Step{180, -16, 0}, Step{225, -11, -11}, Step{270, 0, -16}, Step{315, 11, -11}}) {
    EXPECT_EQ(static_cast<int>(16 * cosDegrees(step.angle)), step.x) << step.angle;
    EXPECT_EQ(static_cast<int>(16 * sinDegrees(step.angle)), step.y) << step.angle;
  }
}

TEST(GridCaster, fishEyeIsTheCosineOfTheAngleFromTheMiddle) {
  for (const auto& [column, cosine] : {std::pair{0.0, 0.866025},
                                       {1.0, 0.868199},
                                       {30.0, 0.923880},
                                       {60.0, 0.965926},
                                       {90.0, 0.991445},
                                       {119.0, 0.999990},
                                       {120.0, 1.0},
                                       {121.0, 0.999990},
                                       {150.0, 0.991445},
                                       {180.0, 0.965926},
                                       {210.0, 0.923880},
                                       {239.0, 0.868199}})
    EXPECT_NEAR(cosDegrees(evenAngle(column, 60)), cosine, 6e-7) << column;
}

}  // namespace
}  // namespace hearth
