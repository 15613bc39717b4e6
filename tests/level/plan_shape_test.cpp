#include "level/plan_shape.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/level_text.h"

namespace hearth {
namespace {

using test::sectorText;

/// A cellar of 4 m each way, and above it a room of the same outline beside another one.
class PlanShapes : public testing::Test {
 protected:
  bool meet(const std::vector<Vec2>& corners, std::size_t a, std::size_t b) const {
    std::vector<double> cuts;
    return PlanShape(corners).meetsBoth(loaded_.level, loaded_.level.sectors[a],
                                        loaded_.level.sectors[b], cuts);
  }

 private:
  LoadedLevel loaded_ = test::levelFrom(
      "{'light':1,'sectors':{"
      "'cellar':{'floor':{'z':0,'texture':'#808080'},'ceiling':{'z':2,'next':'room-cellar'},"
      "'loops':{'border':{'v':[0,0, 4,0, 4,4, 0,4],'walls':{'texture':'#808080'}}}},"
      "'room':{'floor':{'z':2,'next':'room-cellar'},'ceiling':{'z':4,'texture':'#808080'},"
      "'loops':{'border':{'v':[0,0, 4,0, 4,4, 0,4],'walls':{'texture':'#808080'}}}}," +
      sectorText("beside", "4,0, 8,0, 8,4, 4,4", 2, 4) + "}}");
};

constexpr std::size_t kCellar = 0;
constexpr std::size_t kRoom = 1;
constexpr std::size_t kBeside = 2;

TEST_F(PlanShapes, meetWhatLiesOneAboveTheOtherWhereTheyCoverIt) {
  EXPECT_TRUE(meet({{1, 1}, {2, 3}}, kCellar, kRoom)) << "a line";
  EXPECT_TRUE(meet({{1, 1}, {2, 3}, {3, 1}}, kCellar, kRoom)) << "a triangle";
  EXPECT_TRUE(meet({{-1, -1}, {-1, 9}, {9, 9}, {9, -1}}, kCellar, kRoom)) << "all around";
  EXPECT_TRUE(meet({{-1, 2}, {9, 2}}, kCellar, kRoom)) << "right across";
  EXPECT_FALSE(meet({{-2, 1}, {-1, 3}}, kCellar, kRoom));
  EXPECT_FALSE(meet({{5, 1}, {6, 3}, {7, 1}}, kCellar, kRoom));
}

TEST_F(PlanShapes, meetWhatTheyTouch) {
  EXPECT_TRUE(meet({{-1, 1}, {1, -1}}, kCellar, kRoom)) << "a line through a corner";
  EXPECT_FALSE(meet({{-1, 0.999}, {0.999, -1}}, kCellar, kRoom)) << "past it";
  EXPECT_TRUE(meet({{-1, 2}, {0, 2}}, kCellar, kRoom)) << "up to an edge";
  EXPECT_FALSE(meet({{-1, 2}, {-0.001, 2}}, kCellar, kRoom));
  EXPECT_TRUE(meet({{-2, 1}, {0, 2}, {-2, 3}}, kCellar, kRoom)) << "a corner at an edge";
  EXPECT_TRUE(meet({{0, 1}, {0, 3}}, kCellar, kRoom)) << "along an edge";
  EXPECT_TRUE(meet({{1, 2}}, kCellar, kRoom)) << "a point";
  EXPECT_TRUE(meet({{1, 2}, {1 + 1e-7, 2}, {1, 2 + 1e-7}}, kCellar, kRoom)) << "all but a point";
  EXPECT_FALSE(meet({{5, 2}}, kCellar, kRoom));
}

TEST_F(PlanShapes, doNotMeetWhatHasOnlyAnEdgeInCommon) {
  EXPECT_FALSE(meet({{3, 1}, {5, 3}}, kRoom, kBeside));
  EXPECT_FALSE(meet({{3, 1}, {5, 3}, {5, 1}}, kRoom, kBeside));
  EXPECT_FALSE(meet({{4, 0}, {4, 4}}, kRoom, kBeside));
}

}  // namespace
}  // namespace hearth
