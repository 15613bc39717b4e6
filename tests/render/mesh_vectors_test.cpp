// Triangles in perspective: where they are covered, how deep, and where on their image. See
// mesh_vectors.h.

#include "mesh_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "render/mesh_fronts.h"
#include "support/level_text.h"
#include "things_in_halls.h"

namespace hearth {
namespace {

using test::frustum;
using test::kPrinted;
using test::kPrintedPixels;
using test::pixelOf;
using test::projectionOf;
using test::seen;

/// A face as the renderer finds it.
class SeenFace {
 public:
  SeenFace(const Projection& projection, int width, const std::array<Vec3, 3>& corners,
           const std::array<Vec2, 3>& image = {}) {
    Mesh mesh;
    mesh.isTwoSided = true;  // whichever way round the corners run
    mesh.faceCount = 1;
    level_.meshes = {mesh};
    level_.meshFaces = {{corners, image, TextureId(0)}};
    level_.faceTrees.emplace_back(level_.meshFaces);
    const PictureRect picture{{0, width}, 0, width};
    fronts_.begin(level_, picture);
    fronts_.find({level_, geometry_}, projection, 0, picture);
  }

  bool isSeen() const { return !fronts_.frontsOf(0).empty(); }
  const FaceFront& front() const { return fronts_.frontsOf(0).front(); }

  /// Of the ray that goes so far to the right and up per metre ahead.
  double depth(double slant, double slope) const {
    return 1 / dot(front().nearness, Vec3{1, slant, slope});
  }
  Vec2 image(double slant, double slope) const {
    const Vec3 at = depth(slant, slope) * Vec3{1, slant, slope};
    const FaceFront& face = front();
    return {face.u.atEye + dot(face.u.perMetre, at), face.v.atEye + dot(face.v.perMetre, at)};
  }
  /// How far the ray is inside of the edge that is nearest; negative outside.
  double inside(double slant, double slope) const {
    double least = 1e300;
    for (const Vec3 edge : front().edges)
      least = std::min(least, dot(edge, Vec3{1, slant, slope}) / length(edge));
    return least;
  }

 private:
  Level level_;
  Geometry geometry_;
  MeshFronts fronts_;
};

// --- Behind the eye ------------------------------------------------------------------------------

TEST(MeshVectors, whatIsBehindTheEyeDoesNotShowMirrored) {
  const Projection projection = frustum(1280, 720);
  // Divided by its depth, it would be in pixel (515.2923, 484.7077).
  const Vec2 mirrored = pixelOf(projection, seen(1, 1, -5));
  EXPECT_NEAR(mirrored.x, 515.2923, kPrintedPixels);
  EXPECT_NEAR(mirrored.y, 484.7077, kPrintedPixels);
  EXPECT_FALSE(
      SeenFace(projection, 1280, {seen(1, 1, -5), seen(0, 1, -5), seen(1, 0, -5)}).isSeen());
  // The part ahead of a face that reaches behind the eye shows where it is.
  const SeenFace through(projection, 1280, {seen(1, 1, -5), seen(0, -1, 5), seen(2, -2, 5)});
  ASSERT_TRUE(through.isSeen());
  EXPECT_LT(through.inside(projection.slantOf(mirrored.x), projection.raySlopeAt(mirrored.y)), 0);
  EXPECT_GT(through.inside(0.25, -0.3125), 0);
}

// --- Triangles -----------------------------------------------------------------------------------

/// Corners that show in these pixels of a picture of 640 x 480, at these depths.
std::array<Vec3, 3> cornersIn(const Projection& projection, const std::array<Vec2, 3>& pixels,
                              const std::array<double, 3>& depths) {
  std::array<Vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] =
        depths[i] * Vec3{1, projection.slantOf(pixels[i].x), projection.raySlopeAt(pixels[i].y)};
  return corners;
}

constexpr std::array<Vec2, 3> kTriangle = {Vec2{200, 50}, {150, 300}, {500, 450}};

TEST(MeshVectors, theLongEdgeOfATrianglePassesBesideItsMiddleCornerHere) {
  const Projection projection = projectionOf(640, 480, 90);
  const SeenFace face(projection, 640, cornersIn(projection, kTriangle, {3, 3, 3}));
  const auto insideAt = [&](double column, double row) {
    return face.inside(projection.slantOf(column), projection.raySlopeAt(row));
  };
  EXPECT_NEAR(insideAt(387.5, 300), 0, 1e-12);
  EXPECT_GT(insideAt(387.5 - 0.01, 300), 0);
  EXPECT_LT(insideAt(387.5 + 0.01, 300), 0);
  EXPECT_NEAR(insideAt(150, 300), 0, 1e-12);
}

TEST(MeshVectors, coverThePixelsWhoseCentresTheTriangleHolds) {
  const Projection projection = projectionOf(640, 480, 90);
  const SeenFace face(projection, 640, cornersIn(projection, kTriangle, {3, 3, 3}));
  const auto columns = [&](int row) {
    std::vector<int> covered;
    for (int column = 0; column < 640; ++column)
      if (face.inside(projection.slantOf(column + 0.5), projection.raySlopeAt(row + 0.5)) >= 0)
        covered.push_back(column);
    return std::pair(covered.front(), covered.back());
  };
  // Above and below the line of the middle corner: 150.1 to 387.125, and 151.17 to 387.875.
  EXPECT_EQ(columns(299), std::pair(150, 386));
  EXPECT_EQ(columns(300), std::pair(151, 387));
}

TEST(MeshVectors, barycentricCoordinatesAreThese) {
  const Projection projection = projectionOf(640, 480, 90);
  // At one depth, u and v are the weights of the first two corners.
  const SeenFace face(projection, 640, cornersIn(projection, kTriangle, {3, 3, 3}),
                      {Vec2{1, 0}, {0, 1}, {0, 0}});
  struct Place {
    Vec2 pixel;
    Vec3 weights;
  };
  for (const auto& [pixel, weights] :
       {Place{{200, 50}, {1, 0, 0}}, Place{{150, 300}, {0, 1, 0}}, Place{{500, 450}, {0, 0, 1}},
        Place{{850 / 3.0, 800 / 3.0}, {1 / 3.0, 1 / 3.0, 1 / 3.0}},
        Place{{250, 200}, {0.526316, 0.263158, 0.210526}}}) {
    const Vec2 found = face.image(projection.slantOf(pixel.x), projection.raySlopeAt(pixel.y));
    EXPECT_NEAR(found.x, weights.x, kPrinted) << pixel.x;
    EXPECT_NEAR(found.y, weights.y, kPrinted) << pixel.x;
    EXPECT_NEAR(1 - found.x - found.y, weights.z, kPrinted) << pixel.x;
  }
}

// --- Perspective-correct textures ----------------------------------------------------------------

TEST(MeshVectors, halfwayAlongAnEdgeInThePictureIsNotHalfwayAlongTheTexture) {
  struct Edge {
    double near, far, u, depth;
  };
  for (const auto& [near, far, u, depth] : {Edge{1, 4, 0.2, 1.6}, Edge{2, 6, 0.25, 3}}) {
    const Projection projection = projectionOf(640, 480, 90);
    const SeenFace face(
        projection, 640,
        cornersIn(projection, {Vec2{100, 300}, {500, 300}, {300, 100}}, {near, far, far}),
        {Vec2{0, 0}, {1, 0}, {0, 1}});
    const double slant = projection.slantOf(300);
    const double slope = projection.raySlopeAt(300);
    EXPECT_NEAR(face.image(slant, slope).x, u, kPrinted);
    EXPECT_NEAR(face.depth(slant, slope), depth, kPrinted);
  }
}

TEST(MeshVectors, theMiddleOfATriangleInThePictureIsNearTheNearCorner) {
  const Projection projection = projectionOf(640, 480, 90);
  const SeenFace face(projection, 640, cornersIn(projection, kTriangle, {2, 4, 8}),
                      {Vec2{0, 0}, {1, 0}, {1, 0}});
  const double slant = projection.slantOf(850 / 3.0);
  const double slope = projection.raySlopeAt(800 / 3.0);
  EXPECT_NEAR(face.image(slant, slope).x, 0.428571, kPrinted);
  EXPECT_NEAR(face.depth(slant, slope), 3.428571, kPrinted);
}

TEST(MeshVectors, oneOverTheDepthIsWhatChangesEvenlyAlongALine) {
  const Projection projection = projectionOf(640, 480, 90);
  const SeenFace face(projection, 640,
                      cornersIn(projection, {Vec2{100, 240}, {500, 240}, {300, 100}}, {4, 8, 8}));
  const double slope = projection.raySlopeAt(240);
  // 1 - 1/depth from 0.75 to 0.875, evenly.
  EXPECT_NEAR(1 - 1 / face.depth(projection.slantOf(100), slope), 0.75, kPrinted);
  EXPECT_NEAR(1 - 1 / face.depth(projection.slantOf(300), slope), 0.8125, kPrinted);
  EXPECT_NEAR(1 - 1 / face.depth(projection.slantOf(500), slope), 0.875, kPrinted);
}

// --- Clipping ------------------------------------------------------------------------------------

TEST(MeshVectors, aPicturesBorderCutsAFaceHere) {
  const Projection projection = projectionOf(640, 640, 60);
  const SeenFace face(projection, 640, {seen(0, 0, 5), seen(0, 1, 5), seen(10, 0, 5)},
                      {Vec2{0, 0}, {0, 1}, {1, 0}});
  ASSERT_TRUE(face.isSeen());
  EXPECT_EQ(face.front().columns.end, 640);
  const double border = projection.slantOf(640);
  EXPECT_NEAR(5 * border, 2.886751, kPrinted) << "metres to the right";
  EXPECT_NEAR(face.depth(border, 0), 5, kPrinted);
  EXPECT_NEAR(face.image(border, 0).x, 0.288675, kPrinted);
  EXPECT_NEAR(face.image(border, 0).y, 0, kPrinted);
  const double slope = 0.711325 / 5;
  EXPECT_NEAR(face.inside(border, slope), 0, kPrinted) << "the upper edge";
  EXPECT_NEAR(face.image(border, slope).x, 0.288675, kPrinted);
  EXPECT_NEAR(face.image(border, slope).y, 0.711325, kPrinted);
}

/// Of the face at a depth of 1 m, where a near plane would cut it, and nearer.
void expectOneMetreDeepAt(const std::array<Vec3, 3>& corners, double right, double up,
                          double nearer) {
  const SeenFace face(projectionOf(640, 480, 90), 640, corners);
  ASSERT_TRUE(face.isSeen());
  for (const Vec2 ray : {Vec2{right, 0}, {0, up}}) {
    EXPECT_NEAR(face.depth(ray.x, ray.y), 1, kPrinted);
    EXPECT_NEAR(face.inside(ray.x, ray.y), 0, kPrinted) << "on an edge";
  }
  // Nothing nearer is cut off.
  EXPECT_GT(face.inside(nearer, nearer), 0);
  EXPECT_LT(face.depth(nearer, nearer), 1);
}

TEST(MeshVectors, facesPassOneMetreHereAndShowNearerThanThatToo) {
  expectOneMetreDeepAt({seen(0, 0, 0.5), seen(0, 1, 3), seen(1, 0, 3)}, 0.2, 0.2, 0.01);
  // Two corners are in the plane of the eye: far to the side of the picture.
  expectOneMetreDeepAt({seen(0, 0, 3), seen(0, 1, 0), seen(1, 0, 0)}, 2 / 3.0, 2 / 3.0, 10);
}

TEST(MeshVectors, aFaceWithACornerInTheClippingPlaneIsNotLost) {
  const Projection projection = projectionOf(640, 480, 90);
  const SeenFace face(projection, 640, {seen(0, 0, 1), seen(0, 1, 3), seen(1, 0, 3)});
  ASSERT_TRUE(face.isSeen());
  EXPECT_NEAR(face.depth(0, 0), 1, kPrinted);
  EXPECT_GT(face.inside(0.1, 0.1), 0);
}

// --- Shades --------------------------------------------------------------------------------------

TEST(MeshVectors, coloursTimesLightAreRoundedNotCut) {
  struct Shade {
    std::string color;
    double light;
    Rgb shown;
  };
  for (const auto& [color, light, shown] :
       {Shade{"#ffffff", 0.5, {128, 128, 128}},  // 127.5
        Shade{"#ff8040", 0.25, {64, 32, 16}},    // 63.75, 32, 16
        Shade{"#ffa500", 0.5, {128, 83, 0}},     // 127.5, 82.5, 0
        Shade{"#ffffff", 0.7071, {180, 180, 180}}, Shade{"#ffffff", 0, {0, 0, 0}}}) {
    const LoadedLevel loaded = test::levelFrom(
        "{'light':" + std::to_string(light) +
            ",'things':[{'mesh':'wall.obj','x':4,'y':0,'z':2,'texture':'" + color +
            "'}],'sectors':{" + test::hall() + "}}",
        "[]", {{"wall.obj", "v 0 -9 9\nv 0 -9 -9\nv 0 9 -9\nv 0 9 9\nf 1 4 3 2\n"}});
    EXPECT_EQ(test::drawn(loaded, test::lookingEast()).at(32, 32), shown) << color << light;
  }
}

}  // namespace
}  // namespace hearth
