#include <gtest/gtest.h>

#include <cmath>

#include "render/camera.h"
#include "render/column_hits.h"

namespace hearth {
namespace {

Camera cameraAt(Vec3 eye, double angle, double pitch = 0) {
  return {SectorId(0), eye, angle, pitch, 90, 320, 200};
}

Segment segmentOf(Vec2 p0, Vec2 p1) {
  Segment segment;
  segment.p0 = p0;
  segment.p1 = p1;
  return segment;
}

TEST(Projection, turnsTowardsYToTheRight) {
  const Projection east(cameraAt({0, 0, 0}, 0), {0, 0, 0});
  const CameraPoint right = east.toCamera({2, 1});
  EXPECT_DOUBLE_EQ(right.depth, 2);
  EXPECT_DOUBLE_EQ(right.lateral, 1);
  // With 90 degrees over 320 columns, a point 45 degrees to the right is on the right border.
  EXPECT_DOUBLE_EQ(east.columnOf(east.toCamera({3, 3})), 320);
  EXPECT_DOUBLE_EQ(east.columnOf(east.toCamera({3, 0})), 160);
}

TEST(Projection, shearsWithPitch) {
  const Projection level(cameraAt({0, 0, 1}, 0), {0, 0, 1});
  EXPECT_DOUBLE_EQ(level.rowOf(1, 5), 100);
  EXPECT_DOUBLE_EQ(level.rowOf(2, 4), 100 - 160 / 4.0);
  const Projection up(cameraAt({0, 0, 1}, 0, 45), {0, 0, 1});
  EXPECT_NEAR(up.rowOf(1, 5), 100 + 160, 1e-9);
}

TEST(ProjectedSegment, coversTheColumnsWhoseCentresItSpans) {
  const Projection projection(cameraAt({0, 0, 0}, 0), {0, 0, 0});
  // From column 160 - 80 = 80 to 160 + 40 = 200.
  const ProjectedSegment wall(projection, segmentOf({2, -1}, {4, 1}), 320);
  EXPECT_EQ(wall.facing(), ProjectedSegment::Facing::Front);
  EXPECT_EQ(wall.columns().begin, 80);
  EXPECT_EQ(wall.columns().end, 200);
  const ProjectedSegment back(projection, segmentOf({4, 1}, {2, -1}), 320);
  EXPECT_EQ(back.facing(), ProjectedSegment::Facing::Back);
  EXPECT_EQ(back.columns().begin, 80);
  EXPECT_EQ(back.columns().end, 200);
}

TEST(ProjectedSegment, isNotClippedHoweverNearItIs) {
  const Projection projection(cameraAt({0, 0, 0}, 0), {0, 0, 0});
  const ProjectedSegment near(projection, segmentOf({1e-9, -1}, {1e-9, 1}), 320);
  EXPECT_EQ(near.columns().begin, 0);
  EXPECT_EQ(near.columns().end, 320);
  const ProjectedSegment passing(projection, segmentOf({-1, -0.001}, {1, -0.001}), 320);
  EXPECT_EQ(passing.facing(), ProjectedSegment::Facing::Front);
  EXPECT_EQ(passing.columns().begin, 0);
  EXPECT_EQ(passing.columns().end, 160);
}

TEST(ProjectedSegment, meetsItsTwinAtTheSameDepthToTheBit) {
  const Projection projection(cameraAt({0.3, 0.1, 0}, 17), {0.3, 0.1, 0});
  const ProjectedSegment wall(projection, segmentOf({2.1, -1.7}, {4.3, 1.9}), 320);
  const ProjectedSegment twin(projection, segmentOf({4.3, 1.9}, {2.1, -1.7}), 320);
  for (int column = wall.columns().begin; column < wall.columns().end; ++column) {
    const double slant = projection.slantOf(column + 0.5);
    EXPECT_EQ(wall.meet(slant).depth, twin.meet(slant).depth);
    EXPECT_DOUBLE_EQ(wall.meet(slant).share, 1 - twin.meet(slant).share);
  }
}

}  // namespace
}  // namespace hearth
