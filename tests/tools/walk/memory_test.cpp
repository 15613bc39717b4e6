// A second of play takes no memory once it is under way.

#include "staged_walk.h"
#include "support/allocations.h"

namespace hearth {
namespace {

class WalkMemory : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(OfThreads, WalkMemory, testing::Values(1, 2));

TEST_P(WalkMemory, ASecondAt1920x1080TakesNone) {
  const test::Place tutorial("levels/tutorial.json");
  Workers workers(GetParam());
  test::StagedWalk walk({.size = ImageSize{1920, 1080}}, tutorial, WalkSession::Record::No,
                        &workers);
  walk.stage.title.reserve(100);
  walk.now(test::down(Key::Tab));  // the map is drawn, too
  const auto turnThereAndBack = [&] {
    for (const Key key : {Key::Right, Key::Left}) {
      walk.now(test::down(key));
      walk.ticks(15);
      walk.now(test::up(key));
    }
  };
  turnThereAndBack();
  const int framesBefore = walk.stage.frames;
  const std::size_t before = test::allocationCount();
  turnThereAndBack();
  turnThereAndBack();
  EXPECT_EQ(test::allocationCount(), before);
  EXPECT_GE(walk.stage.frames, framesBefore + 60);
}

}  // namespace
}  // namespace hearth
