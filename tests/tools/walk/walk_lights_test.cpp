// Lights that are picked, dragged, undone and saved in a walk, without a window.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "staged_walk.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

using test::down;
using test::up;

/// 2 m before the player of `rooms`, half a metre to the left, at the height of the eye.
const std::string kLights =
    "[\r\n  { \"//\": \"kept\", \"x\": 3.0, \"y\": 1.50, \"z\": 16e-1 } ,\r\n"
    "\t{\"z\":5,\"x\":6,\"y\":2}\r\n]\r\n";

std::string withFirstAt(const std::string& x, const std::string& y, const std::string& z) {
  return "[\r\n  { \"//\": \"kept\", \"x\": " + x + ", \"y\": " + y + ", \"z\": " + z +
         " } ,\r\n\t{\"z\":5,\"x\":6,\"y\":2}\r\n]\r\n";
}

fs::path writtenLights() {
  fs::path file = fs::path(testing::TempDir()) / ("lights-" + std::to_string(::getpid()));
  std::ofstream(file) << kLights;
  return file;
}

/// As on a US keyboard.
KeyEvent keyOf(char letter) {
  const auto number = indexOf(Key::A) + static_cast<std::size_t>(letter - 'a');
  return {.key = static_cast<Key>(number), .letter = letter};
}

KeyEvent ctrlAnd(char letter) {
  KeyEvent key = keyOf(letter);
  key.hasCtrl = true;
  return key;
}

constexpr KeyEvent kCtrl{.key = Key::LeftCtrl, .hasCtrl = true};

/// 640 pixels to the metre at a depth of 1 m, the eye's level in the middle of 1280x720.
class LightsWalk : public test::StagedWalk {
 public:
  LightsWalk() : StagedWalk(WalkSettings{.lightsFile = writtenLights()}) {
    stage.window = ImageSize{1280, 720};
    now();
    plain = stage.shown;
    now(down(Key::F1));
    settle();
  }
  ~LightsWalk() { fs::remove(lights().file()); }

  LightsEditor& lights() { return *loop().lightsEditor(); }
  std::string onDisk() {
    std::ifstream stream(lights().file());
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  void settle() { ticks(4); }
  void press(int x, int y) { now(test::pressAt(x, y)); }
  void move(int x, int y) { now(test::moveTo(x, y)); }
  void release(int x, int y) { now(test::releaseAt(x, y)); }
  void drag(int fromX, int fromY, int toX, int toY) {
    press(fromX, fromY);
    move((fromX + toX) / 2, fromY + 1);
    move(toX, toY);
    release(toX, toY);
  }

  Image plain;  ///< the picture without the overlay
};

TEST(WalkLights, AreMarkedWhileTheOverlayIsOpen) {
  LightsWalk walk;
  EXPECT_EQ(walk.stage.shown.at(480, 360), (Rgb{255, 255, 255})) << "its colour";
  EXPECT_EQ(walk.stage.shown.at(480, 355), (Rgb{0, 0, 0})) << "its rim";
  EXPECT_EQ(walk.stage.shown.at(480, 354), walk.plain.at(480, 354));
  walk.now(down(Key::F1));
  EXPECT_EQ(walk.stage.shown, walk.plain);
}

TEST(WalkLights, ArePickedByAClickOnTheirMark) {
  LightsWalk walk;
  walk.press(400, 360);
  walk.release(400, 360);
  EXPECT_FALSE(walk.lights().picked());
  walk.press(483, 357);
  walk.release(483, 357);
  EXPECT_EQ(walk.lights().picked(), 0);
  EXPECT_FALSE(walk.lights().isUnsaved()) << "a click moves nothing";
  EXPECT_FALSE(walk.stage.isMouseCaptured);
  walk.settle();
  EXPECT_EQ(walk.stage.shown.at(480, 355), (Rgb{255, 255, 255})) << "a white rim";
}

TEST(WalkLights, AreDraggedToTheSideAndUp) {
  LightsWalk walk;
  walk.drag(482, 361, 482 - 160, 361 - 64);
  EXPECT_EQ(walk.lights().bytes(), withFirstAt("3.0", "1", "1.8"));
  walk.settle();
  EXPECT_EQ(walk.stage.shown.at(320, 296), (Rgb{255, 255, 255})) << "the mark has followed";
  walk.move(600, 300);
  EXPECT_EQ(walk.lights().bytes(), withFirstAt("3.0", "1", "1.8")) << "it was let go of";
  EXPECT_EQ(walk.onDisk(), kLights);
}

TEST(WalkLights, AreDraggedUpAndDownWithShift) {
  LightsWalk walk;
  walk.now(down(Key::LeftShift));
  walk.drag(480, 360, 400, 360 - 64);
  walk.now(up(Key::LeftShift));
  EXPECT_EQ(walk.lights().bytes(), withFirstAt("3.0", "1.50", "1.8"));
}

TEST(WalkLights, AreDraggedAlongTheAxisWhoseKeyIsHeld) {
  LightsWalk walk;
  KeyEvent y = keyOf('y');
  walk.now(y);
  walk.drag(480, 360, 320, 360 - 64);
  y.isDown = false;
  walk.now(y);
  EXPECT_EQ(walk.lights().bytes(), withFirstAt("3.0", "1", "16e-1"));
  walk.drag(320, 360, 480, 360 - 64);
  EXPECT_EQ(walk.lights().bytes(), withFirstAt("3.0", "1.5", "1.8")) << "and then freely";
}

TEST(WalkLights, ShowTheirAxesWhileTheyAreDragged) {
  LightsWalk walk;
  const auto isGreen = [&](int x, int y) {
    const Rgb pixel = walk.stage.shown.at(x, y);
    return pixel.g > 200 && pixel.r < 160 && pixel.b < 160;
  };
  walk.press(480, 360);
  walk.move(400, 360);
  walk.settle();
  EXPECT_TRUE(isGreen(430, 360)) << "y runs to the right here";
  walk.release(400, 360);
  walk.settle();
  EXPECT_FALSE(isGreen(430, 360));
}

TEST(WalkLights, AreDraggedAlongOneAxisOfTheMapWithShift) {
  LightsWalk walk;
  walk.now(down(Key::Tab));
  walk.settle();
  walk.now(down(Key::LeftShift));
  walk.drag(685, 349, 640, 339);
  walk.now(up(Key::LeftShift));
  EXPECT_EQ(walk.lights().bytes(), withFirstAt("1", "1.50", "16e-1"));
}

TEST(WalkLights, AreHollowBehindWalls) {
  LightsWalk walk;
  walk.lights().pick(1);
  LightDescription light = walk.lights().pickedLight();
  light.source.position = {30, 2, 1.6};  // straight on, beyond the walls
  walk.lights().set(light);
  walk.lights().pick({});
  walk.ticks(32);  // half a second, in which it is drawn anew
  EXPECT_EQ(walk.stage.shown.at(640, 360), walk.plain.at(640, 360)) << "what is before it shows";
  EXPECT_NE(walk.stage.shown.at(640, 355), walk.plain.at(640, 355)) << "its rim";
}

TEST(WalkLights, AreDraggedOverThePlanOnTheMap) {
  LightsWalk walk;
  walk.now(down(Key::Tab));
  walk.settle();
  const double pixelsPerMetre = 720 / kFirstMapMetres;  // 22.5
  EXPECT_EQ(walk.stage.shown.at(640 + 45, 349), (Rgb{255, 255, 255}));
  walk.drag(685, 349, 685 - static_cast<int>(2 * pixelsPerMetre), 349);
  EXPECT_EQ(walk.lights().bytes(), withFirstAt("1", "1.50", "16e-1"));
}

TEST(WalkLights, StayWhereTheyWereWhenTheMouseComesFromThePanel) {
  LightsWalk walk;
  walk.press(1279, 700);
  walk.move(480, 360);
  walk.move(300, 300);
  walk.release(300, 300);
  EXPECT_EQ(walk.lights().bytes(), kLights);
}

TEST(WalkLights, AreUndoneAndRedoneByKeys) {
  LightsWalk walk;
  walk.drag(480, 360, 320, 360);
  const std::string edited = walk.lights().bytes();
  walk.now(ctrlAnd('z'));
  EXPECT_EQ(walk.lights().bytes(), kLights);
  EXPECT_FALSE(walk.lights().isUnsaved());
  walk.now(ctrlAnd('y'));
  EXPECT_EQ(walk.lights().bytes(), edited);
  walk.now(ctrlAnd('z'));
  KeyEvent redo = ctrlAnd('z');
  redo.hasShift = true;
  walk.now(redo);
  EXPECT_EQ(walk.lights().bytes(), edited);
}

TEST(WalkLights, AreSavedByCtrlSWhichDoesNotWalk) {
  LightsWalk walk;
  walk.drag(480, 360, 320, 360);
  walk.now(kCtrl);
  walk.now(ctrlAnd('s'));
  walk.ticks(4);
  EXPECT_EQ(walk.onDisk(), withFirstAt("3.0", "1", "16e-1"));
  EXPECT_FALSE(walk.lights().isUnsaved());
  EXPECT_EQ(walk.walker().feet, walk.start().feet);
  EXPECT_EQ(walk.inputs().back().up, 0) << "nor does Ctrl crouch";
}

TEST(WalkLights, AreSavedByCtrlSWhileTheirNameIsTyped) {
  LightsWalk walk;
  walk.press(480, 360);
  walk.release(480, 360);
  walk.settle();
  const auto isRenamed = [&] { return walk.lights().bytes().find('Q') != std::string::npos; };
  for (int y = 130; y < 700 && !isRenamed(); y += 7) {  // from the list down to the field
    walk.press(1200, y);
    walk.release(1200, y);
    walk.now(TypedText{"Q"});
    walk.settle();
  }
  ASSERT_TRUE(isRenamed());
  walk.now(kCtrl);
  walk.now(ctrlAnd('s'));
  EXPECT_EQ(walk.onDisk(), walk.lights().bytes());
}

TEST(WalkLights, AreNotSavedWhereTheLevelHasNoAirForThem) {
  LightsWalk walk;
  walk.lights().pick(0);
  LightDescription light = walk.lights().pickedLight();
  light.source.position.y = -5;
  walk.lights().set(light);
  walk.now(ctrlAnd('s'));
  EXPECT_EQ(walk.onDisk(), kLights);
  EXPECT_TRUE(walk.lights().isUnsaved());
  EXPECT_TRUE(walk.lights().message().starts_with("not saved: light 0: "))
      << walk.lights().message();
  light.source.position.y = 1;
  light.sector = NameReference{"nowhere", {}};
  walk.lights().set(light);
  walk.now(ctrlAnd('s'));
  EXPECT_EQ(walk.onDisk(), kLights);
  light.sector.reset();
  walk.lights().set(light);
  walk.now(ctrlAnd('s'));
  EXPECT_FALSE(walk.lights().isUnsaved()) << walk.lights().message();
}

TEST(WalkLights, AreLetGoOfWhenTheOverlayCloses) {
  LightsWalk walk;
  walk.press(480, 360);
  walk.move(400, 360);
  walk.now(down(Key::F1));
  EXPECT_TRUE(walk.lights().canUndo()) << "the drag has ended";
}

TEST(WalkLights, AreToldToBeUnsavedWhenTheOverlayCloses) {
  LightsWalk walk;
  walk.drag(480, 360, 400, 360);
  walk.now(down(Key::Escape));
  EXPECT_NE(walk.stage.shown, walk.plain) << "a message";
  walk.go(1, 3);
  EXPECT_EQ(walk.stage.shown, walk.plain);
}

TEST(WalkLights, AskOnceBeforeTheyAreLost) {
  LightsWalk walk;
  walk.drag(480, 360, 400, 360);
  walk.now(down(Key::Escape));  // closes the overlay
  walk.go(1, 3);
  walk.now(down(Key::Escape));
  EXPECT_TRUE(walk.isOn);
  EXPECT_NE(walk.stage.shown, walk.plain) << "a message";
  walk.now(down(Key::Escape));
  EXPECT_FALSE(walk.isOn);
}

TEST(WalkLights, AskAgainAfterTheyWereLookedAt) {
  LightsWalk walk;
  walk.drag(480, 360, 400, 360);
  walk.now(WindowEvent::CloseAsked);
  EXPECT_TRUE(walk.isOn) << "so does the window's own button";
  walk.now(down(Key::F1));
  walk.now(WindowEvent::CloseAsked);
  EXPECT_TRUE(walk.isOn);
  walk.now(WindowEvent::CloseAsked);
  EXPECT_FALSE(walk.isOn);
}

TEST(WalkLights, AskNothingWhenTheyAreSaved) {
  LightsWalk walk;
  walk.drag(480, 360, 400, 360);
  walk.now(ctrlAnd('s'));
  walk.now(down(Key::Escape));
  walk.now(down(Key::Escape));
  EXPECT_FALSE(walk.isOn);
}

}  // namespace
}  // namespace hearth
