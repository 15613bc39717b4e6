#include "walk/recording.h"

#include <fmt/format.h>

#include <filesystem>
#include <random>

#include "support/in_tree.h"
#include "walks.h"

namespace hearth {
namespace {

LoadedLevel tutorial() { return loadLevel(test::inTree("levels/tutorial.json")).loaded.value(); }

/// A walk that asks for everything now and then.
Recording someWalk(const Scene& scene) {
  const Player& player = *scene.level().player;
  Recording recording;
  recording.start = {scene[player.sector].name, player.eye, player.angle, 0};
  Walker walker = *walkerAtStart(scene, recording.start);
  std::mt19937 random(4);
  WalkInput input;
  for (int i = 0; i < 20000; ++i) {
    input.toggleFlight = random() % 1024 == 0;
    if (random() % 64 == 0) {
      input.forward = random() % 4 > 0 ? 127 : -64;
      input.right = static_cast<int>(random() % 3) * 60 - 60;
      input.up = static_cast<int>(random() % 3) * 127 - 127;
      input.turn = static_cast<int>(random() % 6000) - 3000;
      input.pitch = static_cast<int>(random() % 300) - 150;
      input.run = random() % 2 == 0;
      input.jump = random() % 8 == 0;
      input.crouch = random() % 8 == 0;
    }
    recording.inputs.push_back(input);
    walker = walked(scene, walker, input);
  }
  recording.end = recordedState(scene, walker);
  return recording;
}

std::string errorOf(const std::string& text) {
  const auto read = readRecording(text);
  return read ? "read" : fmt::format("{}: {}", read.error().line, read.error().message);
}

class Recordings : public testing::Test {
 protected:
  const LoadedLevel loaded = tutorial();
  const Scene scene = loaded.scene();
  const std::string start = "hearth-walk 1\nstart 1p+0 1p+0 1p+0 0p+0 0p+0 yard\n";
  const std::string end = "end 0p+0 0p+0 0p+0 0p+0 0p+0 0p+0 0p+0 0p+0 0p+0 g yard\n";
};

TEST_F(Recordings, ComeBackFromTextToTheBit) {
  const Recording recording = someWalk(scene);
  const auto read = readRecording(writeRecording(recording));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, recording);
  Walker walker = *walkerAtStart(scene, read->start);
  for (const WalkInput& input : read->inputs) walker = walked(scene, walker, input);
  EXPECT_EQ(recordedState(scene, walker), read->end);
}

TEST_F(Recordings, KeepNamesOfAnyKind) {
  Recording recording;
  for (const char* name : {"two words", "%41", "line\nbreak", "gr\xC3\xBCn", "end"}) {
    recording.start.sector = recording.end.sector = name;
    const auto read = readRecording(writeRecording(recording));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, recording);
  }
}

TEST_F(Recordings, NameTheLineOfAMistake) {
  EXPECT_EQ(errorOf(start + end), "read");
  EXPECT_EQ(errorOf(""), "1: the first line must be \"hearth-walk 1\"");
  EXPECT_EQ(errorOf("hearth-walk 2\n").substr(0, 2), "1:");
  EXPECT_EQ(errorOf("hearth-walk 1\nstart 1 1 1 0 nan yard\n" + end).substr(0, 2), "2:");
  const std::string tick = "1 127 0 0 0 0 -\n";
  EXPECT_EQ(errorOf(start + tick + end), "read");
  for (const char* bad :
       {"1 127 0 0 0 0\n", "0 127 0 0 0 0 -\n", "1 127 0 0 0 0 x\n", "1 127 0 0 0 0 - -\n",
        "-1 0 0 0 0 0 -\n", "1 9999999999 0 0 0 0 -\n", "\n", "end 0 0\n"})
    EXPECT_EQ(errorOf(start + tick + bad + end).substr(0, 2), "4:") << bad;
  EXPECT_EQ(errorOf(start + tick).substr(0, 2), "4:") << "no end";
  EXPECT_EQ(errorOf(start + end + tick), "3: nothing may follow the end");
}

TEST_F(Recordings, AreRefusedBeforeTheyFillTheMemory) {
  EXPECT_EQ(errorOf(start + "99999999999 127 0 0 0 0 -\n" + end),
            "3: a recording of more than eight hours");
  std::string many = start;
  for (int i = 0; i < 3; ++i) many += fmt::format("{} 0 0 0 0 0 -\n", kMaxRecordedTicks / 2);
  EXPECT_EQ(errorOf(many + end), "5: a recording of more than eight hours");
}

TEST_F(Recordings, SayWhatOfThemTheLevelDoesNotHave) {
  EXPECT_FALSE(walkerAtStart(scene, {"nowhere", {0, 0, 0}, 0, 0}));
  EXPECT_FALSE(walkerAtStart(scene, {"yard", {1000, 0, 0}, 0, 0}));
}

/// The same bits in every build: where twenty thousand ticks of everything end.
TEST_F(Recordings, EndAtTheSameBitsInEveryBuild) {
  const std::string text = writeRecording(someWalk(scene));
  EXPECT_EQ(text.substr(text.rfind("end")),
            "end -1.1611660da3dbep+0 1.de7c6c53e4584p+1 -1.6666666666666p+1 1.aec6b42f0b9ap-2 "
            "-1.18e2f6771635ep+1 0p+0 1.06efdf3b645ep+8 -1.97e76c8b4391cp+5 0p+0 g cellar\n");
}

}  // namespace
}  // namespace hearth
