// A model that is turned, in lockstep with a clock and events that the test gives it.

#include "viewer/orbit/orbit.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "desktop/disk.h"
#include "desktop/screenshot_files.h"
#include "light/bakery.h"
#include "model/model_air.h"
#include "model/open_level.h"
#include "stage.h"
#include "support/memory_files.h"
#include "support/models.h"
#include "viewer/orbit/orbit_controls.h"
#include "viewer/overlay/model_section.h"
#include "viewer/walk/walk_loop.h"

namespace hearth {
namespace {

using test::down;
using test::motion;
using test::pressAt;
using test::releaseAt;
using test::up;

constexpr Box3 kBox{{-1, -1, 0}, {1, 1, 2}};
const OrbitView kView{{0, 0, 1}, 4, 270, -20};

// --- The camera ----------------------------------------------------------------------------------

TEST(Orbit, turnsTheModelToTheRightByGoingToTheLeft) {
  Orbit orbit(kBox, kView);
  orbit.tick({.turn = 10});
  EXPECT_EQ(orbit.at(1).angle, 280);
  // Seen along -y, +x is to the right.
  EXPECT_LT(orbit.eyeAt(1).x, orbit.eyeAt(0).x);
  EXPECT_NEAR(length(orbit.eyeAt(1).xy()), 4, 1e-12);
}

TEST(Orbit, tiltsTheModelTowardsTheEyeByGoingUp) {
  Orbit orbit(kBox, kView);
  orbit.tick({.tilt = 15});
  EXPECT_EQ(orbit.at(1).pitch, -35);
  EXPECT_GT(orbit.eyeAt(1).z, orbit.eyeAt(0).z);
  for (int i = 0; i < 20; ++i) orbit.tick({.tilt = 15});
  EXPECT_EQ(orbit.at(1).pitch, -60) << "no farther than pictures can";
}

TEST(Orbit, staysBetweenTheNearestAndTheFarthestPlace) {
  Orbit orbit(kBox, kView);
  for (int i = 0; i < 200; ++i) orbit.tick({.zoom = 1.5});
  EXPECT_DOUBLE_EQ(orbit.at(1).distance, kFarthestRadii * radiusOf(kBox));
  for (int i = 0; i < 200; ++i) orbit.tick({.zoom = 0.5});
  EXPECT_DOUBLE_EQ(orbit.at(1).distance, 0.02 * radiusOf(kBox));
}

TEST(Orbit, leavesACameraThatWasPlacedFarAwayWhereItIs) {
  OrbitView far = kView;
  far.distance = 30 * radiusOf(kBox);
  Orbit orbit(kBox, far);
  orbit.tick({});
  EXPECT_EQ(orbit.at(1), far);
  orbit.tick({.zoom = 1.5});
  EXPECT_EQ(orbit.at(1), far) << "and does not jump nearer when it is to go farther";
  orbit.tick({.zoom = 0.5});
  EXPECT_EQ(orbit.at(1).distance, 15 * radiusOf(kBox));
}

TEST(Orbit, turnsTheShorterWayBetweenTwoTicks) {
  OrbitView view = kView;
  view.angle = 350;
  Orbit orbit(kBox, view);
  orbit.tick({.turn = 20});
  EXPECT_NEAR(orbit.at(0.25).angle, 355, 1e-9);
  EXPECT_NEAR(orbit.at(0.75).angle, 5, 1e-9);
  EXPECT_NEAR(orbit.at(1).angle, 10, 1e-9);
}

TEST(Orbit, keepsItsEyeInTheAir) {
  OrbitView view = kView;
  view.target = {60, 0, 1};  // of a camera that was placed, and looked away
  Orbit orbit(kBox, view);
  for (int i = 0; i < 36; ++i) {
    orbit.tick({.turn = 10, .zoom = 1.3});
    Box3 all = airRound(kBox);
    all.add(orbit.eyeAt(0.5));
    EXPECT_EQ(all, airRound(kBox));
  }
}

TEST(Orbit, keepsItsViewOfAModelThatChanges) {
  Orbit orbit(kBox, kView);
  EXPECT_TRUE(orbit.continueIn({{-3, -1, 0}, {1, 2, 5}}));
  EXPECT_EQ(orbit.at(1), kView);
  EXPECT_FALSE(orbit.continueIn({{-0.001, -0.001, 0}, {0.001, 0.001, 0.002}}))
      << "the eye is outside of the air of one that is so much smaller";
}

// --- Mouse and keys ------------------------------------------------------------------------------

OrbitInput afterEvents(const std::vector<Event>& events, int ticksDue = 1) {
  OrbitControls controls;
  for (const Event& event : events) controls.handle(event, KeyMap());
  return controls.nextTick(ticksDue);
}

TEST(OrbitControls, ADragTurnsAndTilts) {
  EXPECT_EQ(afterEvents({motion(8, 16)}), OrbitInput{}) << "without a button";
  EXPECT_EQ(afterEvents({pressAt(5, 5), motion(8, 16)}), (OrbitInput{3, 6, 1}));
  EXPECT_EQ(afterEvents({pressAt(5, 5), releaseAt(5, 5), motion(8, 16)}), OrbitInput{});
  EXPECT_EQ(afterEvents({pressAt(5, 5, MouseButton::Right), motion(8, 16)}), OrbitInput{});
}

TEST(OrbitControls, ADragIsSpreadOverTheTicksThatAreDue) {
  OrbitControls controls;
  controls.handle(pressAt(0, 0), KeyMap());
  controls.handle(motion(8, 0), KeyMap());
  double turn = 0;
  for (int due = 4; due > 0; --due) turn += controls.nextTick(due).turn;
  EXPECT_DOUBLE_EQ(turn, 3);
}

TEST(OrbitControls, KeysDoWhatADragInTheirDirectionDoes) {
  for (const Key key : {Key::Right, Key::D}) EXPECT_GT(afterEvents({down(key)}).turn, 0);
  for (const Key key : {Key::Left, Key::A}) EXPECT_LT(afterEvents({down(key)}).turn, 0);
  for (const Key key : {Key::Down, Key::Q}) EXPECT_GT(afterEvents({down(key)}).tilt, 0);
  for (const Key key : {Key::Up, Key::E}) EXPECT_LT(afterEvents({down(key)}).tilt, 0);
  EXPECT_EQ(afterEvents({down(Key::Left), down(Key::D)}), OrbitInput{});
  EXPECT_EQ(afterEvents({down(Key::Left), down(Key::A)}), afterEvents({down(Key::A)}));
}

TEST(OrbitControls, TheWheelAndKeysGoNearerAndFarther) {
  for (const Key key : {Key::W, Key::Equals, Key::KeypadPlus})
    EXPECT_LT(afterEvents({down(key)}).zoom, 1);
  for (const Key key : {Key::S, Key::Minus, Key::KeypadMinus})
    EXPECT_GT(afterEvents({down(key)}).zoom, 1);
  EXPECT_LT(afterEvents({WheelTurn{0, 1}}).zoom, 1);
  EXPECT_GT(afterEvents({WheelTurn{0, -1}}).zoom, 1);
  EXPECT_EQ(afterEvents({WheelTurn{0, 2}, WheelTurn{0, -2}}), OrbitInput{});
}

TEST(OrbitControls, AKeyThatIsPressedAndReleasedBetweenTwoTicksCounts) {
  OrbitControls controls;
  controls.handle(down(Key::D), KeyMap());
  controls.handle(up(Key::D), KeyMap());
  EXPECT_GT(controls.nextTick(1).turn, 0);
  EXPECT_EQ(controls.nextTick(1), OrbitInput{});
}

TEST(OrbitControls, LeaveKeysToThePictureThatTheUserHasGivenIt) {
  KeyMap keys;
  keys.bind(Action::Overlay, {Key::E});
  OrbitControls controls;
  controls.handle(down(Key::E), keys);
  EXPECT_EQ(controls.nextTick(1), OrbitInput{});
}

// --- In a window ---------------------------------------------------------------------------------

/// A model on a stage.
class TurnedBox {
 public:
  explicit TurnedBox(OrbitView view = {{0, 0, 0.5}, 3, 270, -20}) {
    test::MemoryFiles files;
    files.add("box.obj", std::string(test::kBoxModel));
    opened_ = openLevel("box.obj", {}, {}, files);
    light_ = bake(scene(), loaded().level.bake, 1);
    renderer_.emplace(scene(), loaded().textures, light_);
    session_.emplace(MovingLevel(scene()), Walker{.sector = sector(), .feet = {}, .velocity = {}},
                     WalkSession::Record::No);
    WalkSettings settings;
    settings.fov = kModelFov;
    settings.model = {*opened_.model, view};
    stage.window = ImageSize{160, 100};
    loop_.emplace(scene(), *renderer_, *session_, WalkHost{stage, disk_, screenshots_}, settings);
    isOn = loop_->round();
  }

  void ticks(int count) {
    for (int i = 0; i < count && isOn; ++i) {
      stage.now += 1.0 / kTicksPerSecond;
      isOn = loop_->round();
    }
  }
  void now(const Event& event) {
    stage.events.push_back(event);
    isOn = loop_->round();
  }
  /// What it shows once nothing moves.
  const Image& shown() {
    ticks(2);
    return stage.shown;
  }
  Image drawn(const OrbitView& view) const {
    return renderer_->draw({sector(), view.eye(), view.angle, view.pitch, kModelFov,
                            stage.window->width, stage.window->height, 0},
                           LightMode::Both);
  }
  OrbitView front() const { return frontView(loaded().level.meshFaces, kModelFov, *stage.window); }
  WalkLoop& loop() { return *loop_; }
  const Walker& walker() const { return session_->walker(); }

  test::Stage stage;
  bool isOn = true;

 private:
  const LoadedLevel& loaded() const { return *opened_.result.loaded; }
  Scene scene() const { return loaded().scene(); }
  SectorId sector() const { return loaded().level.meshes.front().sector; }

  OpenedLevel opened_;
  BakedLight light_;
  std::optional<Renderer> renderer_;
  std::optional<WalkSession> session_;
  Disk disk_;
  ScreenshotFiles screenshots_{testing::TempDir(), "box"};
  std::optional<WalkLoop> loop_;
};

TEST(TurnedModel, ShowsWhatShotDraws) {
  const OrbitView view{{0, 0, 0.5}, 3, 250, -10};
  TurnedBox box(view);
  EXPECT_EQ(box.stage.title, "box.obj");
  EXPECT_EQ(box.stage.shown, box.drawn(view));
}

TEST(TurnedModel, TurnsWithADragAndLeavesTheMouseFree) {
  TurnedBox box;
  box.now(pressAt(80, 50));
  box.now(motion(80, -40));
  box.now(releaseAt(160, 10));
  box.now(motion(500, 500));
  EXPECT_EQ(box.shown(), box.drawn({{0, 0, 0.5}, 3, 300, -5}));
  EXPECT_FALSE(box.stage.isMouseCaptured);
}

TEST(TurnedModel, ComesNearerWithTheWheel) {
  TurnedBox box;
  box.now(WheelTurn{0, 2});
  EXPECT_EQ(box.shown(), box.drawn({{0, 0, 0.5}, 3 * (1 / (1.15 * 1.15)), 270, -20}));
}

TEST(TurnedModel, TurnsByTicksWhileAKeyIsHeld) {
  TurnedBox box;
  box.now(down(Key::Right));
  box.ticks(20);
  box.now(up(Key::Right));
  EXPECT_EQ(box.shown(), box.drawn({{0, 0, 0.5}, 3, 300, -20}));
}

TEST(TurnedModel, ShowsAllOfItselfAgainWithHome) {
  TurnedBox box;
  box.now(down(Key::Home));
  EXPECT_EQ(box.shown(), box.drawn(box.front()));
  box.stage.window = ImageSize{60, 120};
  box.now(up(Key::Home));
  box.now(down(Key::Home));
  EXPECT_EQ(box.shown(), box.drawn(box.front())) << "in a window of this size";
}

TEST(TurnedModel, DrawsNothingWhileNothingMoves) {
  TurnedBox box;
  box.ticks(4);
  const int frames = box.stage.frames;
  box.ticks(100);
  EXPECT_EQ(box.stage.frames, frames);
}

TEST(TurnedModel, KnowsNoKeysOfWalks) {
  TurnedBox box;
  const Image before = box.shown();
  const Walker walker = box.walker();
  for (const Key key : {Key::Tab, Key::B, Key::G, Key::N, Key::Space, Key::C, Key::LeftShift}) {
    box.now(down(key));
    box.now(up(key));
  }
  EXPECT_EQ(box.shown(), before);
  EXPECT_EQ(box.walker(), walker);
}

TEST(TurnedModel, LetsGoOfAllWhenAnotherWindowHasTheKeyboard) {
  TurnedBox box;
  box.now(pressAt(80, 50));
  box.now(down(Key::Right));
  box.now(WindowEvent::FocusLost);
  box.now(motion(80, 0));
  EXPECT_EQ(box.shown(), box.drawn({{0, 0, 0.5}, 3, 270, -20}));
}

TEST(TurnedModel, IsLeftWithEsc) {
  TurnedBox box;
  box.now(pressAt(80, 50));
  box.now(down(Key::Escape));
  EXPECT_FALSE(box.isOn);
}

TEST(TurnedModel, ListsItsOwnKeys) {
  const std::string keys = keyHelp(modelKeyList({}));
  for (const char* words : {"turn the model", "nearer, farther", "Home", "F1", "F12", "Wheel"})
    EXPECT_NE(keys.find(words), std::string::npos) << words;
  EXPECT_EQ(keys.find("walk"), std::string::npos);
  EXPECT_EQ(keys.find("bookmark"), std::string::npos);
}

TEST(TurnedModel, IsNotTurnedByDragsInTheOverlay) {
  TurnedBox box;
  box.stage.window = ImageSize{900, 500};
  const Image before = box.shown();
  box.now(down(Key::F1));
  EXPECT_NE(box.shown(), before);
  box.now(pressAt(800, 200));
  box.now(motion(80, 0));
  box.now(releaseAt(880, 200));
  box.now(down(Key::F1));
  EXPECT_EQ(box.shown(), before);
}

TEST(TurnedModel, HasItsFiguresInTheOverlay) {
  TurnedBox box;
  box.stage.window = ImageSize{900, 500};
  box.now(down(Key::F1));
  box.ticks(8);
  const Image before = box.stage.shown;
  box.ticks(64);
  EXPECT_EQ(box.stage.shown, before);
  ModelFigures more{.vertices = 12345, .faces = 99, .box = {{-0.5, -0.5, 0}, {0.5, 0.5, 1}}};
  box.loop().continueWith(more);
  box.ticks(64);
  EXPECT_NE(box.stage.shown, before) << "those of another version show";
}

TEST(ModelRows, TellCountsAndTheBoxInMetres) {
  std::string text;
  for (const auto& [name, words] : modelRows({.vertices = 8,
                                   .faces = 6,
                                   .triangles = 12,
                                   .materials = 2,
                                   .images = 1,
                                   .box = {{-0.0005, 0, -2}, {0.0005, 1500, 1}}}))
    text += std::string(name) + ": " + words + "\n";
  EXPECT_EQ(text,
            "vertices: 8\nfaces: 6, as 12 triangles\nmaterials: 2\nimages: 1\n"
            "size: 0.001 x 1500 x 3 m\nx: -0.0005 .. 0.0005 m\ny: 0 .. 1500 m\n"
            "z, up: -2 .. 1 m\n");
}

}  // namespace
}  // namespace hearth
