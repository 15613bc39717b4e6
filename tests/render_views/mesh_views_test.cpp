// Meshes in views.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "load/load.h"
#include "render/renderer.h"
#include "render/views.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr std::string_view kCube =
    "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\n"
    "v -0.5 1 -0.5\nv 0.5 1 -0.5\nv 0.5 1 0.5\nv -0.5 1 0.5\n"
    "f 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 8 7 6 5\nf 1 2 3 4\n";

/// A hall from x = 0 to 8 and y = -4 to 4, 4 m high.
LoadedLevel hallWith(std::string_view things) {
  return test::levelFrom(fmt::format("{{'light':1,'things':[{}],'sectors':{{{}}}}}", things,
                                     test::sectorText("hall", "0,-4, 8,-4, 8,4, 0,4", 0, 4)),
                         "[]", {{"cube.obj", kCube}});
}

/// Along +x. The picture plane is 100 pixels away.
Camera ahead() { return {SectorId(0), {0.5, 0.1, 2}, 0, 0, 90, 200, 160, 0}; }

/// Of the hue of meshes, whose blue is the strongest.
bool isMeshLine(Rgb pixel) { return pixel.b > pixel.r + 8; }

bool hasMeshLineNear(const Image& image, Vec3 point, const LoadedLevel& level,
                     const Camera& camera) {
  const Projection projection = projectionFor(level.scene(), camera);
  const CameraPoint seen = projection.toCamera(point.xy());
  const auto x = static_cast<int>(projection.columnOf(seen));
  const auto y = static_cast<int>(projection.rowOf(point.z, seen.depth));
  for (int row = y - 1; row <= y + 1; ++row)
    for (int column = x - 1; column <= x + 1; ++column)
      if (isMeshLine(image.at(column, row))) return true;
  return false;
}

TEST(MeshesInTheWireframe, HaveAllEdgesOfTheirTriangles) {
  const LoadedLevel level = hallWith("{'mesh':'cube.obj','x':4,'y':0}");
  const Image image = drawView(level.scene(), ahead(), View::Wireframe);
  for (const Vec3 onEdge : {Vec3{3.5, -0.5, 0.3}, Vec3{3.5, 0.2, 1}, Vec3{4.2, 0.5, 1},
                            Vec3{4.5, 0.5, 0.4}, Vec3{4.5, -0.2, 0}, Vec3{3.8, -0.5, 0}})
    EXPECT_TRUE(hasMeshLineNear(image, onEdge, level, ahead())) << onEdge.x << ' ' << onEdge.y;
  EXPECT_TRUE(hasMeshLineNear(image, {3.5, 0, 0.5}, level, ahead())) << "between two triangles";
  EXPECT_FALSE(hasMeshLineNear(image, {3.5, 0.7, 0.5}, level, ahead())) << "beside it";
}

TEST(MeshesInTheWireframe, AreClippedAtTheEye) {
  const LoadedLevel level = hallWith("{'mesh':'cube.obj','x':1,'y':0,'z':1,'scale':2}");
  const Image image = drawView(level.scene(), ahead(), View::Wireframe);
  for (const Vec3 onEdge : {Vec3{2, -0.8, 1}, Vec3{2, 1, 2.2}, Vec3{1.6, 1, 1.4}})
    EXPECT_TRUE(hasMeshLineNear(image, onEdge, level, ahead())) << onEdge.x << ' ' << onEdge.y;
  Camera away = ahead();
  away.eye.x = 3;
  const Image behind = drawView(level.scene(), away, View::Wireframe);
  EXPECT_EQ(std::ranges::count_if(behind.pixels(), isMeshLine), 0);
}

TEST(MeshesOnTheScreen, DimTheEdgesThatTheyHide) {
  const auto brightAtFarCorner = [](std::string_view things) {
    const LoadedLevel level = hallWith(things);
    // The upright edge at x = 8, y = 4, 7.5 m ahead: column 152.
    const Image image = drawView(level.scene(), ahead(), View::Screen);
    for (int column = 151; column <= 153; ++column)
      if (image.at(column, 85) == Rgb{255, 255, 255}) return true;
    return false;
  };
  EXPECT_TRUE(brightAtFarCorner(""));
  EXPECT_FALSE(brightAtFarCorner("{'mesh':'cube.obj','x':4,'y':2,'scale':2}"));
  EXPECT_FALSE(
      brightAtFarCorner("{'mesh':'cube.obj','x':4,'y':2,'scale':2},"
                        "{'mesh':'cube.obj','x':7.2,'y':3.2,'scale':[1.6,1.6,4]}"));
}

}  // namespace
}  // namespace hearth
