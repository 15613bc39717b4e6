#include "families.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "agreement/compare_level.h"
#include "support/canvas.h"
#include "truth/truth_view.h"

namespace hearth::extremes {

namespace {

constexpr double kEdgePx = 0.02;  ///< pixels so near to an edge may show either side

SectorId sameSector(SectorId id) { return id; }

std::string shotOf(const LitLevel& lit, std::size_t shot) {
  return fmt::format("{}, {}", lit.level().name, lit.level().shots[shot].name);
}

/// Expects the same textures but on edges. `columnOf` is where a column of the expected picture is
/// in the actual one.
template <typename ColumnOf>
void expectSameTexturesOffEdges(const LitLevel& expected, const LitLevel& actual,
                                ColumnOf&& columnOf) {
  ASSERT_EQ(expected.level().shots.size(), actual.level().shots.size());
  for (std::size_t shot = 0; shot < expected.level().shots.size(); ++shot) {
    const TruthView truth(expected.level(), expected.loaded().textures,
                          expected.level().shots[shot]);
    const Image before = expected.look(shot, LightMode::None);
    const Image after = actual.look(shot, LightMode::None);
    for (int j = 0; j < before.height(); ++j)
      for (int i = 0; i < before.width(); ++i)
        ASSERT_TRUE(before.at(i, j) == after.at(columnOf(i, before.width()), j) ||
                    !truth.isClear(i + 0.5, j + 0.5, kEdgePx))
            << shotOf(expected, shot) << " at " << i << ',' << j;
  }
}

void expectSameTexturesOffEdges(const LitLevel& expected, const LitLevel& actual) {
  expectSameTexturesOffEdges(expected, actual, [](int column, int) { return column; });
}

/// The light of a level where a picture of its textures is as another one; where not, that light.
Image withLightOf(const LitLevel& lit, std::size_t shot, const Image& textures,
                  const Image& light) {
  const Image itsTextures = lit.look(shot, LightMode::None);
  Image its = lit.look(shot, LightMode::Only);
  for (int j = 0; j < its.height(); ++j)
    for (int i = 0; i < its.width(); ++i)
      if (!(itsTextures.at(i, j) == textures.at(i, j))) its.at(i, j) = light.at(i, j);
  return its;
}

/// Where the same shows: on the edge of a hole of a masked middle texture another surface may.
LightDifference lightDifference(const LitLevel& expected, const LitLevel& actual) {
  LightDifference sum;
  for (std::size_t shot = 0; shot < expected.level().shots.size(); ++shot) {
    const Image before = expected.look(shot, LightMode::Only);
    const Image after = withLightOf(actual, shot, expected.look(shot, LightMode::None), before);
    sum.over2 += compare(before, after).over2;
    sum.pixels += std::int64_t{before.width()} * before.height();
  }
  return sum;
}

/// Expects what the reference shows, and how it is lit.
void expectAgreement(const LitLevel& lit) {
  const agreement::Tally tally = agreement::compareLevel(lit.loaded(), lit.level().name, 4);
  EXPECT_EQ(tally.holes, 0) << tally.firstMiss;
  EXPECT_EQ(tally.missed(), 0) << tally.firstMiss;
}

/// The lit surface that a piece of it was cut from; sectors are the same in both levels.
std::optional<SurfaceId> wholeOf(const LitLevel& whole, const Surface& piece,
                                 const LitSurface& lit) {
  const std::vector<Vec2> border = lit.outline.loops().front();
  Vec2 middle;
  for (const Vec2 p : border) middle = middle + (1.0 / static_cast<double>(border.size())) * p;
  const Vec3 p = lit.toWorld(middle);
  for (const SurfaceId id : whole.scene().shownSurfaces()) {
    const Surface& surface = whole.level()[id];
    const auto& other = whole.light().surfaces[id.index()];
    if (!other || surface.kind != piece.kind || surface.sector != piece.sector) continue;
    if (std::abs(other->distanceInFront(p)) > 1e-6 || dot(other->normal, lit.normal) < 0.5)
      continue;
    if (other->outline.contains(other->grid.toTexels(p))) return id;
  }
  return std::nullopt;
}

/// Expects of every texel of a piece whose centre is on it the byte that the whole has there. False
/// where the whole has other texels.
bool expectSameTexels(const LitLevel& before, const LitLevel& after, SurfaceId id) {
  const LitSurface& piece = *after.light().surfaces[id.index()];
  const Lightmap& map = *after.light().lightmaps[id.index()];
  const auto whole = wholeOf(before, after.level()[id], piece);
  // Walls that are in line apart from authors' noise are one run or not by the shortest of them.
  if (!whole || before.light().surfaces[whole->index()]->grid != piece.grid) return false;
  const auto& wholeMap = before.light().lightmaps[whole->index()];
  EXPECT_TRUE(wholeMap.has_value());
  if (!wholeMap) return true;
  for (int j = map.rect.j0; j < map.rect.j0 + map.rect.height; ++j)
    for (int i = map.rect.i0; i < map.rect.i0 + map.rect.width; ++i)
      for (int channel = 0; channel < map.channels; ++channel)
        EXPECT_TRUE(!piece.outline.contains({i + 0.5, j + 0.5}) ||
                    map.at(i, j, channel) == wholeMap->at(i, j, channel))
            << before.level().name << ": " << name(after.level()[id].kind) << ", texel " << i << ','
            << j;
  return true;
}

/// Whether a light lies in the plane of a wall as authors can write it: within a micrometre.
bool hasLightInLineWithWall(const Level& level) {
  return std::ranges::any_of(level.lights, [&](const LightSource& light) {
    return std::ranges::any_of(level.segments, [&](const Segment& wall) {
      const Vec2 along = (1 / wall.length) * (wall.p1 - wall.p0);
      if (light.isArea()) return false;
      if (light.sun) return std::abs(cross(along, light.sun->direction().xy())) < 2e-6;
      return std::abs(cross(along, light.position.xy() - wall.p0)) < 2e-6;
    });
  });
}

/// Whether the same walls make the same runs, and so have grids alike.
bool haveSameTexels(const LitLevel& some, const LitLevel& others) {
  const auto areAlike = [&](SurfaceId someId, SurfaceId othersId) {
    const auto& a = some.light().surfaces[someId.index()];
    const auto& b = others.light().surfaces[othersId.index()];
    return a.has_value() == b.has_value() &&
           (!a || (a->texels == b->texels && a->continuations.size() == b->continuations.size()));
  };
  return std::ranges::equal(some.scene().shownSurfaces(), others.scene().shownSurfaces(), areAlike);
}

/// What a frame looks at, in counts.
FrameStats workOf(const LitLevel& lit, std::size_t shot) {
  FrameScratch scratch;
  const Camera camera = cameraOf(lit.level().shots[shot]);
  test::Canvas picture(camera.width, camera.height);
  lit.renderer().draw(camera, LightMode::Both, scratch, picture);
  return scratch.found();
}

}  // namespace

void expectNamesMeanNothing(std::uint64_t seed) {
  const LevelFiles files = randomFiles(seed);
  const LitLevel before(files);
  const LitLevel after(renamed(files));
  expectSamePictures(before, after);
  expectSameLight(before, after, sameSector);
}

LightDifference expectOrderMeansLittle(std::uint64_t seed) {
  const LevelFiles files = randomFiles(seed);
  const LitLevel before(files);
  const LitLevel after(reordered(files));
  for (std::size_t shot = 0; shot < before.level().shots.size(); ++shot)
    EXPECT_EQ(before.look(shot, LightMode::None), after.look(shot, LightMode::None))
        << shotOf(before, shot);
  return lightDifference(before, after);
}

void expectCutsMeanNothing(std::uint64_t seed) {
  const LevelFiles files = withoutSky(withPlainSidewalls(randomFiles(seed)));
  const LitLevel before(files);
  const LitLevel after(withWallsCut(files));
  for (std::size_t shot = 0; shot < before.level().shots.size(); ++shot)
    EXPECT_EQ(before.look(shot, LightMode::None), after.look(shot, LightMode::None))
        << shotOf(before, shot);
  std::size_t compared = 0;
  for (const SurfaceId id : after.scene().shownSurfaces())
    if (after.light().surfaces[id.index()] && after.light().lightmaps[id.index()] &&
        expectSameTexels(before, after, id))
      ++compared;
  EXPECT_GE(compared * 10, after.light().stats.litSurfaces * 9) << seed;
}

void expectThreadsMeanNothing(std::uint64_t seed) {
  const LevelFiles files = randomFiles(seed);
  const LitLevel one(files);
  const Camera camera = cameraOf(one.level().shots[1]);
  for (const int threads : {2, 7, 64}) {
    const LitLevel many(files, threads);
    expectSameLight(one, many, sameSector);
    FrameScratch scratch;
    test::Canvas picture(camera.width, camera.height);
    Workers workers(threads);
    many.renderer().draw(camera, LightMode::Both, scratch, picture, &workers);
    EXPECT_EQ(picture.image(), one.look(1, LightMode::Both))
        << seed << ", " << threads << " threads";
  }
}

void expectPlaceMeansNothing(std::uint64_t seed, double metres) {
  const LevelFiles files = randomFiles(seed);
  expectSamePictures(LitLevel(moved(files, {0, 0, 0})),
                     LitLevel(moved(files, {metres, -3 * metres, metres})));
}

LightDifference expectDistanceMeansLittle(std::uint64_t seed, double metres) {
  const LevelFiles files = randomFiles(seed);
  const LitLevel before(moved(files, {0, 0, 0}));
  const LitLevel after(moved(files, {metres, -3 * metres, metres}));
  expectSameTexturesOffEdges(before, after);
  return lightDifference(before, after);
}

bool hasLightOfSky(std::uint64_t seed) {
  const LevelFiles files = randomFiles(seed);
  return withoutSky(files).lights != files.lights;
}

LightDifference expectSmallnessMeansLittle(std::uint64_t seed) {
  const LevelFiles files = withPointSuns(withoutThings(randomFiles(seed)));
  const LitLevel before(files);
  const LitLevel after(scaled(files, 1e-3));
  expectSameTexturesOffEdges(before, after);
  return lightDifference(before, after);
}

bool expectLargenessMeansNothing(std::uint64_t seed) {
  const LevelFiles files = withoutThings(randomFiles(seed));
  const LevelFiles large = scaled(files, 1e3);
  if (!tryLoad(large).loaded) return false;
  const LitLevel before(files);
  const LitLevel after(large);
  if (hasLightInLineWithWall(before.level()) || !haveSameTexels(before, after)) return false;
  expectSameTexturesOffEdges(before, after);
  EXPECT_EQ(lightDifference(before, after).over2, 0) << seed;
  return true;
}

void expectDirectionMeansNothing(std::uint64_t seed, double degrees) {
  const LevelFiles files = withPlainFlats(randomFiles(seed));
  const LitLevel before(files);
  const LitLevel after(turned(files, degrees));
  expectSameTexturesOffEdges(before, after);
  expectAgreement(after);
}

void expectHandednessMeansNothing(std::uint64_t seed) {
  const LevelFiles files = withoutThings(withPlainColors(randomFiles(seed)));
  const LitLevel before(files);
  const LitLevel after(mirrored(files));
  expectSameTexturesOffEdges(before, after,
                             [](int column, int width) { return width - 1 - column; });
  expectAgreement(after);
}

void expectUnseenSectorMeansNothing(std::uint64_t seed) {
  const LevelFiles files = randomFiles(seed);
  const LitLevel before(files);
  const LitLevel after(withUnseenSector(files));
  expectSamePictures(before, after);
  for (std::size_t shot = 0; shot < before.level().shots.size(); ++shot)
    EXPECT_EQ(workOf(before, shot), workOf(after, shot)) << shotOf(before, shot);
  expectSameLight(before, after, sameSector);
}

}  // namespace hearth::extremes
