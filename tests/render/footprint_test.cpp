// How many texels a pixel covers: summed over all pixels of a surface these are the surface's.

#include "render/footprint.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/group_mapping.h"
#include "render/renderer.h"
#include "render/visibility.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr int kTextureSize = 64;
const Texture kTexture(Image(kTextureSize, kTextureSize));

/// Calls `visit(span, mapping, footprint, raySlope)` for every pixel of surfaces of a kind.
template <typename Visit>
void forEachPixel(const Scene& scene, const Camera& camera, SurfaceKind kind, SectorId sector,
                  Visit&& visit) {
  VisibilityScratch scratch;
  const Projection projection = projectionFor(scene, camera);
  findVisibleSpans(scene, camera, projection, scratch).forEachSpan([&](const Span& span) {
    const Surface& surface = scene[span.surface];
    if (surface.kind != kind || surface.sector != sector) return;
    const SpanMapping mapping = mappingOf(scene, projection, span, &kTexture, {});
    const Footprint footprint(scene, projection, span, kTexture, mapping);
    for (int row = span.rowBegin; row < span.rowEnd; ++row)
      visit(span, mapping, footprint, projection.raySlopeAt(row + 0.5));
  });
}

double texelsOf(const Scene& scene, const Camera& camera, SurfaceKind kind, SectorId sector) {
  double texels = 0;
  forEachPixel(
      scene, camera, kind, sector,
      [&](const Span&, const SpanMapping& mapping, const Footprint& footprint, double raySlope) {
        texels += footprint.texelsAt(mapping.parameterAt(raySlope));
      });
  return texels;
}

/// A hall with a dais in the east, 3 by 2 m, whose floor and end wall are seen as a whole.
LoadedLevel hallWithDais(std::string_view slope) {
  const std::string solid = "{'texture':'#808080'}";
  return test::levelFrom(fmt::format(
      "{{'sectors':{{{},{}}}}}",
      test::sectorText(
          "hall", "0,0, 5,0, 5,2, 5,4, 5,6, 0,6", 0, 4,
          fmt::format("[{0},{0},{{'next':'dais','texture':'#808080'}},{0},{0},{0}]", solid)),
      test::sectorText("dais", "5,4, 5,2, 8,2, 8,4", 0.5, 4,
                       fmt::format("[{{'next':'hall','texture':'#808080'}},{0},{0},{0}]", solid),
                       slope)));
}

const Camera kFromTheWest{SectorId(0), {1, 3.4, 2.5}, 10, -12, 90, 640, 400};
constexpr double kTexelsPerMetre2 = kTextureSize * kTextureSize;

TEST(Footprint, OfAFloorCoversIt) {
  const LoadedLevel loaded = hallWithDais("");
  const double texels = texelsOf(loaded.scene(), kFromTheWest, SurfaceKind::Floor, SectorId(1));
  EXPECT_NEAR(texels / (6 * kTexelsPerMetre2), 1, 0.02);
}

TEST(Footprint, OfASlopeCoversTheMapBelowIt) {
  const LoadedLevel loaded =
      hallWithDais(",'slopeFloor':{'z':[0.5,0.5,1.3,1.3],'sidewall':{'name':'#808080'}}");
  const double texels =
      texelsOf(loaded.scene(), kFromTheWest, SurfaceKind::SlopeFloor, SectorId(1));
  EXPECT_NEAR(texels / (6 * kTexelsPerMetre2), 1, 0.02);
}

TEST(Footprint, OfAWallSeenAtAnAngleCoversIt) {
  const LoadedLevel loaded =
      test::levelFrom("{'sectors':{" + test::sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3) + "}}");
  // Of all walls only the eastern one is seen as a whole.
  const Camera camera{SectorId(0), {1, 1, 1.2}, 20, 0, 110, 640, 400};
  double texels = 0;
  forEachPixel(
      loaded.scene(), camera, SurfaceKind::Solid, SectorId(0),
      [&](const Span& span, const SpanMapping&, const Footprint& footprint, double raySlope) {
        const Segment& wall = loaded.level[*loaded.level[span.surface].segment];
        if (wall.p0.x == 6 && wall.p1.x == 6) texels += footprint.texelsAt(raySlope);
      });
  EXPECT_NEAR(texels / (4 * 3 * kTexelsPerMetre2), 1, 0.02);
}

TEST(Footprint, OfASkyIsWhatLiesBetweenNeighbouringPixels) {
  const LoadedLevel loaded = test::levelFrom(
      "{'sectors':{'yard':{'loops':{'border':{'v':[0,0, 9,0, 9,9, 0,9],'walls':[{'texture':"
      "'#808080'},{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'}]}},'floor':{'z'"
      ":0,'texture':'#808080'},'ceiling':{'z':2,'texture':'#808080',"
      "'parallax':true}}}}");
  const Camera camera{SectorId(0), {4, 4, 1}, 137, 30, 100, 320, 200};
  const Projection projection = projectionFor(loaded.scene(), camera);
  int pixels = 0;
  forEachPixel(
      loaded.scene(), camera, SurfaceKind::SkyCeiling, SectorId(0),
      [&](Span span, const SpanMapping& mapping, const Footprint& footprint, double raySlope) {
        const double down =
            mapping.v.at(raySlope - 1 / projection.distancePx()) - mapping.v.at(raySlope);
        span.column += 1;
        const SpanMapping next = mappingOf(loaded.scene(), projection, span, &kTexture, {});
        const double across = next.u.at(raySlope) - mapping.u.at(raySlope);
        EXPECT_NEAR(footprint.texelsAt(raySlope) / std::abs(across * down), 1, 0.02);
        ++pixels;
      });
  EXPECT_GT(pixels, 1000);
}

TEST(Footprint, ofAPlaneThroughTheEyeIsATexelAtTheEye) {
  Span span{};
  span.surface = SurfaceId(0);
  const LoadedLevel loaded = hallWithDais("");
  SpanMapping mapping;
  mapping.isPlane = true;  // 0 m above the eye
  const Projection projection(kFromTheWest, kFromTheWest.eye);
  EXPECT_EQ(Footprint(loaded.scene(), projection, span, kTexture, mapping).mipLevelAt(0), 0);
}

TEST(Footprint, ChoosesTheLevelWhoseTexelsAreNearestToAPixelInArea) {
  const LoadedLevel loaded = hallWithDais("");
  Camera camera = kFromTheWest;
  camera.width = 64;
  camera.height = 40;
  int last = 0;
  forEachPixel(
      loaded.scene(), camera, SurfaceKind::Floor, SectorId(0),
      [&](const Span&, const SpanMapping& mapping, const Footprint& footprint, double raySlope) {
        const double parameter = mapping.parameterAt(raySlope);
        const double pixels = std::log2(footprint.texelsAt(parameter)) / 2;
        const int level = footprint.mipLevelAt(parameter);
        EXPECT_EQ(level, std::max(0L, std::lround(pixels))) << pixels;
        last = std::max(last, level);
      });
  EXPECT_GE(last, 3);
}

}  // namespace
}  // namespace hearth
