#include "truth/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "level/locate.h"
#include "test_level.h"

namespace hearth {
namespace {

constexpr double kNear = 1e-12;

TruthHit look(const Level& level, SectorId sector, Vec3 origin, Vec3 direction) {
  const auto hit = trace(level, sector, origin, direction, RayKind::Look);
  EXPECT_TRUE(hit.has_value());
  return hit.value_or(TruthHit{});
}

void expectNear(Vec3 a, Vec3 b, double tolerance = kNear) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

void expectNear(Vec2 a, Vec2 b, double tolerance = kNear) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

/// West [0, 4] x [0, 4], 4 m high, and east [4, 8] x [0, 4] of the heights given.
struct TwoRooms {
  TestLevel level;
  SectorId west = level.addBox("west", {0, 0}, {4, 4}, {0, 4});
  SectorId east;
  static constexpr std::size_t kBetween = 1;  ///< the wall of `west` that leads east
  static constexpr std::size_t kBack = 3;     ///< the wall of `east` that leads west

  explicit TwoRooms(TestLevel::Heights heights)
      : east(level.addBox("east", {4, 0}, {8, 4}, heights)) {
    level.link(west, east);
  }
};

TEST(Trace, MeetsTheWallOfABoxAtItsDistanceAndImagePlace) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {4, 4}, {0, 4});
  const TruthHit hit = look(test.finished(), box, {1, 2.5, 1}, {2, 0, 0});
  EXPECT_EQ(hit.kind, SurfaceKind::Solid);
  EXPECT_EQ(hit.segment, test.wallId(box, 1));
  EXPECT_DOUBLE_EQ(hit.t, 1.5);
  expectNear(hit.point, {4, 2.5, 1});
  expectNear(hit.normal, {-1, 0, 0});
  expectNear(hit.imageMetres, {2.5, 3});  // from p0; down from the ceiling
}

TEST(Trace, LeavesABoxWhereTheSlabsSay) {
  TestLevel test;
  const SectorId box = test.addBox("box", {-1, -2}, {3, 5}, {-1, 2});
  const Level& level = test.finished();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 origin{1 + 1.9 * unit(random), 1.5 + 3.4 * unit(random), 0.5 + 1.4 * unit(random)};
    const Vec3 d{unit(random), unit(random), unit(random)};
    const double tx = ((d.x > 0 ? 3 : -1) - origin.x) / d.x;
    const double ty = ((d.y > 0 ? 5 : -2) - origin.y) / d.y;
    const double tz = ((d.z > 0 ? 2 : -1) - origin.z) / d.z;
    const TruthHit hit = look(level, box, origin, d);
    ASSERT_NEAR(hit.t, std::min({tx, ty, tz}), 1e-12 * hit.t);
    ASSERT_LT(dot(hit.normal, d), 0);
  }
}

TEST(Trace, MeetsFlatsStraightAboveAndBelow) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {4, 4}, {-1, 2});
  test.sector(box).floor.textureOrigin = {0.5, 1};
  const Level& level = test.finished();
  const TruthHit floor = look(level, box, {1, 3, 1}, {0, 0, -1});
  EXPECT_EQ(floor.kind, SurfaceKind::Floor);
  expectNear(floor.point, {1, 3, -1});
  expectNear(floor.imageMetres, {0.5, 2});
  const TruthHit ceiling = look(level, box, {1, 3, 1}, {0, 0, 1});
  EXPECT_EQ(ceiling.kind, SurfaceKind::Ceiling);
  expectNear(ceiling.imageMetres, {1, 3});
  expectNear(ceiling.normal, {0, 0, -1});
}

/// Rooms of one height, and between them a masked middle texture of 2 x 2 texels, 2 m wide and 1 m
/// high, seen from the west, whose upper left texel is a hole.
struct GrilledRooms : TwoRooms {
  GrilledRooms() : TwoRooms({0, 4}) {
    TextureMapping mapping = level.texture(2, 2);
    mapping.repeat = {2, 1};
    std::get<Portal>(level.wall(west, kBetween).wall).maskedMiddle = mapping;
    level.makeHole(mapping.texture, 0, 0);
  }
};

TEST(Trace, MeetsAMiddleTextureFromItsFrontButInItsHolesAndBelowIt) {
  GrilledRooms rooms;
  const Level& level = rooms.level.finished();
  const TruthHit solid = look(level, rooms.west, {1, 1.5, 3.75}, {1, 0, 0});
  EXPECT_EQ(solid.kind, SurfaceKind::MaskedMiddle);
  EXPECT_EQ(solid.sector, rooms.west);
  expectNear(solid.imageMetres, {1.5, 0.25});
  EXPECT_EQ(look(level, rooms.west, {1, 0.5, 3.75}, {1, 0, 0}).sector, rooms.east) << "the hole";
  EXPECT_EQ(look(level, rooms.west, {1, 2.5, 3.75}, {1, 0, 0}).sector, rooms.east) << "repeated";
  EXPECT_EQ(look(level, rooms.west, {1, 0.5, 3.25}, {1, 0, 0}).kind, SurfaceKind::MaskedMiddle);
  EXPECT_EQ(look(level, rooms.west, {1, 1.5, 2.9}, {1, 0, 0}).sector, rooms.east) << "below it";
  EXPECT_EQ(look(level, rooms.east, {5, 1.5, 3.75}, {-1, 0, 0}).sector, rooms.west);
}

TEST(Trace, StopsLightAtAMiddleTextureFromBothSides) {
  GrilledRooms rooms;
  const Level& level = rooms.level.finished();
  const auto arrival = [&](SectorId sector, Vec3 origin, Vec3 direction) {
    return trace(level, sector, origin, direction, RayKind::Light).value();
  };
  const TruthHit front = arrival(rooms.west, {1, 1.5, 3.75}, {1, 0, 0});
  EXPECT_EQ(front.kind, SurfaceKind::MaskedMiddle);
  const TruthHit behind = arrival(rooms.east, {5, 1.5, 3.75}, {-1, 0, 0});
  EXPECT_EQ(behind.kind, SurfaceKind::MaskedMiddle);
  EXPECT_EQ(behind.sector, rooms.west) << "the front that it has";
  EXPECT_EQ(arrival(rooms.east, {5, 0.5, 3.75}, {-1, 0, 0}).kind, SurfaceKind::Solid);
}

TEST(Trace, LightsAMiddleTextureInItsHolesToo) {
  GrilledRooms rooms;
  const Level& level = rooms.level.finished();
  SurfacePoint place{SurfaceKind::MaskedMiddle,
                     rooms.west,
                     rooms.level.wallId(rooms.west, TwoRooms::kBetween),
                     {4, 0.5, 3.75},
                     {-1, 0, 0}};
  const auto met = traceLight(level, rooms.west, {1, 0.5, 3}, place);
  ASSERT_TRUE(met);
  EXPECT_TRUE(isSameSurface(*met, place));
}

TEST(Trace, ShowsStepsUpAndDownAndTheOpeningBetween) {
  TwoRooms rooms({1, 3});
  const Level& level = rooms.level.finished();
  const TruthHit lower = look(level, rooms.west, {1, 1, 0.75}, {1, 0, 0});
  EXPECT_EQ(lower.kind, SurfaceKind::LowerStep);
  EXPECT_EQ(lower.sector, rooms.west);
  expectNear(lower.imageMetres, {1, 0.25});  // down from the step's top edge
  const TruthHit upper = look(level, rooms.west, {1, 1, 3.5}, {1, 0, 0});
  EXPECT_EQ(upper.kind, SurfaceKind::UpperStep);
  expectNear(upper.imageMetres, {1, -0.5});  // up from the step's bottom edge
  const TruthHit beyond = look(level, rooms.west, {1, 1, 2}, {1, 0, 0});
  EXPECT_EQ(beyond.sector, rooms.east);
  EXPECT_DOUBLE_EQ(beyond.point.x, 8);
  const TruthHit back = look(level, rooms.east, {5, 1, 2}, {-1, 0, 0});
  EXPECT_EQ(back.sector, rooms.west);
  EXPECT_DOUBLE_EQ(back.point.x, 0);
}

TEST(Trace, AClosedDoorIsLowerStepBelowItsFloorAndUpperStepAbove) {
  TwoRooms rooms({2, 2});
  const Level& level = rooms.level.finished();
  EXPECT_EQ(look(level, rooms.west, {1, 1, 1.999}, {1, 0, 0}).kind, SurfaceKind::LowerStep);
  EXPECT_EQ(look(level, rooms.west, {1, 1, 2}, {1, 0, 0}).kind, SurfaceKind::UpperStep);
  EXPECT_EQ(look(level, rooms.west, {1, 1, 2.001}, {1, 0, 0}).kind, SurfaceKind::UpperStep);
}

TEST(Trace, AuthoredAlongAndZRefAndSplitWallsMoveTheImage) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {4, 4}, {0, 4});
  Segment& wall = test.wall(box, 1);
  wall.sBefore = 10;
  std::get<Solid>(wall.wall).texture.along = 100;
  std::get<Solid>(wall.wall).texture.zRef = -5;
  const TruthHit hit = look(test.finished(), box, {1, 2.5, 1}, {1, 0, 0});
  expectNear(hit.imageMetres, {112.5, -6});
}

TEST(Trace, StacksShowEachPieceInItsOwnRange) {
  TwoRooms rooms({0, 1.75});
  const TextureMapping texture = rooms.level.texture();
  Stack stack;
  stack.subWalls = {
      {1, Solid{texture}}, {2, Portal{rooms.east, texture, texture}}, {4, Solid{texture}}};
  rooms.level.wall(rooms.west, TwoRooms::kBetween).wall = stack;
  const Level& level = rooms.level.finished();
  const auto at = [&](double z) { return look(level, rooms.west, {1, 1, z}, {1, 0, 0}); };

  EXPECT_EQ(at(0.5).kind, SurfaceKind::StackSolid);
  EXPECT_EQ(at(0.5).subWall, 0u);
  expectNear(at(0.5).imageMetres, {1, 0.5});  // down from the piece's own top
  EXPECT_EQ(at(1.5).sector, rooms.east);
  EXPECT_EQ(at(1.875).kind, SurfaceKind::StackUpperStep);
  EXPECT_EQ(at(1.875).subWall, 1u);
  expectNear(at(1.875).imageMetres, {1, -0.125});
  EXPECT_EQ(at(3).kind, SurfaceKind::StackSolid);
  EXPECT_EQ(at(3).subWall, 2u);
  expectNear(at(3).imageMetres, {1, 1});
  // Each piece owns its lower edge.
  EXPECT_EQ(at(1).sector, rooms.east);
  EXPECT_EQ(at(2).subWall, 2u);
}

TEST(Trace, OnlyThePieceOfAStackThatReachesTheSkyShowsItOnItsStep) {
  TwoRooms rooms({1.5, 2.5});
  for (const SectorId id : {rooms.west, rooms.east})
    for (Flat* flat : {&rooms.level.sector(id).floor, &rooms.level.sector(id).ceiling})
      flat->isSky = true;
  const TextureMapping texture = rooms.level.texture();
  const Portal portal{rooms.east, texture, texture};
  Stack stack;
  stack.subWalls = {{1, portal}, {3, portal}, {4, portal}};
  rooms.level.wall(rooms.west, TwoRooms::kBetween).wall = stack;
  const Level& level = rooms.level.finished();
  const auto at = [&](double z) { return look(level, rooms.west, {1, 1, z}, {1, 0, 0}); };
  EXPECT_EQ(at(0.5).kind, SurfaceKind::SkyLowerStep);
  EXPECT_EQ(at(1.25).kind, SurfaceKind::StackLowerStep);
  EXPECT_EQ(at(2).sector, rooms.east);
  EXPECT_EQ(at(2.75).kind, SurfaceKind::StackUpperStep);
  EXPECT_EQ(at(3.5).kind, SurfaceKind::SkyUpperStep);
}

/// East has a floor that rises from 0 at x = 4 to 2 at x = 8, or from y = 0 to y = 4.
Slope risingAlong(Vec2 gradient, TestLevel& level) {
  Slope slope;
  slope.origin = {4, 0};
  slope.zAt0 = 0;
  slope.gradient = gradient;
  slope.sidewall = level.texture();
  return slope;
}

TEST(Trace, SlopesAreMetAtTheirHeight) {
  TwoRooms rooms({0, 4});
  rooms.level.sector(rooms.east).floorSlope = risingAlong({0.5, 0}, rooms.level);
  rooms.level.sector(rooms.east).floor.textureOrigin = {4, 0};
  const Level& level = rooms.level.finished();
  const TruthHit hit = look(level, rooms.west, {1, 1, 1}, {1, 0, 0});
  EXPECT_EQ(hit.kind, SurfaceKind::SlopeFloor);
  expectNear(hit.point, {6, 1, 1});
  expectNear(hit.normal, {-0.5 / std::sqrt(1.25), 0, 1 / std::sqrt(1.25)});
  expectNear(hit.imageMetres, {2, 1});
}

TEST(Trace, SidewallsRunFromTheLeftEndAsSeenFromOutside) {
  TwoRooms rooms({0, 4});
  Slope slope = risingAlong({0, 0.5}, rooms.level);
  slope.sidewall->along = 7;
  rooms.level.sector(rooms.east).floorSlope = slope;
  rooms.level.wall(rooms.east, TwoRooms::kBack).sAfter = 20;
  const Level& level = rooms.level.finished();
  const TruthHit hit = look(level, rooms.west, {1, 3, 1}, {1, 0, 0});
  EXPECT_EQ(hit.kind, SurfaceKind::FloorSidewall);
  EXPECT_EQ(hit.sector, rooms.west);
  // Looking east, y = 0 is on the left: 3 m from there, and 1 m above floor.z.
  expectNear(hit.imageMetres, {7 + 20 + 3, -1});
  // The wedge is 1.5 m high there.
  EXPECT_EQ(look(level, rooms.west, {1, 3, 1.499}, {1, 0, 0}).kind, SurfaceKind::FloorSidewall);
  EXPECT_EQ(look(level, rooms.west, {1, 3, 1.501}, {1, 0, 0}).sector, rooms.east);
}

TEST(Trace, SidewallsOfRelativeSlopesHangFromTheSlopesEdge) {
  TwoRooms rooms({0, 4});
  Slope slope = risingAlong({0, 0.5}, rooms.level);
  slope.isRelative = true;
  rooms.level.sector(rooms.east).floorSlope = slope;
  expectNear(look(rooms.level.finished(), rooms.west, {1, 3, 1}, {1, 0, 0}).imageMetres, {3, 0.5});
}

TEST(Trace, SlopesThatContinueEachOtherShowNoSidewall) {
  TwoRooms rooms({0, 4});
  for (const SectorId id : {rooms.west, rooms.east}) {
    Sector& sector = rooms.level.sector(id);
    sector.floorSlope = risingAlong({1.0 / 3, 0.1}, rooms.level);
    sector.floorSlope->zAt0 = 1.4;
    sector.ceilingSlope = risingAlong({0.01, -0.1}, rooms.level);
    sector.ceilingSlope->zAt0 = 3.5;
  }
  // As far apart as rounding may take them.
  rooms.level.sector(rooms.east).floorSlope->zAt0 += 5e-10;
  rooms.level.sector(rooms.east).ceilingSlope->zAt0 -= 5e-10;
  const Level& level = rooms.level.finished();
  for (double y = 0.01; y < 4; y += 0.01) {
    // To the seam, between the two slopes.
    const double zFloor = level[rooms.west].authoredBottom({4, y}) + 1e-10;
    const double zCeiling = level[rooms.west].authoredTop({4, y}) - 1e-10;
    const TruthHit floor = look(level, rooms.west, {3, y, 2}, {1, 0, zFloor - 2});
    ASSERT_EQ(floor.kind, SurfaceKind::SlopeFloor);
    ASSERT_NEAR(floor.point.x, 4, 1e-8);
    ASSERT_TRUE(floor.sector == rooms.west || floor.point.x >= 4);
    const TruthHit ceiling = look(level, rooms.west, {3, y, 2}, {1, 0, zCeiling - 2});
    ASSERT_EQ(ceiling.kind, SurfaceKind::SlopeCeiling);
    ASSERT_TRUE(ceiling.sector == rooms.west || ceiling.point.x >= 4);
  }
}

TEST(Trace, FlatPortalsLeadToTheSectorThatHoldsThePoint) {
  TestLevel test;
  const SectorId above = test.addBox("above", {0, 0}, {4, 4}, {2, 4});
  const SectorId left = test.addBox("left", {0, 0}, {1, 4}, {0, 2});
  const SectorId right = test.addBox("right", {1, 0}, {4, 4}, {1, 2});
  test.connect({above}, {left, right});
  const Level& level = test.finished();
  const TruthHit inLeft = look(level, above, {0.5, 1, 3}, {0, 0, -1});
  EXPECT_EQ(inLeft.sector, left);
  expectNear(inLeft.point, {0.5, 1, 0});
  const TruthHit inRight = look(level, above, {0.5, 1, 3}, {1, 0, -1});
  EXPECT_EQ(inRight.sector, right);
  expectNear(inRight.point, {2.5, 1, 1});
  const TruthHit up = look(level, left, {0.5, 1, 1}, {0.25, 0, 1});
  EXPECT_EQ(up.sector, above);
  expectNear(up.point, {1.25, 1, 4});
}

TEST(Trace, OnlyLinksConnectSectorsThatOverlapInSpace) {
  TestLevel test;
  const SectorId a = test.addBox("a", {0, 0}, {4, 4}, {0, 4});
  const SectorId b = test.addBox("b", {2, 0}, {6, 4}, {0, 4});
  const Level& level = test.finished();
  EXPECT_EQ(look(level, a, {1, 1, 1}, {1, 0, 0}).point.x, 4);
  EXPECT_EQ(look(level, b, {5, 1, 1}, {-1, 0, 0}).point.x, 2);
}

TEST(Trace, ALookEndsAtSkiesAndAtTheStepBetweenThem) {
  TwoRooms rooms({0, 3});
  for (const SectorId id : {rooms.west, rooms.east}) rooms.level.sector(id).ceiling.isSky = true;
  const Level& level = rooms.level.finished();
  EXPECT_EQ(look(level, rooms.west, {1, 1, 3}, {1, 0, 1}).kind, SurfaceKind::SkyCeiling);
  const TruthHit step = look(level, rooms.west, {3.5, 1, 3.2}, {0.5, 0.5, 0.1});
  EXPECT_EQ(step.kind, SurfaceKind::SkyUpperStep);
  EXPECT_EQ(step.texture->texture, level[rooms.west].ceiling.texture->texture);
  // South-east is 45 degrees of 360; the tangent counts up from the image's lower edge.
  expectNear(step.imageMetres, {0.125, 1 - 0.1 / std::sqrt(0.5)});
}

TEST(Trace, SkyFloorsMirrorTheTangent) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {4, 4}, {0, 4});
  test.sector(box).floor.isSky = true;
  const TruthHit hit = look(test.finished(), box, {2, 2, 1}, {0, -1, -0.75});
  EXPECT_EQ(hit.kind, SurfaceKind::SkyFloor);
  expectNear(hit.imageMetres, {0.75, 0.25});
}

TEST(Trace, HolesStandInTheWayAndFilledHolesLeadIn) {
  TestLevel test;
  const SectorId room = test.addBox("room", {0, 0}, {8, 8}, {0, 4});
  test.addLoop(room, {{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  test.addLoop(room, {{4, 1}, {4, 2}, {5, 2}, {5, 1}});
  const SectorId niche = test.addBox("niche", {4, 1}, {5, 2}, {0, 4});
  test.link(room, niche);
  const Level& level = test.finished();
  EXPECT_EQ(look(level, room, {0.5, 1.5, 1}, {1, 0, 0}).point.x, 1);
  EXPECT_EQ(look(level, room, {3, 1.5, 1}, {-1, 0, 0}).point.x, 2);
  EXPECT_EQ(look(level, room, {3, 1.5, 1}, {1, 0, 0}).point.x, 8);
  EXPECT_EQ(look(level, niche, {4.5, 1.5, 1}, {0, 1, 0}).point.y, 8);
}

/// A round room cut into wedges that share the vertex in its middle.
struct Pie {
  static constexpr std::size_t kSlices = 12;
  TestLevel level;
  std::vector<Vec2> rim;
  std::vector<SectorId> slices;

  explicit Pie(Vec2 center) {
    for (std::size_t i = 0; i < kSlices; ++i) {
      const double angle = 0.1 + 6.283185307179586 * static_cast<double>(i) / kSlices;
      rim.push_back(center + 10 * Vec2{std::cos(angle), std::sin(angle)});
    }
    for (std::size_t i = 0; i < kSlices; ++i) {
      slices.push_back(level.addSector(std::to_string(i), {0, 4}));
      level.addLoop(slices.back(), {center, rim[i], rim[(i + 1) % kSlices]});
    }
    for (std::size_t i = 0; i < kSlices; ++i) level.link(slices[i], slices[(i + 1) % kSlices]);
  }
};

TEST(Trace, RaysThroughAVertexOfManySectorsReachTheFarWall) {
  for (const Vec2 center : {Vec2{0, 0}, Vec2{1.0 / 3, 1e4 / 7}, Vec2{-1e6 / 3, 1e6 / 7}}) {
    Pie pie(center);
    const Level& level = pie.level.finished();
    for (std::size_t i = 0; i < Pie::kSlices; ++i) {
      for (double fraction = 0; fraction <= 1; fraction += 0.01) {
        const Vec2 xy =
            lerp(center, lerp(pie.rim[i], pie.rim[(i + 1) % Pie::kSlices], fraction), 0.7);
        const Sector& sector = level[pie.slices[i]];
        const Vec3 eye = nudgedInside(level, sector, {xy.x, xy.y, 1});
        const Vec2 d = center - eye.xy();
        const TruthHit hit = look(level, pie.slices[i], eye, {d.x, d.y, 0});
        // The rim is a polygon of 12 sides: between 10 cos(15 degrees) and 10 m from the middle.
        ASSERT_GT(length(hit.point.xy() - center), 9.659);
        ASSERT_LT(length(hit.point.xy() - center), 10.0001);
        ASSERT_GT(hit.t, 2);
      }
    }
  }
}

TEST(Trace, RaysAlongAPortalsLineStayInTheLevel) {
  Pie pie({0, 0});
  const Level& level = pie.level.finished();
  for (std::size_t i = 0; i < Pie::kSlices; ++i) {
    const Vec2 xy = 0.5 * pie.rim[i];
    const Vec3 eye = nudgedInside(level, level[pie.slices[i]], {xy.x, xy.y, 1});
    for (const double sign : {1.0, -1.0}) {
      const TruthHit hit = look(level, pie.slices[i], eye, {sign * xy.x, sign * xy.y, 0});
      EXPECT_NEAR(length(hit.point.xy()), 10, 1e-6);
    }
  }
}

/// 5 x 5 x 3 unit cubes, open to each other on all sides: one hall cut up.
struct OpenLattice {
  static constexpr std::size_t kSide = 5;
  static constexpr std::size_t kStoreys = 3;
  TestLevel level;
  std::vector<std::vector<SectorId>> storeys;

  OpenLattice() {
    for (std::size_t k = 0; k < kStoreys; ++k) {
      addStorey(static_cast<double>(k));
      if (k > 0) level.connect(storeys[k], storeys[k - 1]);
    }
  }

  void addStorey(double z) {
    std::vector<SectorId> cells;
    for (std::size_t i = 0; i < kSide * kSide; ++i) {
      const Vec2 min{static_cast<double>(i % kSide), static_cast<double>(i / kSide)};
      cells.push_back(level.addBox("cell", min, min + Vec2{1, 1}, {z, z + 1}));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if ((i + 1) % kSide != 0) level.link(cells[i], cells[i + 1]);
      if (i + kSide < cells.size()) level.link(cells[i], cells[i + kSide]);
    }
    storeys.push_back(cells);
  }
};

TEST(Trace, RaysThroughVerticesAndEdgesOfALatticeGoStraightOn) {
  OpenLattice lattice;
  const Level& level = lattice.level.finished();
  const auto exitOf = [](double from, double d, double size) {
    return d == 0 ? 1e9 : ((d > 0 ? size : 0) - from) / d;
  };
  // From the middle of each cube, in all directions of small whole numbers.
  for (std::size_t k = 0; k < OpenLattice::kStoreys; ++k) {
    for (std::size_t i = 0; i < OpenLattice::kSide * OpenLattice::kSide; ++i) {
      const Vec3 eye{static_cast<double>(i % 5) + 0.5, static_cast<double>(i / 5) + 0.5,
                     static_cast<double>(k) + 0.5};
      for (int n = 0; n < 7 * 7 * 7; ++n) {
        const Vec3 d{n % 7 - 3.0, n / 7 % 7 - 3.0, n / 49 - 3.0};
        if (d == Vec3{}) continue;
        const double t =
            std::min({exitOf(eye.x, d.x, 5), exitOf(eye.y, d.y, 5), exitOf(eye.z, d.z, 3)});
        ASSERT_NEAR(look(level, lattice.storeys[k][i], eye, d).t, t, kNear) << d.x << d.y << d.z;
      }
    }
  }
}

TEST(Trace, FiftyPortalsInARowAreCrossed) {
  TestLevel test;
  std::vector<SectorId> rooms;
  for (int i = 0; i <= 50; ++i) {
    const double x = i / 3.0;
    rooms.push_back(test.addBox(std::to_string(i), {x, 0}, {(i + 1) / 3.0, 1}, {0, 4}));
  }
  for (std::size_t i = 0; i < 50; ++i) test.link(rooms[i], rooms[i + 1]);
  const TruthHit hit = look(test.finished(), rooms[0], {0.1, 0.1, 1}, {1, 0.01, 0.01});
  EXPECT_EQ(hit.sector, rooms[50]);
  EXPECT_EQ(hit.point.x, 17);
}

}  // namespace
}  // namespace hearth
