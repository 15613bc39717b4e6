// Bookmarks in a walk, without a window.

#include <gtest/gtest.h>

#include "staged_walk.h"

namespace hearth {
namespace {

using test::down;
using test::up;

void walkOff(test::StagedWalk& walk) {
  walk.now(down(Key::W));
  walk.ticks(20);
  walk.now(up(Key::W));
}

TEST(WalkBookmarks, AKeyKeepsAPlaceAndAnotherGoesThereByTurns) {
  test::StagedWalk walk({}, test::rooms(), WalkSession::Record::No);
  const Vec3 first = walk.walker().feet;
  walk.now(down(Key::B));
  walkOff(walk);
  const Vec3 second = walk.walker().feet;
  walk.now(down(Key::B));
  walkOff(walk);
  for (const Vec3& place : {first, second, first}) {
    walk.now(down(Key::G));
    EXPECT_LT(length(walk.walker().feet.xy() - place.xy()), 0.001);
  }
}

TEST(WalkBookmarks, ARecordedWalkHasNoJumps) {
  test::StagedWalk walk;
  walk.now(down(Key::B));
  walkOff(walk);
  const Walker before = walk.walker();
  walk.now(down(Key::G));
  EXPECT_EQ(walk.walker(), before);
}

TEST(WalkBookmarks, ThereMayBeNone) {
  test::StagedWalk walk({}, test::rooms(), WalkSession::Record::No);
  const Walker before = walk.walker();
  walk.now(down(Key::G));
  EXPECT_EQ(walk.walker(), before);
}

}  // namespace
}  // namespace hearth
