#include "math/box3.h"

#include <gtest/gtest.h>

namespace hearth {
namespace {

TEST(Box3, growsByTheBoxesAndPointsThatAreAdded) {
  Box3 box;
  box.add(Vec3{1, 5, -2});
  EXPECT_EQ(box, (Box3{{1, 5, -2}, {1, 5, -2}}));
  box.add(Box3{{0, 6, -3}, {1, 7, -1}});
  EXPECT_EQ(box, (Box3{{0, 5, -3}, {1, 7, -1}}));
}

TEST(Box3, isUnchangedByAnEmptyOne) {
  const Box3 before{{0, 5, -3}, {1, 7, -1}};
  Box3 box = before;
  box.add(Box3{});
  EXPECT_EQ(box, before);
  Box3 empty;
  empty.add(Box3{});
  EXPECT_EQ(empty, Box3{});
}

}  // namespace
}  // namespace hearth
