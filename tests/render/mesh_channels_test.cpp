// Channels and marks of meshes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "render/renderer.h"
#include "things_in_halls.h"

namespace hearth {
namespace {

using test::kSize;
using test::lookingEast;

/// 1 m each way around its centre below.
constexpr std::string_view kCube =
    "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\n"
    "v -0.5 1 -0.5\nv 0.5 1 -0.5\nv 0.5 1 0.5\nv -0.5 1 0.5\n"
    "f 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 8 7 6 5\nf 1 2 3 4\n";
/// A square, 1 m each way, that faces x < 0.
constexpr std::string_view kSquare = "v 0 0 0.5\nv 0 0 -0.5\nv 0 1 -0.5\nv 0 1 0.5\nf 1 4 3 2\n";

class MeshesInAHall {
 public:
  explicit MeshesInAHall(std::string_view things)
      : loaded_(
            test::levelWith(things, test::hall(), {{"cube.obj", kCube}, {"square.obj", kSquare}})),
        light_(bake(loaded_.scene(), loaded_.level.bake, 1)),
        renderer_(loaded_.scene(), loaded_.textures, light_) {}

  template <typename What>
  Image draw(What what, const Camera& camera) const {
    return renderer_.draw(camera, what);
  }
  const Renderer& renderer() const { return renderer_; }

  /// The pixel that a point lies in.
  std::pair<int, int> pixelOf(Vec3 point, const Camera& camera) const {
    const Projection projection = projectionFor(loaded_.scene(), camera);
    const CameraPoint seen = projection.toCamera(point.xy());
    return {static_cast<int>(projection.columnOf(seen)),
            static_cast<int>(projection.rowOf(point.z, seen.depth))};
  }

 private:
  LoadedLevel loaded_;
  BakedLight light_;
  Renderer renderer_;
};

/// Of the cube 4 m before that eye.
constexpr std::string_view kCubeAhead = "{'mesh':'cube.obj','x':5,'y':0,'texture':'#c80000'}";
bool isFrontAhead(int column, int row) {
  return column >= 28 && column < 36 && row >= 40 && row < 48;
}

using Color = std::tuple<int, int, int>;
Color colorOf(Rgb pixel) { return {pixel.r, pixel.g, pixel.b}; }

bool isRed(Rgb pixel) { return pixel.r > 0 && pixel.g == 0 && pixel.b == 0; }
bool isGrey(Rgb pixel) { return pixel.r == pixel.g && pixel.g == pixel.b; }

TEST(ChannelFaces, hasAColourForEachTriangleAndTheSurfacesDark) {
  const MeshesInAHall hall(kCubeAhead);
  const Image faces = hall.draw(Channel::Faces, lookingEast());
  const Image surfaces = hall.draw(Channel::Surface, lookingEast());
  const Rgb mesh = surfaces.at(32, 44);
  std::set<Color> front;
  std::set<Color> all;
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const Rgb pixel = faces.at(column, row);
      const Rgb surface = surfaces.at(column, row);
      if (surface == mesh) {
        all.insert(colorOf(pixel));
        if (isFrontAhead(column, row)) front.insert(colorOf(pixel));
      } else {
        ASSERT_EQ(colorOf(pixel), Color(surface.r / 4, surface.g / 4, surface.b / 4))
            << column << ' ' << row;
      }
    }
  EXPECT_EQ(front.size(), 2U);
  EXPECT_EQ(all.size(), 4U) << "and those of its top";
}

TEST(ChannelDepth, hasThatOfMeshes) {
  const Image depths = MeshesInAHall(kCubeAhead).draw(Channel::Depth, lookingEast());
  for (int row = 40; row < 48; ++row)
    for (int column = 28; column < 36; ++column)
      ASSERT_EQ(colorOf(depths.at(column, row)), Color(51, 51, 51)) << "255 / (1 + 4)";
}

TEST(ChannelNormal, pointsOutOfTheFrontsOfFaces) {
  const Image cube = MeshesInAHall(kCubeAhead).draw(Channel::Normal, lookingEast());
  EXPECT_EQ(colorOf(cube.at(32, 44)), Color(0, 128, 128));
  EXPECT_EQ(colorOf(cube.at(32, 39)), Color(128, 128, 255)) << "its top";
  const Image turned =
      MeshesInAHall("{'mesh':'square.obj','x':4.5,'y':0,'angle':180,'twoSided':true}")
          .draw(Channel::Normal, lookingEast());
  EXPECT_EQ(colorOf(turned.at(32, 44)), Color(255, 128, 128)) << "away from the eye";
}

TEST(ChannelBacks, hasFacesSeenFromTheirBacksRedAndAllElseGrey) {
  for (const bool isTurned : {false, true}) {
    const Image sides =
        MeshesInAHall(
            fmt::format("{{'mesh':'square.obj','x':4.5,'y':0,'angle':{},'twoSided':true}}",
                        isTurned ? 180 : 0))
            .draw(Channel::Backs, lookingEast());
    for (int row = 0; row < kSize; ++row)
      for (int column = 0; column < kSize; ++column) {
        const Rgb pixel = sides.at(column, row);
        ASSERT_TRUE(isTurned && isFrontAhead(column, row) ? isRed(pixel) : isGrey(pixel))
            << column << ' ' << row;
      }
  }
}

TEST(ChannelBacks, isRedAllAroundWithinATwoSidedMesh) {
  Camera camera = lookingEast();
  camera.eye = {0.3, 0.1, 2.5};
  const Image inside =
      MeshesInAHall("{'mesh':'cube.obj','x':1,'y':0,'z':1.5,'scale':2,'twoSided':true}")
          .draw(Channel::Backs, camera);
  EXPECT_TRUE(std::ranges::all_of(inside.pixels(), isRed));
  std::set<Color> tones;
  for (const Rgb pixel : inside.pixels()) tones.insert(colorOf(pixel));
  EXPECT_GT(tones.size(), 2U) << "its sides differ";
}

TEST(MarkedVertices, areDotsAtTheCornersThatShow) {
  const MeshesInAHall hall(kCubeAhead);
  Image expected = hall.draw(LightMode::Both, lookingEast());
  // Those of its front and its top. Those of its bottom behind them are hidden.
  for (const Vec3 corner : {Vec3{4.5, -0.5, 0}, Vec3{4.5, 0.5, 0}, Vec3{4.5, -0.5, 1},
                            Vec3{4.5, 0.5, 1}, Vec3{5.5, -0.5, 1}, Vec3{5.5, 0.5, 1}}) {
    const auto [column, row] = hall.pixelOf(corner, lookingEast());
    for (int y = row - 1; y <= row + 1; ++y)
      for (int x = column - 1; x <= column + 1; ++x) expected.at(x, y) = {255, 232, 32};
  }
  EXPECT_EQ(hall.draw(Marks::Vertices, lookingEast()), expected);
}

TEST(MarkedVertices, areNotThoseThatASpriteHides) {
  const MeshesInAHall hall(std::string(kCubeAhead) +
                           ",{'sprite':'#0000c8','x':3,'y':0,'size':[4,2]}");
  EXPECT_EQ(hall.draw(Marks::Vertices, lookingEast()), hall.draw(LightMode::Both, lookingEast()));
}

TEST(MarkedVertices, areNotThoseBehindTheEyeOrBesideThePicture) {
  const MeshesInAHall hall("{'mesh':'cube.obj','x':1,'y':0,'z':1.5,'twoSided':true,'scale':1.9}");
  Camera camera = lookingEast();
  camera.eye = {1.2, 0.1, 2.5};
  camera.fov = 40;
  EXPECT_EQ(hall.draw(Marks::Vertices, camera), hall.draw(LightMode::Both, camera));
}

TEST(MarkedVertices, haveTheSamePixelsOnAnyNumberOfThreads) {
  std::string things;
  for (int i = 0; i < 30; ++i)
    things += fmt::format("{}{{'mesh':'cube.obj','x':{},'y':{},'angle':{},'scale':{}}}",
                          i > 0 ? "," : "", 1.05 + 0.2 * i, -3 + 0.2 * i, 37 * i, 0.3 + 0.05 * i);
  const MeshesInAHall hall(things);
  Camera camera = lookingEast();
  camera.width = 333;
  const Image alone = hall.renderer().draw(camera, Marks::Vertices);
  EXPECT_GT(std::ranges::count(alone.pixels(), Rgb{255, 232, 32}), 100);
  for (const int threads : {2, 5, 64}) {
    Workers workers(threads);
    EXPECT_EQ(hall.renderer().draw(camera, Marks::Vertices, &workers), alone) << threads;
  }
}

}  // namespace
}  // namespace hearth
