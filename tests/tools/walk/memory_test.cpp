// A second of play takes no memory once it is under way.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "staged_walk.h"
#include "support/allocations.h"
#include "support/hall_and_cellar.h"

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

TEST_P(WalkMemory, ADoorThatMovesTakesNone) {
  std::string text = test::hallAndCellarText();
  text.replace(text.find("'trigger':'use'"), 0, "'wait':0.1,");
  SourcedResult sourced = test::levelWithSourceFrom(text, test::kHallLights);
  const test::Place place(*sourced.result.loaded);
  Workers workers(GetParam());
  test::StagedWalk walk({.size = ImageSize{640, 400}}, place, WalkSession::Record::No, &workers);
  walk.stage.title.reserve(100);
  LoadedLevel opened = *levelAt(place.loaded, sourced.source, std::vector{1.0, 0.0}).loaded;
  BakedLight light = bake(opened.scene(), opened.level.bake, 1);
  walk.loop().addLight(std::make_shared<const RestLight>(
      RestLight{{1, 0}, std::move(opened.geometry), std::move(light)}));
  const auto open = [&] {
    walk.now(test::down(Key::E));
    walk.now(test::up(Key::E));
    walk.ticks(10);
  };
  open();
  walk.ticks(200);  // it has shut again
  open();
  const int framesBefore = walk.stage.frames;
  const std::size_t before = test::allocationCount();
  walk.ticks(60);
  EXPECT_EQ(test::allocationCount(), before);
  EXPECT_EQ(walk.stage.frames, framesBefore + 60);
}

}  // namespace
}  // namespace hearth
