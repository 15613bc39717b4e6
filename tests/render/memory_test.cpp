// That frames are drawn in memory which earlier ones have left.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "load/load.h"
#include "render/renderer.h"
#include "rooms_behind_a_door.h"
#include "support/allocations.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

class FramesOfTheTutorial : public testing::Test {
 protected:
  FramesOfTheTutorial()
      : loaded_(loadLevel(test::inTree("levels/tutorial.json")).loaded.value()),
        light_(bake(loaded_.scene(), loaded_.level.bake, 2)),
        renderer_(loaded_.scene(), loaded_.textures, light_) {}

  static constexpr int kFramesPerTurn = 24;

  enum class Way { There, Back };

  /// A turn all round where each shot stands, one shot after the other.
  void turnEverywhere(Way way) {
    const int frames = kFramesPerTurn * static_cast<int>(loaded_.level.shots.size());
    for (int i = 0; i < frames; ++i) {
      const int frame = way == Way::There ? i : frames - 1 - i;
      Camera camera =
          cameraOf(loaded_.level.shots[static_cast<std::size_t>(frame / kFramesPerTurn)]);
      camera.angle += frame % kFramesPerTurn * 360.0 / kFramesPerTurn;
      draw(camera);
    }
  }

  PixelRows draw(const Camera& camera) {
    const PixelRows picture = memory_.rows(camera.width, camera.height);
    renderer_.draw(camera, LightMode::Both, scratch_, picture);
    return picture;
  }

  LoadedLevel loaded_;
  BakedLight light_;
  Renderer renderer_;
  FrameScratch scratch_;
  PixelBuffer memory_;
};

TEST_F(FramesOfTheTutorial, takeNoMemoryOnceTheirScratchHasGrown) {
  turnEverywhere(Way::There);
  const std::size_t before = test::allocationCount();
  turnEverywhere(Way::Back);  // so that viewports get other lists than before
  EXPECT_EQ(test::allocationCount(), before);
}

TEST_F(FramesOfTheTutorial, areThoseOfANewScratch) {
  for (const Shot& shot : loaded_.level.shots) {
    for (const int shrink : {1, 3, 2}) {
      Camera camera = cameraOf(shot);
      camera.width /= shrink;
      camera.height /= shrink;
      EXPECT_EQ(imageOf(draw(camera)), renderer_.draw(camera, LightMode::Both)) << shot.name;
    }
  }
}

TEST(FramesOfThings, takeNoMemoryOnceTheirScratchHasGrown) {
  constexpr std::string_view kPyramid =
      "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 2 0\n"
      "f 1 2 3 4\nf 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n";
  std::string things;
  for (int i = 0; i < 12; ++i)
    things += fmt::format(
        "{{'mesh':'pyramid.obj','x':{0},'y':{1},'angle':{2},'scale':{3}}},"
        "{{'sprite':'#c80000','x':{0},'y':{1},'z':0.3,'size':[1,1]}}{4}",
        1.5 + i % 4 * 1.7, -3 + i / 4 * 2.5, 31 * i, 0.05 + 0.1 * i, i < 11 ? "," : "");
  const LoadedLevel loaded =
      test::levelFrom(fmt::format("{{'light':1,'things':[{}],'sectors':{{{}}}}}", things,
                                  test::sectorText("hall", "0,-4, 8,-4, 8,4, 0,4", 0, 4)),
                      "[]", {{"pyramid.obj", kPyramid}});
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const Renderer renderer(loaded.scene(), loaded.textures, light);
  FrameScratch scratch;
  PixelBuffer memory;
  const auto draw = [&](int turn) {
    const Camera camera{SectorId(0), {4, 0.3, 1.6}, 15.0 * turn, 0, 90, 320, 200};
    renderer.draw(camera, LightMode::Both, scratch, memory.rows(camera.width, camera.height));
  };
  for (int turn = 0; turn < 24; ++turn) draw(turn);
  const std::size_t before = test::allocationCount();
  for (int turn = 24; turn-- > 0;) draw(turn);
  EXPECT_EQ(test::allocationCount(), before);
}

/// Of a renderer and its first frame, in the hall of this level.
std::size_t bytesOfAFrame(const LoadedLevel& loaded) {
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const std::size_t before = test::allocatedBytes();
  (void)Renderer(loaded.scene(), loaded.textures, light)
      .draw({SectorId(0), {1, 0, 1.6}, 0, 0, 90, 320, 200}, LightMode::Both);
  return test::allocatedBytes() - before;
}

TEST(MemoryOfAFrame, doesNotGrowWithSectorsThatAreNotSeen) {
  EXPECT_EQ(bytesOfAFrame(test::levelFrom(test::roomsBehindADoor(1000))),
            bytesOfAFrame(test::levelFrom(test::roomsBehindADoor(1))));
}

TEST(AllocationCount, SeesWhatTakesMemory) {
  const std::size_t before = test::allocationCount();
  const std::size_t bytesBefore = test::allocatedBytes();
  const Image image(10, 1);
  EXPECT_EQ(test::allocationCount(), before + 1);
  EXPECT_EQ(test::allocatedBytes(), bytesBefore + 30);
}

}  // namespace
}  // namespace hearth
