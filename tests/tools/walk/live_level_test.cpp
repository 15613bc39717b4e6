// Files that are saved while a walk goes on in their level.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "image/image_file.h"
#include "light/blended_light.h"
#include "light/saved_bake.h"
#include "live_walk.h"
#include "viewer/edit/movers_edit.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

using test::kPatience;
using test::LiveWalk;
using test::write;

Json read(const fs::path& file) { return Json::parse(std::ifstream(file)); }

Image plain(Rgb color) { return {4, 4, color}; }

TEST_F(LiveWalk, ShowsALightThatWasChangedAndSaved) {
  begin();
  const Image before = stage_.shown;
  Json lights = read(lightsFile());
  lights[0]["intensity"] = 40;
  write(lightsFile(), lights.dump());
  ASSERT_TRUE(isTold("rooms.lights.json: shown"));
  EXPECT_NE(stage_.shown, before);
  EXPECT_EQ(stage_.shown, fresh());
}

TEST_F(LiveWalk, SharesItsTexturesWithTheLevelBeforeWhereOnlyLightsWereSaved) {
  begin();
  const auto before = live_->shown();
  Json lights = read(lightsFile());
  lights[0]["intensity"] = 40;
  write(lightsFile(), lights.dump());
  ASSERT_TRUE(isTold("rooms.lights.json: shown"));
  EXPECT_TRUE(live_->shown()->loaded->textures.sharesWith(before->loaded->textures));
  EXPECT_EQ(live_->shown()->renderer.textures(), before->renderer.textures());
}

TEST_F(LiveWalk, ShowsAFileThatWasPutInPlaceOfTheOld) {
  begin();
  Json lights = read(lightsFile());
  lights[0]["color"] = "#ff2000";
  write(folder_ / "new", lights.dump());
  fs::rename(folder_ / "new", lightsFile());
  ASSERT_TRUE(isTold("rooms.lights.json: shown"));
  EXPECT_EQ(stage_.shown, fresh());
}

TEST_F(LiveWalk, ShowsWhatWasWrittenThroughALink) {
  fs::create_directories(folder_ / "kept");
  fs::rename(lightsFile(), folder_ / "kept/lights.json");
  fs::create_symlink("kept/lights.json", lightsFile());
  begin();
  Json lights = read(lightsFile());
  lights[0]["intensity"] = 40;
  write(lightsFile(), lights.dump());
  ASSERT_TRUE(isTold("lights.json: shown"));
  EXPECT_EQ(stage_.shown, fresh());
}

TEST_F(LiveWalk, ShowsATextureThatWasPaintedAnew) {
  ASSERT_TRUE(writePng(folder_ / "paint.png", plain({200, 0, 0})));
  paintFloors("paint");
  begin();
  const Image before = stage_.shown;
  ASSERT_TRUE(writePng(folder_ / "paint.png", plain({0, 0, 200})));
  ASSERT_TRUE(isTold("paint.png: shown"));
  EXPECT_NE(stage_.shown, before);
  EXPECT_EQ(stage_.shown, fresh());
}

TEST_F(LiveWalk, KeepsTheLastGoodLevelBehindTheMistakesUntilTheyAreMended) {
  begin();
  const Image before = stage_.shown;
  const std::string good = read(levelFile()).dump();
  write(levelFile(), "{ \"sectors\": ");
  ASSERT_TRUE(comesTo([&] { return stage_.shown != before; }));  // the message is over it
  int same = 0;
  for (int y = before.height() / 2; y < before.height(); ++y)
    for (int x = 0; x < before.width(); ++x) same += stage_.shown.at(x, y) == before.at(x, y);
  EXPECT_EQ(same, before.width() * (before.height() - before.height() / 2));
  write(levelFile(), good);
  ASSERT_TRUE(isTold("rooms.json: shown"));
  EXPECT_EQ(stage_.shown, before);
}

TEST_F(LiveWalk, KeepsTheMistakesOfTheLevelWhereOnlyItsLightsAreSaved) {
  begin();
  const Image before = stage_.shown;
  const std::string good = read(levelFile()).dump();
  write(levelFile(), "{");
  ASSERT_TRUE(comesTo([&] { return stage_.shown != before; }));
  const Image broken = stage_.shown;
  Json lights = read(lightsFile());
  lights[0]["intensity"] = 40;
  write(lightsFile(), lights.dump());
  for (int i = 0; i < 100; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(2))) round();
  EXPECT_EQ(stage_.shown, broken);
  write(levelFile(), good);
  ASSERT_TRUE(isTold("rooms.json: shown"));
  EXPECT_EQ(stage_.shown, fresh());
}

TEST_F(LiveWalk, LeavesTheMistakesWhereAGoodSaveWasFollowedByABadOne) {
  values_.set(Option::Texel, "0.06");
  begin();
  const std::string good = read(levelFile()).dump();
  for (int intensity = 40; intensity < 200; intensity += 20) {
    Json lights = read(lightsFile());
    lights[0]["intensity"] = intensity;
    write(lightsFile(), lights.dump());
    round();
    std::this_thread::sleep_for(std::chrono::milliseconds(intensity / 20));
    write(levelFile(), "{");
    for (int i = 0; i < 100; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(2)))
      round();
    const Image broken = stage_.shown;
    stage_.printed.clear();
    write(levelFile(), good);
    ASSERT_TRUE(isTold("rooms.json: shown"));
    EXPECT_NE(broken, stage_.shown) << intensity;
  }
}

TEST_F(LiveWalk, ShowsALevelOnceTheImageHasComeThatItNames) {
  begin();
  const Image before = stage_.shown;
  paintFloors("late");
  ASSERT_TRUE(comesTo([&] { return stage_.shown != before; }));
  ASSERT_TRUE(writePng(folder_ / "late.png", plain({0, 200, 0})));
  ASSERT_TRUE(comesToShowFresh());
}

TEST_F(LiveWalk, ShowsLightsThatWereSavedWithTheLevel) {
  writeRoom("room", 0);
  begin();
  writeRoom("room", 0.5);
  ASSERT_TRUE(isTold(": shown"));
  ASSERT_TRUE(comesToShowFresh());
  write(lightsFile(), R"([{"x": 1, "y": 1, "z": 2.5, "falloff": 0.4}])");
  ASSERT_TRUE(comesToShowFresh());
}

TEST_F(LiveWalk, ShowsLightsThatComeAfterTheLevel) {
  const Json lights = read(lightsFile());
  fs::remove(lightsFile());
  begin();
  const Image dark = stage_.shown;
  write(lightsFile(), lights.dump());
  ASSERT_TRUE(isTold("rooms.lights.json: shown"));
  EXPECT_NE(stage_.shown, dark);
  EXPECT_EQ(stage_.shown, fresh());
  fs::remove(lightsFile());
  write(levelFile(), read(levelFile()).dump());
  ASSERT_TRUE(isTold("rooms.json: shown"));
  EXPECT_EQ(stage_.shown, dark);
  write(lightsFile(), lights.dump());
  ASSERT_TRUE(isTold("rooms.lights.json: shown"));
  EXPECT_EQ(stage_.shown, fresh());
}

TEST_F(LiveWalk, SaysNothingOfALevelWhoseLightsFollow) {
  begin(kPatience);
  testing::internal::CaptureStderr();
  writeRoom("room", 0.5);
  const std::string lights = R"([{"x": 2, "y": 2, "z": 2.5, "falloff": 0.4}])";
  for (const char* bad : {"{", R"([{"x": 90, "y": 2, "z": 2.5}])"}) {
    write(lightsFile(), bad);
    for (int i = 0; i < 5; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(2))) round();
    write(lightsFile(), lights);
    EXPECT_TRUE(isTold("shown"));
    EXPECT_EQ(stage_.shown, fresh());
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LiveWalk, ShowsTheMistakesOfLightsUntilTheyAreMended) {
  begin();
  const Image before = stage_.shown;
  const std::string good = read(lightsFile()).dump();
  write(lightsFile(), R"([{"x": 1}])");
  ASSERT_TRUE(comesTo([&] { return stage_.shown != before; }));
  write(lightsFile(), good);
  ASSERT_TRUE(isTold("rooms.lights.json: shown"));
  EXPECT_EQ(stage_.shown, before);
}

TEST_F(LiveWalk, ShowsOnlyTheLastOfSeveralSaves) {
  begin();
  for (const int intensity : {30, 60, 90, 120}) {
    Json lights = read(lightsFile());
    lights[0]["intensity"] = intensity;
    write(lightsFile(), lights.dump());
    round();
  }
  ASSERT_TRUE(comesToShowFresh());
}

TEST_F(LiveWalk, ShowsADraftWhereBakingTakesLong) {
  values_.set(Option::Texel, "0.03");
  begin();
  ASSERT_TRUE(comesToShowFresh());
  Json lights = read(lightsFile());
  for (Json& light : lights) light["intensity"] = 50;
  write(lightsFile(), lights.dump());
  ASSERT_TRUE(isTold("rooms.lights.json: a draft is shown"));
  ASSERT_TRUE(isTold("rooms.lights.json: shown"));
  EXPECT_EQ(stage_.shown, fresh());
}

TEST_F(LiveWalk, OptionsThatAreChosenBakeAnew) {
  begin();
  OptionValues chosen = values_;
  chosen.set(Option::Texel, "0.5");
  ASSERT_NE(fresh(chosen), fresh());
  loop_->choose(chosen);
  const Image expected = fresh(chosen);
  EXPECT_TRUE(comesTo([&] { return stage_.shown == expected; }));
  // Edits are baked by them, too.
  paintFloors("#402010");
  const Image edited = fresh(chosen);
  EXPECT_TRUE(comesTo([&] { return stage_.shown == edited; }));
}

TEST_F(LiveWalk, OptionsOfFramesThatAreChosenShowAtOnce) {
  begin();
  ASSERT_TRUE(comesToShowFresh());
  OptionValues chosen = values_;
  chosen.set(Option::PixelSize, "4");
  loop_->choose(chosen);
  round();
  round();
  EXPECT_EQ(stage_.shown, fresh(chosen));
}

TEST_F(LiveWalk, OptionsThatNoBakeTakesAreToldAndCanBeTakenBack) {
  begin();
  ASSERT_TRUE(comesToShowFresh());
  const Image lit = fresh();
  OptionValues chosen = values_;
  chosen.set(Option::Texel, "1e-6");
  loop_->choose(chosen);
  EXPECT_TRUE(comesTo([&] { return stage_.shown != lit; })) << "a note stands over it";
  loop_->choose(values_);
  EXPECT_TRUE(comesToShowFresh());
}

TEST_F(LiveWalk, LightsADoorThatWasOpened) {
  writeHall();
  begin();
  const LoadedLevel open = loadAt(std::vector{1.0, 0.0});
  const BakedLight light = bake(open.scene(), open.level.bake, 2);
  stage_.events.push_back(test::down(Key::E));
  EXPECT_TRUE(comesTo(
      [&] { return session_->level().shares()[0] == 1 && stage_.shown == freshAt(open, light); }));
}

TEST_F(LiveWalk, LightsADoorFromASavedBakeThatHoldsItsState) {
  writeHall();
  const LoadedLevel shut = load();
  const LoadedLevel open = loadAt(std::vector{1.0, 0.0});
  BakeSettings coarse;
  coarse.texel = 0.5;  // which no bake of the level's own has
  const BakedLight light = bake(open.scene(), coarse, 2);
  write(folder_ / "x.bake",
        encodeBake(shut.scene(), bake(shut.scene(), coarse, 2), coarse.texel, "") +
            encodeBake(open.scene(), light, coarse.texel, ""));
  values_.set(Option::LightFrom, (folder_ / "x.bake").string());
  begin();
  stage_.events.push_back(test::down(Key::E));
  EXPECT_TRUE(comesTo(
      [&] { return session_->level().shares()[0] == 1 && stage_.shown == freshAt(open, light); }));
}

TEST_F(LiveWalk, LightsADoorAsItWasWhereASavedBakeDoesNotHoldItsState) {
  writeHall();
  const LoadedLevel shut = load();
  const BakedLight light = bake(shut.scene(), {}, 2);
  write(folder_ / "x.bake", encodeBake(shut.scene(), light, BakeSettings{}.texel, ""));
  values_.set(Option::LightFrom, (folder_ / "x.bake").string());
  testing::internal::CaptureStderr();
  begin();
  stage_.events.push_back(test::down(Key::E));
  ASSERT_TRUE(comesTo([&] { return session_->level().shares()[0] == 1; }));
  for (int i = 0; i < 200; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(2))) round();
  EXPECT_NE(testing::internal::GetCapturedStderr().find("with its movers elsewhere: "),
            std::string::npos);
  const LoadedLevel open = loadAt(std::vector{1.0, 0.0});
  BlendedLight as;
  const LightAtRest rest{{open.level, shut.geometry}, &light};
  as.setStates({&rest, 1});
  as.blend(open.scene(), std::vector{1.0});
  EXPECT_EQ(stage_.shown, freshAt(open, as.light()));
}

TEST_F(LiveWalk, KeepsADoorOpenWhileItsLightIsEdited) {
  writeHall();
  begin();
  stage_.events.push_back(test::down(Key::E));
  ASSERT_TRUE(comesTo([&] { return session_->level().shares()[0] == 1; }));
  write(lightsFile(), R"([{"x":3,"y":1,"z":2,"intensity":100}])");
  const LoadedLevel open = loadAt(std::vector{1.0, 0.0});
  const BakedLight light = bake(open.scene(), open.level.bake, 2);
  EXPECT_TRUE(comesTo([&] { return stage_.shown == freshAt(open, light); }));
  EXPECT_EQ(session_->level().shares()[0], 1);
}

TEST_F(LiveWalk, GoesOnWithAMoverThatItHasWritten) {
  writeHall();
  begin();
  stage_.events = {test::down(Key::E), test::up(Key::E)};
  ASSERT_TRUE(comesTo([&] { return session_->level().movers()[0].share == 1; }));
  const MoverEdit edit{"gate", MoverTrigger::None, 0.25};
  ASSERT_TRUE(writeMover(disk_, *live_->shown()->loaded, edit));
  ASSERT_TRUE(comesTo([&] { return editOf(session_->level().level().movers[0]) == edit; }));
  EXPECT_EQ(session_->level().movers()[0].share, 1) << "where it stood";
  EXPECT_TRUE(writeMover(disk_, *live_->shown()->loaded, {"gate", MoverTrigger::Use, 2}))
      << "and it can be written again";
}

TEST_F(LiveWalk, LiftsTheWalkerWithTheFloor) {
  writeRoom("room", 0);
  begin();
  writeRoom("room", 0.5);
  ASSERT_TRUE(isTold(": shown"));
  EXPECT_EQ(session_->walker().feet, (Vec3{1, 2, 0.5}));
  EXPECT_TRUE(comesToShowFresh());
}

TEST_F(LiveWalk, GoesOnWhereTheWalkerStandsUnderAnotherName) {
  writeRoom("room", 0);
  begin();
  writeRoom("chamber", 0);
  ASSERT_TRUE(isTold(": shown"));
  EXPECT_EQ(session_->walker().feet, (Vec3{1, 2, 0}));
  EXPECT_EQ(load().level[session_->walker().sector].name, "chamber");
}

TEST_F(LiveWalk, GoesBackToTheStartWhereThereIsNoRoomAnyMore) {
  begin();
  const LoadedLevel loaded = load();
  Walker walker = session_->walker();
  walker.feet = walker.feet + Vec3{1000, 0, 0};
  const auto carried = carriedOver(loaded.scene(), walker, loaded.scene());
  ASSERT_TRUE(carried);
  EXPECT_EQ(carried->feet, session_->walker().feet);
}

}  // namespace
}  // namespace hearth
