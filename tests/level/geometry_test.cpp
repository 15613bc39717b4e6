// That geometry whose flats were moved is that of a level which is authored so.

#include "level/geometry.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "light/bakery.h"
#include "light/saved_bake.h"
#include "load/load.h"
#include "random_levels/random.h"
#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "rooms_with_door.h"
#include "support/temporary_folder.h"
#include "walk/walker.h"

namespace hearth {
namespace {

/// "0..1 lower step, 1..2 opening, ...".
std::string piecesOf(const Scene& scene, const Segment& segment) {
  std::string text;
  for (const WallPiece& piece : scene.piecesOf(segment)) {
    const SurfaceId* surface = std::get_if<SurfaceId>(&piece.content);
    text += fmt::format("{}{}..{} {}", text.empty() ? "" : ", ", piece.zBottom, piece.zTop,
                        surface ? name(scene[*surface].kind) : "opening");
  }
  return text;
}

/// "bottom..top next" of each.
std::string lightOpeningsOf(const Scene& scene, const Segment& segment) {
  std::string text;
  for (const LightOpening& opening : scene.lightOpeningsOf(segment)) {
    text += fmt::format("{}..{} {}/{}", opening.zBottom, opening.zTop, opening.next.value,
                        opening.twin.value);
    for (const SurfaceId id : scene.maskedMiddlesIn(opening)) text += fmt::format(" #{}", id.value);
    text += ';';
  }
  return text;
}

void expectSame(const Level& level, const Geometry& found, const Geometry& expected) {
  EXPECT_EQ(found.sectors, expected.sectors);
  EXPECT_EQ(found.segments, expected.segments);
  EXPECT_EQ(found.surfaces, expected.surfaces);
  const Scene a(level, found);
  const Scene b(level, expected);
  for (const Segment& segment : level.segments) {
    EXPECT_TRUE(std::ranges::equal(a.piecesOf(segment), b.piecesOf(segment))) << segment.id;
    EXPECT_EQ(lightOpeningsOf(a, segment), lightOpeningsOf(b, segment)) << segment.id;
  }
}

TEST(MoveFlats, shutsADoorFromBothSides) {
  LoadedLevel rooms = roomsWithDoor();
  const Segment& wall = rooms.level.segments[kWallToDoor];
  EXPECT_EQ(piecesOf(rooms.scene(), wall), "0..2 opening, 2..3 upper step");
  EXPECT_EQ(lightOpeningsOf(rooms.scene(), wall), "0..2 1/7;");

  moveFlats(rooms.level, kDoor, {0, 0.5}, rooms.geometry);
  EXPECT_EQ(piecesOf(rooms.scene(), wall), "0..0.5 opening, 0.5..3 upper step");
  EXPECT_EQ(lightOpeningsOf(rooms.scene(), wall), "0..0.5 1/7;");

  moveFlats(rooms.level, kDoor, {0, 0}, rooms.geometry);
  EXPECT_EQ(piecesOf(rooms.scene(), wall), "0..3 upper step");
  EXPECT_EQ(lightOpeningsOf(rooms.scene(), wall), "");
  for (const Segment& segment : rooms.level.segmentsOf(rooms.level[kDoor]))
    EXPECT_EQ(piecesOf(rooms.scene(), segment), "") << "a shut door has no air";
}

TEST(MoveFlats, keepsTheNumbersOfSurfaces) {
  LoadedLevel rooms = roomsWithDoor();
  const auto upperStep = [&] {
    return std::get<SurfaceId>(
        rooms.scene().piecesOf(rooms.level.segments[kWallToDoor]).back().content);
  };
  const SurfaceId before = upperStep();
  moveFlats(rooms.level, kDoor, {1, 1}, rooms.geometry);
  EXPECT_EQ(upperStep(), before);
  EXPECT_EQ(rooms.scene().geometryOf(before).zRef, 1) << "it grows from its bottom edge";
}

TEST(MoveFlatsDeathTest, stopsWhereAStepWouldShowWithoutATexture) {
  LoadedLevel rooms = roomsWithDoor("'upper':'#808080'");
  EXPECT_DEATH(moveFlats(rooms.level, kDoor, {1, 2}, rooms.geometry), "lower step");
}

bool mayMove(const Flat& flat, const std::optional<Slope>& slope) {
  return !flat.isSky && !flat.flatPortal && !slope;
}

/// Whether the stacks of a sector keep their order at these heights.
bool holdStacks(const Level& level, const Sector& sector, SectorGeometry heights) {
  return std::ranges::all_of(level.segmentsOf(sector), [&](const Segment& segment) {
    const Stack* stack = std::get_if<Stack>(&segment.wall);
    if (!stack) return true;
    const std::size_t last = stack->subWalls.size() - 1;
    return last == 0 || stack->topOf(last - 1, heights.zFloor, heights.zCeiling) < heights.zCeiling;
  });
}

/// Other heights for a sector's flats, where these may move: often those of another sector, so that
/// flats meet.
std::optional<SectorGeometry> otherHeights(const Level& level, const Sector& sector,
                                           random_levels::Random& random) {
  const Sector& model = level.sectors[random.below(level.sectors.size())];
  SectorGeometry heights{sector.floor.z, sector.ceiling.z};
  if (mayMove(sector.floor, sector.floorSlope) && random.chance(0.7))
    heights.zFloor = random.chance(0.5) ? model.floor.z : sector.floor.z + random.real(-2, 2);
  if (mayMove(sector.ceiling, sector.ceilingSlope) && random.chance(0.7))
    heights.zCeiling = random.chance(0.5) ? model.ceiling.z : sector.ceiling.z + random.real(-2, 2);
  const bool areGood = heights.zFloor <= heights.zCeiling && holdStacks(level, sector, heights);
  return areGood ? std::optional(heights) : std::nullopt;
}

struct Authored {
  Level level;
  Geometry geometry;

  Scene scene() const { return {level, geometry}; }
};

/// A level whose author gave a sector these heights; none where a step would show that has no
/// texture.
std::optional<Authored> authoredAt(Level level, SectorId id, SectorGeometry heights) {
  level[id].floor.z = heights.zFloor;
  level[id].ceiling.z = heights.zCeiling;
  std::vector<MissingTexture> missing;
  Geometry geometry = deriveGeometry(level, missing);
  if (!missing.empty()) return std::nullopt;
  return Authored{std::move(level), std::move(geometry)};
}

class MovedFlatsOfRandomLevels : public testing::Test {
 protected:
  MovedFlatsOfRandomLevels() { EXPECT_TRUE(writeRandomLevelTextures(folder_.path() / "textures")); }

  LoadedLevel load(std::uint64_t seed) const {
    const RandomLevel level = makeRandomLevel(seed);
    EXPECT_TRUE(writeRandomLevel(folder_.path(), level));
    return loadLevel(folder_.path() / (level.name + ".json")).loaded.value();
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(MovedFlatsOfRandomLevels, giveTheGeometryOfALevelThatIsAuthoredSo) {
  int moved = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const LoadedLevel loaded = load(seed);
    Geometry geometry = loaded.geometry;
    random_levels::Random random(seed);
    for (const Sector& sector : loaded.level.sectors) {
      const auto heights = otherHeights(loaded.level, sector, random);
      if (!heights) continue;
      const auto authored = authoredAt(loaded.level, sector.id, *heights);
      if (!authored) continue;
      ++moved;
      moveFlats(loaded.level, sector.id, *heights, geometry);
      expectSame(loaded.level, geometry, authored->geometry);
      moveFlats(loaded.level, sector.id, {sector.floor.z, sector.ceiling.z}, geometry);
      expectSame(loaded.level, geometry, loaded.geometry);
    }
  }
  EXPECT_GT(moved, 300);
}

/// Whether no light or camera of a sector would be outside its air.
bool holdPositions(const Level& level, SectorId sector, SectorGeometry heights) {
  const auto isHeld = [&](SectorId in, Vec3 p) {
    return in != sector || (heights.zFloor < p.z && p.z < heights.zCeiling);
  };
  return std::ranges::all_of(level.lights,
                             [&](const LightSource& light) {
                               return !light.hasPlace() || isHeld(light.sector, light.position);
                             }) &&
         std::ranges::all_of(level.shots,
                             [&](const Shot& shot) { return isHeld(shot.sector, shot.eye); });
}

/// A level of which as many sectors as can be are moved, and one that is authored so.
struct BothWays {
  LoadedLevel loaded;
  Geometry geometry;
  Authored authored;

  Scene moved() const { return {loaded.level, geometry}; }
};

BothWays movedAtRandom(const LoadedLevel& loaded, std::uint64_t seed) {
  BothWays both{loaded, loaded.geometry, {loaded.level, loaded.geometry}};
  random_levels::Random random(seed);
  for (const Sector& sector : loaded.level.sectors) {
    const auto heights = otherHeights(loaded.level, sector, random);
    if (!heights || !holdPositions(loaded.level, sector.id, *heights)) continue;
    auto next = authoredAt(both.authored.level, sector.id, *heights);
    if (!next) continue;
    both.authored = *std::move(next);
    moveFlats(loaded.level, sector.id, *heights, both.geometry);
  }
  return both;
}

TEST_F(MovedFlatsOfRandomLevels, areLitAndDrawnLikeThoseOfALevelThatIsAuthoredSo) {
  for (std::uint64_t seed = 300; seed < 330; ++seed) {
    SCOPED_TRACE(seed);
    const BothWays both = movedAtRandom(load(seed), seed);
    BakeSettings settings = both.loaded.level.bake;
    settings.texel = 0.5;
    const BakedLight light = bake(both.moved(), settings, 2);
    const BakedLight expected = bake(both.authored.scene(), settings, 2);
    ASSERT_EQ(encodeBake(both.moved(), light, settings.texel, ""),
              encodeBake(both.authored.scene(), expected, settings.texel, ""));
    const Renderer renderer(both.moved(), both.loaded.textures, light);
    const Renderer reference(both.authored.scene(), both.loaded.textures, expected);
    for (const Shot& shot : both.loaded.level.shots)
      ASSERT_TRUE(renderer.draw(cameraOf(shot), LightMode::Both) ==
                  reference.draw(cameraOf(shot), LightMode::Both))
          << shot.name;
  }
}

/// The player walks and turns at random, and jumps now and then.
TEST_F(MovedFlatsOfRandomLevels, areWalkedOnLikeThoseOfALevelThatIsAuthoredSo) {
  for (std::uint64_t seed = 400; seed < 430; ++seed) {
    SCOPED_TRACE(seed);
    const BothWays both = movedAtRandom(load(seed), seed);
    random_levels::Random random(seed);
    const Shot& start = both.loaded.level.shots.front();
    Walker walker = walkerAt(both.moved(), start.sector, start.eye, start.angle, 0);
    Walker reference = walkerAt(both.authored.scene(), start.sector, start.eye, start.angle, 0);
    for (int tick = 0; tick < 500; ++tick) {
      WalkInput input;
      input.forward = static_cast<int>(random.between(0, 127));
      input.turn = static_cast<int>(random.between(-3000, 3000));
      input.jump = random.chance(0.02);
      walker = walked(both.moved(), walker, input);
      reference = walked(both.authored.scene(), reference, input);
      ASSERT_TRUE(walker == reference) << tick;
    }
  }
}

}  // namespace
}  // namespace hearth
