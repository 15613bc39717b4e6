// The overlay in a walk, without a window.

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <string_view>

#include "settings/channels.h"
#include "staged_walk.h"
#include "support/canvas.h"

namespace hearth {
namespace {

using test::click;
using test::down;
using test::motion;
using test::pressAt;
using test::releaseAt;

class OverlayWalk : public test::StagedWalk {
 public:
  OverlayWalk() {
    stage.window = ImageSize{800, 400};
    now();
    plain = stage.shown;
  }

  void press(Key code) { now(down(code)); }

  Image plain;  ///< the picture without it
};

TEST(WalkOverlay, OpensAndClosesWithF1) {
  OverlayWalk walk;
  walk.press(Key::F1);
  EXPECT_NE(walk.stage.shown, walk.plain);
  walk.press(Key::F1);
  EXPECT_EQ(walk.stage.shown, walk.plain);
}

TEST(WalkOverlay, IsClosedByEscWhichDoesNotLeave) {
  OverlayWalk walk;
  walk.press(Key::F1);
  walk.press(Key::Escape);
  EXPECT_TRUE(walk.isOn);
  EXPECT_EQ(walk.stage.shown, walk.plain);
}

TEST(WalkOverlay, HasTheMouseWhileItIsOpen) {
  OverlayWalk walk;
  walk.now(click());
  walk.press(Key::F1);
  EXPECT_FALSE(walk.stage.isMouseCaptured);
  walk.now(motion(100, 0));
  walk.now(click());
  EXPECT_FALSE(walk.stage.isMouseCaptured);
  walk.ticks(2);
  EXPECT_EQ(walk.walker().angle, walk.start().angle);
  walk.press(Key::F1);
  EXPECT_TRUE(walk.stage.isMouseCaptured) << "as before";
}

TEST(WalkOverlay, TakesNoMouseForTheWalkThatItHadNot) {
  OverlayWalk walk;
  walk.press(Key::F1);
  walk.press(Key::F1);
  EXPECT_FALSE(walk.stage.isMouseCaptured);
  walk.now(click());
  walk.press(Key::F1);
  walk.now(WindowEvent::FocusLost);
  walk.press(Key::F1);
  EXPECT_FALSE(walk.stage.isMouseCaptured);
}

TEST(WalkOverlay, ShowsChannelsWithTheOptionsThatDrawThemAgain) {
  WalkSettings settings;
  settings.view.channel = "spaces";
  test::StagedWalk walk(settings);
  const Eye eye = eyeOf(walk.scene(), walk.start());
  const Camera camera{eye.sector, eye.point, eye.angle, eye.pitch, settings.fov, 64, 40};
  EXPECT_EQ(walk.stage.shown, drawGeometry(walk.scene(), camera, "spaces"));
  walk.now(down(Key::F12));
  walk.loop().awaitScreenshots();
  ASSERT_EQ(walk.stage.printed.size(), 1);
  EXPECT_NE(walk.stage.printed[0].find(" --channel spaces"), std::string::npos);
  walk.now(down(Key::Digit2));
  EXPECT_EQ(walk.stage.shown, walk.drawn(LightMode::None, {64, 40}));
}

/// Whether the left of the picture is `part`, all of it.
bool beginsWith(const Image& picture, const Image& part) {
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x)
      if (!(picture.at(x, y) == part.at(x, y))) return false;
  return true;
}

TEST(WalkOverlay, LeavesChannelsOfGeometryBesideIt) {
  for (const ImageSize size : {ImageSize{1280, 720}, {3840, 2160}}) {
    WalkSettings settings;
    settings.view.channel = "spaces";
    test::StagedWalk walk(settings);
    walk.stage.window = size;
    walk.now(down(Key::F1));
    for (int i = 0; i < 4; ++i) walk.now();
    Overlay panel;  // of the same size
    panel.toggle();
    test::Canvas picture(size.width, size.height);
    panel.draw(
        1, [] {}, picture);
    const Eye eye = eyeOf(walk.scene(), walk.start());
    const Camera camera{eye.sector, eye.point,    eye.angle,
                        eye.pitch,  settings.fov, panel.widthBeside(size.width),
                        size.height};
    EXPECT_EQ(walk.stage.shown.width(), size.width);
    EXPECT_TRUE(beginsWith(walk.stage.shown, *drawGeometry(walk.scene(), camera, "spaces")));
    walk.now(down(Key::F1));
    EXPECT_TRUE(
        beginsWith(walk.stage.shown, *drawGeometry(walk.scene(),
                                                   {eye.sector, eye.point, eye.angle, eye.pitch,
                                                    settings.fov, size.width, size.height},
                                                   "spaces")));
  }
}

TEST(WalkOverlay, CoversChannelsOfGeometryWhereThereIsNoRoomBeside) {
  WalkSettings settings;
  settings.view.channel = "world";
  test::StagedWalk walk(settings);
  walk.now(down(Key::F1));
  for (int i = 0; i < 4; ++i) walk.now();
  EXPECT_EQ(walk.stage.shown.width(), 64);
}

TEST(Channels, HaveTheFourSpacesInTheirQuarters) {
  const Level& level = test::rooms().loaded.level;
  const Scene scene = test::rooms().loaded.scene();
  const Camera camera{level.player->sector, level.player->eye, level.player->angle, 0, 90, 61, 41};
  const Image all = *drawGeometry(scene, camera, "spaces");
  const auto expectAt = [&](std::string_view name, int left, int top, int width, int height) {
    Camera quarter = camera;
    quarter.width = width;
    quarter.height = height;
    const Image one = *drawGeometry(scene, quarter, name);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        ASSERT_EQ(all.at(left + x, top + y), one.at(x, y)) << name << ' ' << x << ',' << y;
  };
  expectAt("world", 0, 0, 30, 20);
  expectAt("camera", 30, 0, 31, 20);
  expectAt("depthspace", 0, 20, 30, 21);
  expectAt("screen", 30, 20, 31, 21);
  Camera tiny = camera;
  tiny.width = tiny.height = 1;
  EXPECT_EQ(drawGeometry(scene, tiny, "spaces")->width(), 1);
  EXPECT_FALSE(drawGeometry(scene, camera, "depth"));
}

TEST(WalkOverlay, PinsAPlaceByAClickAndLetsGoOfItByEsc) {
  OverlayWalk walk;
  walk.press(Key::F1);
  walk.ticks(4);
  const auto left = [&] {  // of the picture, without the panel
    Image part(300, 400);
    for (int y = 0; y < 400; ++y)
      for (int x = 0; x < 300; ++x) part.at(x, y) = walk.stage.shown.at(x, y);
    return part;
  };
  const Image before = left();
  walk.now(pressAt(100, 300));
  walk.ticks(4);
  EXPECT_NE(left(), before) << "rays, and a ring round the place";
  walk.press(Key::Escape);
  walk.now(WindowEvent::MouseLeft);
  walk.ticks(4);
  EXPECT_EQ(left(), before);
  walk.press(Key::Escape);
  EXPECT_EQ(walk.stage.shown, walk.plain) << "and then closes the overlay";
  EXPECT_TRUE(walk.isOn);
}

TEST(WalkOverlay, ShowsWhyAPlaceIsLitWhateverPageWasOpen) {
  OverlayWalk walk;
  OverlayWalk turned;
  for (OverlayWalk* each : {&walk, &turned}) {
    each->press(Key::F1);
    each->ticks(4);
  }
  const Image first = turned.stage.shown;
  turned.now(pressAt(400, 17));
  turned.now(releaseAt(400, 17));
  turned.ticks(4);
  EXPECT_NE(turned.stage.shown, first) << "another page";
  for (OverlayWalk* each : {&walk, &turned}) {
    each->now(pressAt(100, 300));
    each->now(releaseAt(100, 300));
    each->ticks(8);
  }
  EXPECT_EQ(turned.stage.shown, walk.stage.shown);
}

TEST(WalkOverlay, CopiesToTheClipboardWhatIsClickedOn) {
  OverlayWalk walk;
  walk.press(Key::F1);
  walk.ticks(4);
  walk.now(pressAt(100, 300));
  walk.ticks(4);
  for (int y = 30; y < 400 && walk.stage.clipboard.empty(); y += 8) {
    walk.now(pressAt(460, y));
    walk.now(releaseAt(460, y));
  }
  EXPECT_TRUE(std::regex_match(walk.stage.clipboard, std::regex("[-0-9.]+,[-0-9.]+,[-0-9.]+")))
      << "the point, as the level has no source here: " << walk.stage.clipboard;
}

TEST(WalkOverlay, LetsKeysWalkOn) {
  OverlayWalk walk;
  walk.press(Key::F1);
  walk.press(Key::W);
  walk.ticks(4);
  EXPECT_NE(walk.walker().feet, walk.start().feet);
}

TEST(WalkOverlay, IsDrawnFourTimesASecondWhileNothingHappens) {
  OverlayWalk walk;
  walk.press(Key::F1);
  walk.ticks(64);
  const int frames = walk.stage.frames;
  walk.ticks(256);
  EXPECT_EQ(walk.stage.frames - frames, 16);
}

TEST(WalkOverlay, LeavesNotesBesideIt) {
  OverlayWalk walk;
  walk.press(Key::F1);
  walk.ticks(4);
  const Image open = walk.stage.shown;
  walk.loop().setNotes({std::string(200, 'x')}, StageProgress{Stage::Baking, 1, 4, 2.0});
  walk.ticks(1);
  const auto differsAt = [&](int x) {
    for (int y = 0; y < 30; ++y)
      if (walk.stage.shown.at(x, y) != open.at(x, y)) return true;
    return false;
  };
  EXPECT_TRUE(differsAt(5));
  EXPECT_FALSE(differsAt(799)) << "the panel's own edge";
}

}  // namespace
}  // namespace hearth
