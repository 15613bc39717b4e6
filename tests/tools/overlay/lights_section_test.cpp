// The section that edits lights: its list, its fields, its buttons.

#include "viewer/overlay/lights_section.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "desktop/disk.h"
#include "loaded.h"
#include "support/canvas.h"
#include "viewer/overlay/overlay.h"
#include "walk/stage.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

// Pixels of the panel, as it is laid out: its padding, the buttons and the list below its header,
// and what is below these.
constexpr int kPadding = 8;
constexpr int kButtons = 40;
constexpr int kFirstRow = 66;
constexpr int kRow = 17;
constexpr int kFieldsBegin = 175;
constexpr int kFieldsEnd = 300;
constexpr int kFieldLeft = 90;
constexpr int kColumn = 130;  // of three numbers in a row

const std::string kLights =
    R"([{"x":2,"y":3,"z":2.5,"radius":0.1,"intensity":220,"falloff":0.4},{"x":6,"y":2,"z":5}])";

class LightsSectionTest : public testing::Test {
 protected:
  LightsSectionTest()
      : file_(fs::path(testing::TempDir()) / ("section-" + std::to_string(::getpid()))),
        tool_(disk_, (std::ofstream(file_) << kLights, file_), {}) {
    editor().open();
    overlay_.toggle();
    frame();
    left_ = overlay_.widthBeside(picture_.width()) + kPadding;
  }
  ~LightsSectionTest() override { fs::remove(file_); }

  LightsEditor& editor() { return tool_.editor(); }
  const LightSource& light() { return editor().lights().lights[0].source; }

  void frame() {
    overlay_.draw(
        now_ += 0.02, [&] { showLights(&tool_, rooms_.scene(), camera_); }, picture_);
  }
  void send(const Event& event) {
    overlay_.handle(event);
    frame();
    frame();
  }
  void moveTo(int x, int y) { send(test::moveTo(left_ + x, y)); }
  void press(int x, int y) { send(test::pressAt(left_ + x, y)); }
  void release(int x, int y) { send(test::releaseAt(left_ + x, y)); }
  void click(int x, int y) {
    press(x, y);
    release(x, y);
  }
  void type(const char* text) { send(TypedText{text}); }
  void drag(int x, int y) {
    moveTo(x, y);
    press(x, y);
    for (const int way : {10, 20, 30}) moveTo(x + way, y);
    release(x + 30, y);
  }

  /// The keys of the first light that are not as they were.
  std::set<std::string> changedKeys() {
    std::set<std::string> keys;
    const LightSource& now = light();
    if (now.position.x != 2) keys.insert("x");
    if (now.position.y != 3) keys.insert("y");
    if (now.position.z != 2.5) keys.insert("z");
    if (now.radius != 0.1) keys.insert("radius");
    if (now.intensity != 220) keys.insert("intensity");
    if (now.falloff != 0.4) keys.insert("falloff");
    return keys;
  }

  LoadedLevel rooms_ = loaded("tests/levels/rooms.json");
  Camera camera_{rooms_.level.player->sector, rooms_.level.player->eye};
  fs::path file_;
  Disk disk_;
  LightsTool tool_;
  Overlay overlay_;
  test::Canvas picture_{700, 600};
  int left_ = 0;
  double now_ = 1;
};

TEST_F(LightsSectionTest, PicksALightInItsList) {
  EXPECT_FALSE(editor().picked());
  click(60, kFirstRow + kRow);
  EXPECT_EQ(editor().picked(), 1);
  click(60, kFirstRow);
  EXPECT_EQ(editor().picked(), 0);
  EXPECT_FALSE(editor().isUnsaved());
}

TEST_F(LightsSectionTest, HasAFieldForEachNumberAndMakesOneStepOfADrag) {
  click(60, kFirstRow);
  std::set<std::string> found;
  for (int y = kFieldsBegin; y < kFieldsEnd; y += 7)
    for (const int column : {0, 1, 2}) {
      drag(kFieldLeft + column * kColumn, y);
      const std::set<std::string> changed = changedKeys();
      EXPECT_LE(changed.size(), 1) << y;
      found.insert(changed.begin(), changed.end());
      if (editor().canUndo()) editor().undo();
      EXPECT_EQ(editor().bytes(), kLights) << y;
      EXPECT_FALSE(editor().canUndo()) << y;
    }
  EXPECT_EQ(found, (std::set<std::string>{"x", "y", "z", "radius", "intensity", "falloff"}));
}

TEST_F(LightsSectionTest, GoesThroughAFieldInAFewHundredPixels) {
  click(60, kFirstRow);
  LightDescription far = editor().pickedLight();
  far.source.falloff = 12;
  editor().set(far);
  bool isFound = false;
  for (int y = kFieldsBegin; y < kFieldsEnd && !isFound; y += 7) {
    moveTo(300, y);
    press(300, y);
    for (int x = 290; x >= 0; x -= 10) moveTo(x, y);
    release(0, y);
    isFound = light().falloff != 12;
  }
  ASSERT_TRUE(isFound);
  EXPECT_LT(light().falloff, 0.2) << "from 12";
}

TEST_F(LightsSectionTest, NamesALightInOneStep) {
  click(60, kFirstRow);
  for (int y = kFieldsBegin - 20; y < kFieldsEnd && editor().commentOf(0).empty(); y += 7) {
    click(kFieldLeft, y);
    type("lamp");
    click(690 - left_, 590);  // away from it
    if (editor().commentOf(0).empty() && editor().canUndo()) editor().undo();
  }
  EXPECT_EQ(editor().commentOf(0), "lamp");
  EXPECT_TRUE(editor().bytes().starts_with(R"([{"//":"lamp","x":2,)"));
  editor().undo();
  EXPECT_EQ(editor().bytes(), kLights);
}

TEST_F(LightsSectionTest, AddsAndTakesOutPointsOfACurve) {
  click(60, kFirstRow);
  LightDescription curved = editor().pickedLight();
  curved.source.curve = {{0, 200}, {2, 100}};
  editor().set(curved);
  const auto points = [this] { return light().curve; };
  const int right = picture_.width() - left_;
  const auto clickUntil = [&](int x, std::size_t count) {
    for (int y = kFieldsBegin; y < kFieldsEnd && points().size() != count; y += 7) click(x, y);
  };
  clickUntil(right - 40, 3);  // +
  EXPECT_EQ(points(), (std::vector<CurvePoint>{{0, 200}, {1, 150}, {2, 100}}));
  clickUntil(right - 17, 2);  // -
  EXPECT_EQ(points(), (std::vector<CurvePoint>{{1, 150}, {2, 100}}));
  clickUntil(right - 17, 1);
  const std::string one = editor().bytes();
  clickUntil(right - 17, 0);
  EXPECT_EQ(editor().bytes(), one) << "the last point stays";
}

TEST_F(LightsSectionTest, MakesALightASpotWithAFieldForEachOfItsAngles) {
  constexpr int kSpotBegin = kFieldsEnd - 20;
  constexpr int kSpotEnd = kFieldsEnd + 100;
  click(60, kFirstRow);
  for (int y = kSpotBegin; y < kSpotEnd && !light().spot; y += 7) click(kFieldLeft - 12, y);
  ASSERT_TRUE(light().spot);
  const Spot first = *light().spot;
  EXPECT_EQ(first.pitch(), -90) << "it points down";
  const std::string bytes = editor().bytes();
  std::set<std::string> found;
  for (int y = kSpotBegin; y < kSpotEnd; y += 7)
    for (const int column : {0, 1}) {
      drag(kFieldLeft + 20 + 3 * column * kColumn / 2, y);
      if (!light().spot || editor().bytes() == bytes) continue;
      if (light().spot->angle() != first.angle()) found.insert("angle");
      if (light().spot->pitch() != first.pitch()) found.insert("pitch");
      if (light().spot->inner() != first.inner()) found.insert("inner");
      if (light().spot->outer() != first.outer()) found.insert("outer");
      editor().undo();
      EXPECT_EQ(editor().bytes(), bytes) << "a drag is one step";
    }
  EXPECT_EQ(found, (std::set<std::string>{"angle", "pitch", "inner", "outer"}));
}

TEST_F(LightsSectionTest, HidesTheMarksWhichAreNotPickedThen) {
  click(60, kFirstRow);
  LightDescription ahead = editor().pickedLight();
  ahead.source.position = camera_.eye + Vec3{2, 0, 0};
  editor().set(ahead);
  editor().pick({});
  const MarkerSpace view(camera_);
  const PointerEvent press{PointerEvent::Kind::Press, *view.pixelOf(light().position)};
  const auto isMarked = [&] {
    test::Canvas picture(camera_.width, camera_.height);
    const Image before = picture.image();
    tool_.draw(rooms_.scene(), camera_, view, picture);
    return picture.image() != before;
  };
  EXPECT_TRUE(isMarked());
  for (int x = 220; x < 260 && tool_.areMarksShown(); x += 8) click(x, kButtons);
  EXPECT_FALSE(tool_.areMarksShown());
  EXPECT_FALSE(isMarked());
  EXPECT_FALSE(tool_.handle(press, view, camera_.height));
  EXPECT_FALSE(editor().picked());
  tool_.showMarks(true);
  EXPECT_TRUE(tool_.handle(press, view, camera_.height));
  EXPECT_EQ(editor().picked(), 0);
  EXPECT_TRUE(tool_.section().isRevealed()) << "in which it is edited";
}

TEST_F(LightsSectionTest, HasButtonsThatAddDeleteUndoRedoAndSave) {
  click(12, kButtons);  // add
  ASSERT_EQ(editor().lights().lights.size(), 3);
  EXPECT_EQ(editor().picked(), 2);
  const Vec3 eye = camera_.eye;
  EXPECT_EQ(editor().pickedLight().source.position, (Vec3{eye.x + 1.5, eye.y, eye.z}));
  click(60, kButtons);  // delete
  EXPECT_EQ(editor().bytes(), kLights);
  EXPECT_FALSE(editor().picked());
  click(112, kButtons);  // undo
  EXPECT_EQ(editor().lights().lights.size(), 3);
  click(156, kButtons);  // redo
  EXPECT_EQ(editor().bytes(), kLights);
  click(112, kButtons);
  click(200, kButtons);  // save
  EXPECT_FALSE(editor().isUnsaved());
  EXPECT_EQ(fs::file_size(file_), editor().bytes().size());
}

class SunsSectionTest : public LightsSectionTest {
 protected:
  SunsSectionTest() {
    std::ofstream(file_) << R"({"lights":[{"x":2,"y":3,"z":2.5}],"suns":[{"angle":5,"pitch":10}]})";
    editor().openAgain();
  }
  const LightSource& sun() { return editor().lights().suns.at(0).source; }
};

TEST_F(SunsSectionTest, HasAFieldForEachNumber) {
  const std::string bytes = editor().bytes();
  click(60, kFirstRow + kRow);
  ASSERT_EQ(editor().picked(), 1);
  std::set<std::string> found;
  for (int y = kFieldsBegin; y < kFieldsEnd; y += 7)
    for (const int column : {0, 1}) {
      drag(kFieldLeft + 20 + 3 * column * kColumn / 2, y);
      if (editor().bytes() == bytes) continue;
      if (sun().sun->angle() != 5) found.insert("angle");
      if (sun().sun->pitch() != 10) found.insert("pitch");
      if (sun().sun->size() != 0) found.insert("size");
      if (sun().intensity != 255) found.insert("intensity");
      editor().undo();
      EXPECT_EQ(editor().bytes(), bytes) << "a drag is one step";
    }
  EXPECT_EQ(found, (std::set<std::string>{"angle", "pitch", "size", "intensity"}));
}

TEST_F(SunsSectionTest, IsDraggedAcrossTheSky) {
  const MarkerSpace view(camera_);
  const Vec2 mark = *view.pixelTowards(sun().sun->direction());
  const Vec2 there = mark + Vec2{20, -9};
  EXPECT_TRUE(tool_.handle({PointerEvent::Kind::Press, mark}, view, camera_.height));
  EXPECT_EQ(editor().picked(), 1);
  EXPECT_TRUE(tool_.handle({PointerEvent::Kind::Move, there}, view, camera_.height));
  EXPECT_TRUE(tool_.handle({PointerEvent::Kind::Release, there}, view, camera_.height));
  const Vec2 now = *view.pixelTowards(sun().sun->direction());
  EXPECT_NEAR(now.x, there.x, 0.1);
  EXPECT_NEAR(now.y, there.y, 0.1);
  EXPECT_GT(sun().sun->pitch(), 10);
  editor().undo();
  EXPECT_EQ(sun().sun->pitch(), 10);
}

TEST_F(SunsSectionTest, StaysAboveTheHorizon) {
  const MarkerSpace view(camera_);
  const Vec2 mark = *view.pixelTowards(sun().sun->direction());
  tool_.handle({PointerEvent::Kind::Press, mark}, view, camera_.height);
  tool_.handle({PointerEvent::Kind::Move, mark + Vec2{0, 90}}, view, camera_.height);
  EXPECT_EQ(sun().sun->pitch(), 1);
}

TEST_F(SunsSectionTest, IsAddedWhereTheCameraLooks) {
  for (int x = 270; x < 360 && editor().lights().suns.size() == 1; x += 8) click(x, kButtons);
  ASSERT_EQ(editor().lights().suns.size(), 2);
  EXPECT_EQ(editor().picked(), 2);
  EXPECT_EQ(editor().pickedLight().source.sun->angle(), camera_.angle);
  EXPECT_EQ(editor().pickedLight().source.sun->pitch(), 30);
}

TEST_F(SunsSectionTest, AddsTheSkyOnce) {
  for (int x = 270; x < 500 && !editor().lights().sky; x += 8) {
    click(x, kButtons);
    while (editor().lights().suns.size() > 1) editor().undo();
  }
  ASSERT_TRUE(editor().lights().sky);
  EXPECT_EQ(editor().picked(), 2);
  EXPECT_EQ(editor().pickedLight().source.intensity, 100);
  const std::string bytes = editor().bytes();
  for (int y = kFieldsBegin; y < kFieldsEnd && editor().bytes() == bytes; y += 7)
    drag(kFieldLeft + 20, y);
  EXPECT_NE(editor().pickedLight().source.intensity, 100);
}

TEST_F(LightsSectionTest, OffersToReadAFileThatWasChanged) {
  click(12, kButtons);
  std::ofstream(file_) << "[]";
  click(200, kButtons);
  EXPECT_TRUE(editor().hasConflict());
  EXPECT_EQ(fs::file_size(file_), 2);
  for (int y = kFieldsBegin; y < 400 && editor().hasConflict(); y += 7) click(60, y);
  EXPECT_FALSE(editor().hasConflict());
  EXPECT_EQ(editor().bytes(), "[]");
}

}  // namespace
}  // namespace hearth
