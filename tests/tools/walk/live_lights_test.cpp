// Lights that are edited within a walk, and show before they are saved.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "live_walk.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

using test::write;

class LiveLights : public test::LiveWalk {
 protected:
  void beginEditing() {
    begin();
    lights().open();
    ASSERT_TRUE(lights().isOpen()) << lights().message();
  }
  LightsEditor& lights() { return *loop_->lightsEditor(); }

  void setIntensity(double intensity) {
    lights().pick(0);
    LightDescription light = lights().pickedLight();
    light.source.intensity = intensity;
    lights().set(light);
  }
  void moveTo(Vec3 position) {
    LightDescription light = lights().pickedLight();
    light.source.position = position;
    lights().set(light);
  }

  std::string onDisk() const {
    std::ifstream stream(lightsFile());
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// The picture when the file holds this text, which it then does again not.
  Image freshWith(const std::string& text) {
    const std::string before = onDisk();
    write(lightsFile(), text);
    Image picture = fresh();
    write(lightsFile(), before);
    return picture;
  }

  void roundsForAWhile() {
    for (int i = 0; i < 100; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(2)))
      round();
  }
};

TEST_F(LiveLights, ShowBeforeTheyAreSavedAsIfTheyWere) {
  beginEditing();
  const std::string first = onDisk();
  setIntensity(40);
  EXPECT_TRUE(lights().isUnsaved());
  EXPECT_EQ(onDisk(), first);
  const Image before = stage_.shown;
  const Image expected = freshWith(lights().bytes());
  ASSERT_NE(before, expected);
  EXPECT_TRUE(comesTo([&] { return stage_.shown == expected; }));
}

TEST_F(LiveLights, AreUndoneInThePicture) {
  beginEditing();
  ASSERT_TRUE(comesToShowFresh());
  const Image before = stage_.shown;
  setIntensity(40);
  ASSERT_TRUE(comesTo([&] { return stage_.shown != before; }));
  lights().undo();
  EXPECT_FALSE(lights().isUnsaved());
  EXPECT_TRUE(comesTo([&] { return stage_.shown == before; }));
}

TEST_F(LiveLights, AreSavedAndNotLoadedAgainForIt) {
  beginEditing();
  setIntensity(40);
  roundsForAWhile();
  lights().save();
  EXPECT_FALSE(lights().isUnsaved());
  EXPECT_NE(onDisk().find("\"intensity\": 40,"), std::string::npos) << onDisk();
  const auto shown = live_->shown();
  roundsForAWhile();
  EXPECT_EQ(live_->shown(), shown);
  EXPECT_TRUE(stage_.printed.empty());
  EXPECT_TRUE(comesToShowFresh());
  EXPECT_TRUE(lights().canUndo()) << "the history goes on";
}

TEST_F(LiveLights, AreShownWhileOneIsDraggedWithoutRest) {
  values_.set(Option::Texel, "0.03");  // a bake takes longer than a frame
  beginEditing();
  ASSERT_TRUE(comesToShowFresh());
  lights().pick(0);
  lights().beginDrag();
  int pictures = 0;
  Image last = stage_.shown;
  double x = 2;
  const bool areShown = comesTo([&] {
    moveTo({x = x < 3 ? x + 0.001 : 2, 3, 2.5});
    if (stage_.shown != last) ++pictures;
    last = stage_.shown;
    return pictures == 5;
  });
  lights().endDrag();
  EXPECT_TRUE(areShown);
  const Image expected = freshWith(lights().bytes());
  EXPECT_TRUE(comesTo([&] { return stage_.shown == expected; }));
}

TEST_F(LiveLights, KeepTheLastGoodLightWhereTheLoaderRefusesThem) {
  beginEditing();
  ASSERT_TRUE(comesToShowFresh());
  const auto shown = live_->shown();
  const Image before = stage_.shown;
  lights().pick(0);
  testing::internal::CaptureStderr();
  moveTo({900, 3, 2.5});
  EXPECT_TRUE(comesTo([&] { return stage_.shown != before; })) << "a message stands over it";
  EXPECT_EQ(live_->shown(), shown);
  lights().undo();
  EXPECT_TRUE(comesTo([&] { return stage_.shown == before; }));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LiveLights, AreKeptWhenAnotherProgramChangesTheirFile) {
  beginEditing();
  setIntensity(40);
  const Image edited = freshWith(lights().bytes());
  ASSERT_TRUE(comesTo([&] { return stage_.shown == edited; }));
  const std::string others = R"([{"x": 2, "y": 3, "z": 2.5, "color": "#ff0000"}])";
  write(lightsFile(), others);
  roundsForAWhile();
  EXPECT_EQ(stage_.shown, edited);
  lights().save();
  EXPECT_TRUE(lights().hasConflict());
  EXPECT_NE(lights().message().find("not saved"), std::string::npos) << lights().message();
  EXPECT_EQ(onDisk(), others);
  lights().openAgain();
  EXPECT_FALSE(lights().isUnsaved());
  EXPECT_TRUE(comesToShowFresh());
}

TEST_F(LiveLights, FollowTheirFileWhereNothingIsUnsaved) {
  beginEditing();
  write(lightsFile(), R"([{"x": 2, "y": 3, "z": 2.5, "color": "#ff0000"}])");
  EXPECT_TRUE(comesToShowFresh());
  ASSERT_EQ(lights().lights().lights.size(), 1);
  setIntensity(40);
  lights().save();
  EXPECT_EQ(onDisk(), R"([{"x": 2, "y": 3, "z": 2.5, "intensity": 40, "color": "#ff0000"}])");
  write(lightsFile(), "[");
  EXPECT_TRUE(comesTo([&] { return !lights().isOpen(); }));
  lights().open();
  EXPECT_FALSE(lights().isOpen());
  EXPECT_NE(lights().message().find("not valid JSON"), std::string::npos) << lights().message();
  write(lightsFile(), "[]");
  EXPECT_TRUE(comesTo([&] { return lights().open(), lights().isOpen(); }));
}

TEST_F(LiveLights, OutliveAnEditOfTheLevel) {
  beginEditing();
  setIntensity(40);
  const std::string edited = lights().bytes();
  const Image lit = freshWith(edited);
  ASSERT_TRUE(comesTo([&] { return stage_.shown == lit; }));
  paintFloors("#402010");
  const Image expected = freshWith(edited);
  EXPECT_TRUE(comesTo([&] { return stage_.shown == expected; }));
  EXPECT_TRUE(lights().isUnsaved());
}

TEST_F(LiveLights, ComeIntoALevelThatHadNone) {
  fs::remove(lightsFile());
  beginEditing();
  EXPECT_FALSE(lights().isUnsaved());
  LightDescription light;
  light.source.position = {2, 3, 2.5};
  lights().add(light);
  EXPECT_EQ(lights().picked(), 0);
  const Image dark = stage_.shown;
  EXPECT_TRUE(comesTo([&] { return stage_.shown != dark; }));
  EXPECT_FALSE(fs::exists(lightsFile()));
  lights().save();
  EXPECT_EQ(onDisk(), "[\n  { \"x\": 2, \"y\": 3, \"z\": 2.5 }\n]\n");
  EXPECT_TRUE(comesToShowFresh());
}

}  // namespace
}  // namespace hearth
