// The inspector in the panel: what the pointer is at, and what a click pins.

#include "viewer/overlay/inspector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "desktop/disk.h"
#include "support/canvas.h"
#include "support/in_tree.h"
#include "support/level_text.h"
#include "viewer/inspect/places.h"
#include "viewer/inspect/words.h"
#include "viewer/overlay/overlay.h"
#include "walk/stage.h"

namespace hearth {
namespace {

// Pixels of the panel: below the section's header, and where lights have their names, a place its
// values, and the row of buttons `add a light here`; and where this has `let it shine`.
constexpr int kFirstRow = 35;
constexpr int kColumn = 95;
constexpr int kColumnOfShine = 170;

/// The panel with this section alone, over a picture of the rooms.
class InspectorTest : public testing::Test {
 protected:
  InspectorTest() : InspectorTest(loadLevelWithSource(test::inTree("tests/levels/rooms.json"))) {}

  explicit InspectorTest(SourcedResult sourced)
      : sourced_(std::move(sourced)),
        place_(*sourced_.result.loaded),
        light_(bake(place_.scene(), place_.level.bake, 1)),
        renderer_(place_.scene(), place_.textures, light_),
        camera_{place_.level.player->sector,
                place_.level.player->eye,
                place_.level.player->angle,
                0,
                90,
                1280,
                720} {
    tool_.editor().open();
    overlay_.toggle();
    frame();
  }

  void frame() {
    renderer_.draw(camera_, LightMode::Both, scratch_, picture_);
    overlay_.draw(
        now_ += 0.02,
        [this] {
          const auto copied =
              inspector_.show({place_.scene(), renderer_, place_.level.bake, &sourced_.source,
                               areLightsEdited_ ? &tool_ : nullptr, isInPicture_},
                              camera_);
          if (copied) copied_.insert(*copied);
        },
        picture_);
  }

  void send(const Event& event) {
    inspector_.handle(event, overlay_.widthBeside(camera_.width));
    overlay_.handle(event);
    frame();
  }
  void moveTo(int x, int y) { send(test::moveTo(x, y)); }
  void clickAt(int x, int y, MouseButton button = MouseButton::Left) {
    send(test::pressAt(x, y, button));
    send(test::releaseAt(x, y, button));
  }
  /// Clicks into the panel here and there, from the top down, until something has come of it.
  template <typename IsDone>
  void clickThroughPanel(IsDone&& isDone, MouseButton button = MouseButton::Left,
                         int column = kColumn) {
    for (int y = kFirstRow; y < 500; y += 5) {
      if (isDone()) return;
      clickAt(overlay_.widthBeside(camera_.width) + column, y, button);
    }
  }

  /// What the renderer has at a pixel of its picture.
  void expectFoundAt(int x, int y) {
    ASSERT_TRUE(inspector_.found());
    const Vec3 point = inspector_.found()->place.point;
    const Projection projection = projectionFor(place_.scene(), camera_);
    const CameraPoint seen = projection.toCamera(point.xy());
    EXPECT_NEAR(projection.columnOf(seen), x + 0.5, 1e-6);
    EXPECT_NEAR(projection.rowOf(point.z, seen.depth), y + 0.5, 1e-6);
  }

  SourcedResult sourced_;
  LoadedLevel place_;
  BakedLight light_;
  Renderer renderer_;
  Camera camera_;
  Overlay overlay_;
  Inspector inspector_;
  Disk disk_;
  LightsTool tool_{disk_, test::inTree("tests/levels/rooms.lights.json"), {}};
  bool isInPicture_ = true;
  bool areLightsEdited_ = true;
  FrameScratch scratch_;
  test::Canvas picture_{camera_.width, camera_.height};
  double now_ = 1;
  std::set<std::string> copied_;
};

/// The player looks at a thing that is larger than the picture.
class InspectorOfAThing : public InspectorTest {
 protected:
  explicit InspectorOfAThing(const std::string& thing)
      : InspectorTest(test::levelWithSourceFrom(
            "{'light':1,'player':{'x':1,'y':2,'z':1.5},'things':[" + thing + "],'sectors':{" +
                test::sectorText("room", "0,0, 4,0, 4,4, 0,4", 0, 4) + "}}",
            "[]", {{"sheet.obj", "v 0 0 9\nv 0 0 -9\nv 0 9 -9\nv 0 9 9\nf 1 4 3 2\n"}})) {}

  bool hasCopied(std::string_view ending) const {
    return std::ranges::any_of(copied_,
                               [&](const std::string& text) { return text.ends_with(ending); });
  }
};

class InspectorOfASprite : public InspectorOfAThing {
 protected:
  InspectorOfASprite()
      : InspectorOfAThing(
            "{'name':'curtain','sprite':'#c04020','x':2,'y':2,'size':[9,9],'offset':[0,-4]}") {}
};

class InspectorOfAMesh : public InspectorOfAThing {
 protected:
  InspectorOfAMesh() : InspectorOfAThing("{'name':'sheet','mesh':'sheet.obj','x':2,'y':2}") {}
};

TEST_F(InspectorOfASprite, TellsItInPlaceOfTheWallBehindAndCopiesItsPlaces) {
  clickAt(300, 400);
  EXPECT_FALSE(inspector_.found()) << "no surface";
  clickThroughPanel([&] { return hasCopied("/things/0") && hasCopied("/things/0/sprite"); });
  EXPECT_TRUE(hasCopied(" /things/0"));
  EXPECT_TRUE(hasCopied(" /things/0/sprite"));
}

TEST_F(InspectorOfAMesh, TellsItInPlaceOfTheWallBehindAndCopiesItsPlaces) {
  clickAt(300, 400);
  EXPECT_FALSE(inspector_.found()) << "no surface";
  clickThroughPanel([&] { return hasCopied("/things/0") && hasCopied("/things/0/mesh"); });
  EXPECT_TRUE(hasCopied(" /things/0"));
  EXPECT_TRUE(hasCopied(" /things/0/mesh"));
}

TEST_F(InspectorTest, FollowsThePointerUnlessItIsClosed) {
  moveTo(300, 400);
  expectFoundAt(300, 400);
  clickAt(camera_.width - 100, 17);
  moveTo(300, 400);
  EXPECT_FALSE(inspector_.found());
}

TEST_F(InspectorTest, IsOpenedByAClickIntoThePictureWhichPins) {
  clickAt(300, 400);
  expectFoundAt(300, 400);
  moveTo(400, 300);
  expectFoundAt(300, 400);
  clickAt(400, 300);
  expectFoundAt(400, 300);
}

TEST_F(InspectorTest, DrawsRaysOnlyOverWhatTheCameraSees) {
  const Image level = renderer_.draw(camera_, LightMode::Both);
  const auto isDrawnOver = [&] {
    frame();
    for (int y = 0; y < camera_.height; ++y)
      for (int x = 0; x < overlay_.widthBeside(camera_.width); ++x)
        if (picture_.at(x, y) != level.at(x, y)) return true;
    return false;
  };
  clickAt(300, 400);
  EXPECT_TRUE(isDrawnOver());
  isInPicture_ = false;
  EXPECT_FALSE(isDrawnOver());
  EXPECT_TRUE(inspector_.found()) << "the panel tells it still";
}

TEST_F(InspectorTest, FollowsThePointerWhereNothingIsPinned) {
  clickAt(300, 400);
  EXPECT_TRUE(inspector_.letGo());
  EXPECT_FALSE(inspector_.letGo());
  moveTo(310, 100);
  expectFoundAt(310, 100);
  moveTo(100, 600);
  expectFoundAt(100, 600);
  moveTo(1270, 600);
  EXPECT_FALSE(inspector_.found()) << "over the panel";
}

TEST_F(InspectorTest, KeepsThePlaceWhileTheWalkerGoesOn) {
  clickAt(300, 400);
  const Vec3 point = inspector_.found()->place.point;
  camera_.angle += 30;
  frame();
  EXPECT_EQ(inspector_.found()->place.point, point);
}

TEST_F(InspectorTest, LooksAnewOnceTheLevelIsAnother) {
  clickAt(300, 400);
  const Inspection before = *inspector_.found();
  ASSERT_FALSE(before.lights.empty());
  place_.level.lights.clear();
  inspector_.forget();
  frame();
  EXPECT_EQ(inspector_.found()->place.point, before.place.point);
  EXPECT_TRUE(inspector_.found()->lights.empty());
}

TEST_F(InspectorTest, CopiesByAClickWhereTheFilesHaveIt) {
  clickAt(300, 400);
  const Inspection found = *inspector_.found();
  const auto goesOn = [] { return false; };
  clickThroughPanel(goesOn);
  const LevelSource& source = sourced_.source;
  EXPECT_TRUE(copied_.contains(placeOfSurface(source, place_.level, found.place)));
  EXPECT_TRUE(copied_.contains(placeOfTexture(source, place_.level, found.place)));
  EXPECT_TRUE(copied_.contains(placeOfSector(source, found.place.sector)));
  EXPECT_TRUE(copied_.contains(pointWords(found.place.point)));
  copied_.clear();
  clickThroughPanel(goesOn, MouseButton::Right);
  std::set<std::string> lights;
  for (const LightFinding& finding : found.lights)
    if (finding.comesNear) lights.insert(placeOfLight(source, finding.light));
  EXPECT_FALSE(lights.empty());
  EXPECT_EQ(copied_, lights) << "a right click copies those of lights";
}

TEST_F(InspectorTest, PicksTheLightThatIsClickedOn) {
  clickAt(300, 400);
  const std::size_t first = inspector_.found()->lights.at(0).light;
  clickThroughPanel([&] {
    if (tool_.editor().canUndo()) tool_.editor().undo();  // one that was added on the way
    return tool_.editor().picked() == first;
  });
  EXPECT_EQ(tool_.editor().picked(), first);
  EXPECT_TRUE(tool_.section().isRevealed());
  EXPECT_TRUE(copied_.empty());
}

TEST_F(InspectorTest, AddsALightAMetreBeforeThePlaceThatIsPinned) {
  const std::size_t before = tool_.editor().lights().lights.size();
  clickAt(300, 400);
  const TruthHit place = inspector_.found()->place;
  const auto isAdded = [&] { return tool_.editor().canUndo(); };
  clickThroughPanel(isAdded);
  ASSERT_EQ(tool_.editor().lights().lights.size(), before + 1);
  const LightDescription added = tool_.editor().lights().lights.back();
  EXPECT_LT(length(added.source.position - (place.point + place.normal)), 0.001);
  EXPECT_EQ(tool_.editor().picked(), before);
  EXPECT_EQ(tool_.editor().commentOf(before), "in " + place_.level[place.sector].name);
}

TEST_F(InspectorTest, AsksForTheTextureToShineOfThePlaceThatIsPinned) {
  clickAt(300, 400);
  const auto isAsked = [&] { return !tool_.editor().message().empty(); };
  clickThroughPanel(isAsked, MouseButton::Left, kColumnOfShine);
  EXPECT_EQ(tool_.editor().message(),
            "the file is an array of lights: write { \"lights\": [...] } to give it emitters");
}

TEST_F(InspectorTest, AddsNoLightWhereTheyCannotBeEdited) {
  areLightsEdited_ = false;
  clickAt(300, 400);
  clickThroughPanel([] { return false; });
  EXPECT_TRUE(inspector_.found());
  EXPECT_EQ(tool_.editor().canUndo(), false);
  EXPECT_FALSE(tool_.editor().picked());
}

TEST_F(InspectorTest, LosesAPlaceThatIsNoMore) {
  clickAt(300, 400);
  place_.level.sectors[camera_.sector.index()].name = "elsewhere";
  inspector_.forget();
  frame();
  EXPECT_FALSE(inspector_.found());
}

}  // namespace
}  // namespace hearth
