#include "random_levels/mesh.h"

#include <gtest/gtest.h>

#include <set>

namespace hearth::random_levels {
namespace {

/// Unit squares, row by row.
Mesh squares(std::size_t columns, std::size_t rows) {
  Random random(1);
  MeshStyle style;
  style.columns = columns;
  style.rows = rows;
  style.cellMin = style.cellMax = style.unit = kMetre;
  style.isJittered = false;
  return makeMesh(random, style);
}

std::vector<FaceId> allFacesBut(const Mesh& mesh, const std::set<FaceId>& left) {
  std::vector<FaceId> faces;
  for (FaceId f = 0; f < mesh.faces.size(); ++f) {
    if (!left.contains(f)) faces.push_back(f);
  }
  return faces;
}

double squareMetres(const Mesh& mesh, const std::vector<VertexId>& loop) {
  return 0.5e-12 * static_cast<double>(doubleArea(mesh, loop));
}

void expectNoVertexTwice(const std::vector<VertexId>& loop) {
  EXPECT_EQ(std::set<VertexId>(loop.begin(), loop.end()).size(), loop.size());
}

TEST(OutlineOf, HoleThatTouchesTheBorderInAVertexIsALoopOfItsOwn) {
  const Mesh mesh = squares(3, 3);
  const auto loops = outlineOf(mesh, allFacesBut(mesh, {0, 4}));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_DOUBLE_EQ(squareMetres(mesh, loops[0]), 8);
  EXPECT_DOUBLE_EQ(squareMetres(mesh, loops[1]), -1);
  for (const auto& loop : loops) expectNoVertexTwice(loop);
}

TEST(OutlineOf, HolesThatTouchInAVertexAreTwoLoops) {
  const Mesh mesh = squares(4, 4);
  const auto loops = outlineOf(mesh, allFacesBut(mesh, {5, 10}));
  ASSERT_EQ(loops.size(), 3u);
  EXPECT_DOUBLE_EQ(squareMetres(mesh, loops[0]), 16);
  for (const auto& loop : loops) expectNoVertexTwice(loop);
}

TEST(MakeMesh, FacesFillTheirOutlineWithoutOverlap) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    MeshStyle style;
    style.columns = 4;
    style.insets = 5;
    style.splitFraction = 0.3;
    style.nearVertices = 3;
    style.turn = static_cast<Turn>(seed % 4);
    const Mesh mesh = makeMesh(random, style);
    EXPECT_TRUE(isClean(mesh)) << seed;
    double area = 0;
    for (const Face& face : mesh.faces) area += areaOf(mesh, face);
    const auto loops = outlineOf(mesh, allFacesBut(mesh, {}));
    ASSERT_EQ(loops.size(), 1u) << seed;
    EXPECT_NEAR(area, squareMetres(mesh, loops[0]), 1e-9) << seed;
  }
}

TEST(IsClean, RefusesCrossingEdges) {
  Mesh mesh = squares(2, 1);
  mesh.vertices[1] = {mesh.vertices[5].x, mesh.vertices[5].y + kMetre};
  EXPECT_FALSE(isClean(mesh));
}

TEST(IsClean, RefusesVerticesThatAreTooNear) {
  Mesh mesh = squares(2, 1);
  mesh.vertices[1] = {mesh.vertices[0].x + kMillimetre, mesh.vertices[0].y};
  EXPECT_FALSE(isClean(mesh));
}

}  // namespace
}  // namespace hearth::random_levels
