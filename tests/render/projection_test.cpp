#include <gtest/gtest.h>

#include <cmath>

#include "render/camera.h"
#include "render/segment_columns.h"

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

TEST(ColumnsOf, areThoseWhoseCentresTheFrontOfASegmentSpans) {
  const Projection projection(cameraAt({0, 0, 0}, 0), {0, 0, 0});
  // From column 160 - 80 = 80 to 160 + 40 = 200.
  const ColumnRange wall = columnsOf(projection, segmentOf({2, -1}, {4, 1}), 320);
  EXPECT_EQ(wall.begin, 80);
  EXPECT_EQ(wall.end, 200);
  const ColumnRange back = columnsOf(projection, segmentOf({4, 1}, {2, -1}), 320);
  EXPECT_EQ(back.begin, back.end);
}

TEST(ColumnsOf, areAllOfASegmentHoweverNearItIs) {
  const Projection projection(cameraAt({0, 0, 0}, 0), {0, 0, 0});
  const ColumnRange near = columnsOf(projection, segmentOf({1e-9, -1}, {1e-9, 1}), 320);
  EXPECT_EQ(near.begin, 0);
  EXPECT_EQ(near.end, 320);
  const ColumnRange passing = columnsOf(projection, segmentOf({-1, -0.001}, {1, -0.001}), 320);
  EXPECT_EQ(passing.begin, 0);
  EXPECT_EQ(passing.end, 160);
}

TEST(ColumnsOf, goOnToTheEdgeOfTheScreenWhereASegmentGoesOnBehindTheEye) {
  const Projection projection(cameraAt({0, 0, 0}, 0), {0, 0, 0});
  const Vec2 ahead{2, 1};
  // It passes the eye on its right, ...
  for (const Vec2 behind : {Vec2{-2, 1}, Vec2{0, 3}, Vec2{-1, -0.25}}) {
    const ColumnRange front = columnsOf(projection, segmentOf(ahead, behind), 320);
    EXPECT_EQ(front.begin, 240);
    EXPECT_EQ(front.end, 320);
    const ColumnRange back = columnsOf(projection, segmentOf(behind, ahead), 320);
    EXPECT_EQ(back.begin, back.end);
  }
  // ... and on its left.
  for (const Vec2 behind : {Vec2{-2, -3}, Vec2{0, -1}, Vec2{-1, -0.75}}) {
    const ColumnRange front = columnsOf(projection, segmentOf(behind, ahead), 320);
    EXPECT_EQ(front.begin, 0);
    EXPECT_EQ(front.end, 240);
    const ColumnRange back = columnsOf(projection, segmentOf(ahead, behind), 320);
    EXPECT_EQ(back.begin, back.end);
  }
  const ColumnRange unseen = columnsOf(projection, segmentOf({-2, 1}, {-2, -1}), 320);
  EXPECT_EQ(unseen.begin, unseen.end);
}

TEST(ColumnsOf, areOneAtMostOfASegmentAndItsBackHoweverEdgeOnTheyAre) {
  const Projection projection(cameraAt({0.3, 0.1, 0}, 17), {0.3, 0.1, 0});
  // Beads on rays of the eye, whose columns rounding alone tells apart.
  for (int i = 0; i < 400; ++i) {
    const double angle = 17 + (i - 200) * 0.2;
    const Vec2 ray{sinCosDegrees(angle).cos, sinCosDegrees(angle).sin};
    const auto at = [&](double depth) { return Vec2{0.3, 0.1} + depth * ray; };
    const ColumnRange away = columnsOf(projection, segmentOf(at(1), at(3)), 320);
    const ColumnRange back = columnsOf(projection, segmentOf(at(3), at(1)), 320);
    EXPECT_LE(away.end - away.begin + back.end - back.begin, 1);
  }
}

TEST(SegmentMeetings, areAtTheSameDepthToTheBitForTwins) {
  const Projection projection(cameraAt({0.3, 0.1, 0}, 17), {0.3, 0.1, 0});
  const Segment near = segmentOf({2.1, -1.7}, {4.3, 1.9});
  const SegmentMeetings wall(projection, near);
  const SegmentMeetings twin(projection, segmentOf(near.p1, near.p0));
  const ColumnRange columns = columnsOf(projection, near, 320);
  EXPECT_LT(columns.begin, columns.end);
  for (int column = columns.begin; column < columns.end; ++column) {
    const double slant = projection.slantOf(column + 0.5);
    EXPECT_EQ(wall.at(slant).depth, twin.at(slant).depth);
    EXPECT_DOUBLE_EQ(wall.at(slant).fraction, 1 - twin.at(slant).fraction);
  }
}

}  // namespace
}  // namespace hearth
