#include "level/locate.h"

#include <gtest/gtest.h>

#include "support/level_text.h"

namespace hearth {
namespace {

/// A square room with two pillars: one has its lower side in the room's own wall, and the right one
/// in line with a side of the other.
LoadedLevel roomWithBuriedWalls() {
  return test::levelFrom(
      "{'light':1,'sectors':{'room':{'floor':{'texture':'#808080'},'ceiling':{'z':3,'texture':"
      "'#808080'},'loops':{'border':{'v':[0,0, 8,0, 8,8, 0,8],'walls':{'texture':'#808080'}},"
      "'a':{'v':[2,8, 4,8, 4,4, 2,4],'walls':{'texture':'#808080'}},"
      "'b':{'v':[4,7, 6,7, 6,5, 4,5],'walls':{'texture':'#808080'}}}}}}");
}

/// An L with a square pillar, and a sliver whose corner has about one degree.
LoadedLevel rooms() {
  return test::levelFrom(
      "{'light':1,'sectors':{'room':{'floor':{'texture':'#808080'},'ceiling':{'z':3,'texture':"
      "'#808080'},'loops':{'border':{'v':[0,0, 8,0, 8,4, 4,4, 4,8, 0,8],'walls':{'texture':"
      "'#808080'}},'pillar':{'v':[1,1, 1,2, 2,2, 2,1],'walls':{'texture':'#808080'}}}}," +
      test::sectorText("sliver", "20,0, 30,0, 30,0.1745", 0, 2) + "}}");
}

class LocateTest : public testing::Test {
 protected:
  const Sector& sector(std::size_t i) const { return loaded_.level.sectors[i]; }
  const Level& level() const { return loaded_.level; }
  Scene scene() const { return loaded_.scene(); }

 private:
  LoadedLevel loaded_ = rooms();
};

TEST_F(LocateTest, knowsInsideFromOutside) {
  EXPECT_TRUE(contains(level(), sector(0), {3, 3}));
  EXPECT_TRUE(contains(level(), sector(0), {7, 1}));
  EXPECT_FALSE(contains(level(), sector(0), {5, 5})) << "beyond the L's corner";
  EXPECT_FALSE(contains(level(), sector(0), {1.5, 1.5})) << "inside the pillar";
  EXPECT_FALSE(contains(level(), sector(0), {-1, 4}));
}

TEST_F(LocateTest, countsEveryBorderAsInside) {
  for (const Segment& segment : level().segments)
    for (const double fraction : {0.0, 0.25, 0.5})
      EXPECT_TRUE(
          contains(level(), level()[segment.sector], lerp(segment.p0, segment.p1, fraction)))
          << segment.p0.x << ' ' << segment.p0.y;
}

TEST(BuriedWalls, areNoPartOfTheRoom) {
  const LoadedLevel loaded = roomWithBuriedWalls();
  const Level& level = loaded.level;
  const Scene scene = loaded.scene();
  const Sector& room = level.sectors[0];
  for (const Vec2 buried : {Vec2{3, 8}, {3.5, 8}, {4, 6}, {4, 5.5}}) {
    EXPECT_FALSE(contains(level, room, buried)) << buried.x << ' ' << buried.y;
    EXPECT_FALSE(contains(scene, room, {buried.x, buried.y, 1}, 1e-6));
  }
  for (const Vec2 seen : {Vec2{1, 8}, {7, 8}, {2, 6}, {4, 4.5}, {4, 7.5}, {6, 6}, {5, 7}}) {
    EXPECT_TRUE(contains(level, room, seen)) << seen.x << ' ' << seen.y;
    EXPECT_TRUE(contains(scene, room, {seen.x, seen.y, 1}, 1e-6));
  }
  for (const Vec2 corner : {Vec2{2, 8}, {4, 8}, {4, 7}, {4, 5}, {4, 4}})
    EXPECT_TRUE(contains(level, room, corner)) << corner.x << ' ' << corner.y;
  EXPECT_TRUE(contains(scene, room, {1, 8 + 9e-7, 1}, 1e-6));
  EXPECT_FALSE(contains(scene, room, {3, 8 + 9e-7, 1}, 1e-6));
}

TEST_F(LocateTest, allowsASlackAndNoMore) {
  EXPECT_TRUE(contains(scene(), sector(0), {8 + 9e-7, 1, 1}, 1e-6));
  EXPECT_FALSE(contains(scene(), sector(0), {8 + 2e-6, 1, 1}, 1e-6));
  EXPECT_TRUE(contains(scene(), sector(0), {7, 1, -9e-7}, 1e-6));
  EXPECT_FALSE(contains(scene(), sector(0), {7, 1, 3.1}, 1e-6));
}

TEST_F(LocateTest, leavesPositionsInTheOpenAlone) {
  EXPECT_EQ(nudgedInside(scene(), sector(0), {3, 3, 1}), (Vec3{3, 3, 1}));
}

TEST_F(LocateTest, movesPositionsOffEveryWallVertexAndFlat) {
  for (const Segment& segment : level().segments) {
    const Sector& of = level()[segment.sector];
    for (const double fraction : {0.0, 0.3})
      for (const double z : {of.floor.z, of.ceiling.z}) {
        const Vec2 p = lerp(segment.p0, segment.p1, fraction);
        const Vec3 inside = nudgedInside(scene(), of, {p.x, p.y, z});
        EXPECT_LT(length(inside - Vec3{p.x, p.y, z}), 1e-6);
        EXPECT_GT(inside.z, of.floor.z);
        EXPECT_LT(inside.z, of.ceiling.z);
        for (const Segment& wall : level().segmentsOf(of)) {
          const Vec2 along = wall.p1 - wall.p0;
          const bool faces =
              dot(inside.xy() - wall.p0, along) >= 0 && dot(inside.xy() - wall.p1, along) <= 0;
          if (faces && length(p - wall.p0) + length(p - wall.p1) < wall.length + 1e-6) {
            EXPECT_GT(cross(along, inside.xy() - wall.p0), 0) << "behind a wall that it was on";
          }
        }
      }
  }
}

}  // namespace
}  // namespace hearth
