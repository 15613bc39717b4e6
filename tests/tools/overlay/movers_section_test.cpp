// The section that lists movers: what is dragged, chosen and typed in it.

#include "viewer/overlay/movers_section.h"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "support/canvas.h"
#include "support/hall_and_cellar.h"
#include "viewer/overlay/overlay.h"
#include "walk/stage.h"

namespace hearth {
namespace {

enum Movers { Gate, Lift };

// Pixels of the panel, as it is laid out.
constexpr int kShareLeft = 149;
constexpr int kShareRight = 226;
constexpr int kTrigger = 330;
constexpr int kSpeed = 410;
constexpr int kHeader = 18;
constexpr int kFirstRow = 38;
constexpr int kRowHeight = 23;

class MoversSectionTest : public testing::Test {
 protected:
  MoversSectionTest() {
    overlay_.toggle();
    for (int i = 0; i < 4; ++i) frame();
    left_ = overlay_.widthBeside(picture_.width());
  }

  void frame() {
    const Scene scene(level_.level, level_.geometry);
    const auto show = [&] {
      if (const auto edit = section_.show({scene, shares_, permissions_})) edits_.push_back(*edit);
    };
    static_cast<const PixelRows&>(picture_).fill({});  // the panel lets through what is behind it
    overlay_.draw(now_ += 0.02, show, picture_);
  }
  void send(const Event& event) {
    overlay_.handle(event);
    for (int i = 0; i < 3; ++i) frame();
  }
  static int yOf(std::size_t row) { return kFirstRow + static_cast<int>(row) * kRowHeight; }
  void moveTo(int x, int y) { send(test::moveTo(left_ + x, y)); }
  void press(int x, std::size_t row) {
    moveTo(x, yOf(row));
    send(test::pressAt(left_ + x, yOf(row)));
  }
  void release() { send(test::releaseAt(left_, 0)); }
  void click(int x, int y) {
    moveTo(x, y);
    for (const Event& event : test::clickAt(left_ + x, y)) send(event);
  }
  void type(const char* text) { send(TypedText{text}); }
  void typeReturn() {
    send(test::down(Key::Return));
    send(test::up(Key::Return));
  }

  /// Chooses an entry of the list that a row's trigger opens.
  void choose(MoverTrigger trigger, std::size_t row) {
    click(kTrigger, yOf(row));
    click(kTrigger, yOf(row) + 24 + 17 * static_cast<int>(trigger));
    click(20, 250);  // closes what is still open
  }

  LoadedLevel level_ = *test::hallAndCellar().result.loaded;
  std::vector<double> shares_ = {0, 0};
  MoverPermissions permissions_{true, true};
  MoversSection section_;
  std::vector<MoverEdit> edits_;  ///< that were to be written
  Overlay overlay_;
  test::Canvas picture_{900, 300};
  int left_ = 0;
  double now_ = 1;
};

TEST_F(MoversSectionTest, HoldsAMoverWhereItIsDraggedUntilItIsLetGo) {
  EXPECT_FALSE(section_.held());
  press(kShareRight, Lift);
  EXPECT_EQ(section_.held(), (MoverShare{Lift, 1}));
  moveTo((kShareLeft + kShareRight) / 2, yOf(Lift));
  ASSERT_TRUE(section_.held());
  EXPECT_NEAR(section_.held()->share, 0.5, 0.05);
  for (int i = 0; i < 8; ++i) frame();
  EXPECT_TRUE(section_.held()) << "also while the hand rests";
  release();
  EXPECT_FALSE(section_.held());
  EXPECT_TRUE(edits_.empty());
}

TEST_F(MoversSectionTest, HoldsNothingAnyMoreInALevelThatIsLoadedAnew) {
  press(kShareRight, Gate);
  section_.forget();
  EXPECT_FALSE(section_.held()) << "as its movers may have other indices";
  frame();
  EXPECT_TRUE(section_.held());
}

TEST_F(MoversSectionTest, AsksOnceToWriteASpeedThatIsDragged) {
  press(kSpeed, Gate);
  for (const int way : {10, 20, 30}) moveTo(kSpeed + way, yOf(Gate));
  EXPECT_TRUE(edits_.empty()) << "while it is dragged";
  release();
  ASSERT_EQ(edits_.size(), 1);
  EXPECT_EQ(edits_[0].name, "gate");
  EXPECT_EQ(edits_[0].trigger, MoverTrigger::Use);
  EXPECT_GT(edits_[0].speed, 1.5);
}

TEST_F(MoversSectionTest, AsksForNothingWhereASpeedIsDraggedBack) {
  press(kSpeed, Gate);
  for (const int way : {10, 20, 10, 0, -10, -5, 0}) moveTo(kSpeed + way, yOf(Gate));
  release();
  EXPECT_TRUE(edits_.empty());
}

TEST_F(MoversSectionTest, WritesASpeedThatIsTypedOnceItIsEntered) {
  click(kSpeed, yOf(Lift));
  type("0.25");
  EXPECT_TRUE(edits_.empty());
  typeReturn();
  EXPECT_EQ(edits_, (std::vector<MoverEdit>{{"lift", MoverTrigger::Enter, 0.25}}));
}

TEST_F(MoversSectionTest, WritesASpeedThatIsTypedWhereAClickEndsIt) {
  click(kSpeed, yOf(Lift));
  type("0.25");
  click(kShareLeft, yOf(Gate));
  EXPECT_EQ(edits_, (std::vector<MoverEdit>{{"lift", MoverTrigger::Enter, 0.25}}));
}

TEST_F(MoversSectionTest, KeepsASpeedWithinWhatTheLoaderTakes) {
  click(kSpeed, yOf(Gate));
  type("-7");
  typeReturn();
  ASSERT_EQ(edits_.size(), 1);
  EXPECT_GT(edits_[0].speed, 0);
}

TEST_F(MoversSectionTest, GivesUpASpeedThatIsDraggedAsThePanelCloses) {
  press(kSpeed, Gate);
  moveTo(kSpeed + 20, yOf(Gate));
  section_.giveUp();
  overlay_.toggle();
  overlay_.toggle();
  for (int i = 0; i < 4; ++i) frame();
  EXPECT_TRUE(edits_.empty());
}

TEST_F(MoversSectionTest, OffersTheTriggersOfAMover) {
  choose(MoverTrigger::Loop, Gate);
  choose(MoverTrigger::None, Lift);
  EXPECT_EQ(edits_, (std::vector<MoverEdit>{{"gate", MoverTrigger::Loop, 1.5},
                                            {"lift", MoverTrigger::None, 1.5}}));
}

TEST_F(MoversSectionTest, OffersEnterOnlyToMoversWithZones) {
  choose(MoverTrigger::Enter, Gate);
  EXPECT_TRUE(edits_.empty());
  level_.level.movers[Gate].zones = {SectorId(0)};
  choose(MoverTrigger::Enter, Gate);
  EXPECT_EQ(edits_, (std::vector<MoverEdit>{{"gate", MoverTrigger::Enter, 1.5}}));
}

TEST_F(MoversSectionTest, ShowsWhatWasWrittenUntilTheLevelIsLoadedAnew) {
  frame();
  const Image before = picture_.image();
  section_.noteWritten({"gate", MoverTrigger::Loop, 3});
  frame();
  const Image written = picture_.image();
  EXPECT_NE(written, before);
  section_.forget();
  frame();
  EXPECT_EQ(picture_.image(), before);
  level_.level.movers[Gate].trigger = MoverTrigger::Loop;
  level_.level.movers[Gate].speed = 3;
  frame();
  EXPECT_EQ(picture_.image(), written);
}

TEST_F(MoversSectionTest, ShowsTheHeightThatFramesShow) {
  frame();
  const Image shut = picture_.image();
  frame();
  EXPECT_EQ(picture_.image(), shut);
  level_.geometry.sectors[level_.level.movers[Gate].sectors.front().index()].zCeiling = 1.25;
  frame();
  EXPECT_NE(picture_.image(), shut);
}

TEST_F(MoversSectionTest, ChangesNothingThatTheWalkDoesNotGrantAndSaysWhy) {
  frame();
  const Image granted = picture_.image();
  permissions_ = {};
  frame();
  EXPECT_NE(picture_.image(), granted);
  for (int y = 4; y < picture_.height(); y += 8)
    for (const int x : {kShareRight, kTrigger, kSpeed}) {
      moveTo(x, y);
      send(test::pressAt(left_ + x, y));
      moveTo(x + 20, y);
      EXPECT_FALSE(section_.held()) << y;
      EXPECT_FALSE(overlay_.hasPopup()) << y;
      release();
    }
  EXPECT_TRUE(edits_.empty());
}

TEST_F(MoversSectionTest, LaysOutNoMoreOfALongListThanShows) {
  const auto verticesOf = [this](std::size_t count) {
    level_.level.movers.resize(2);
    while (level_.level.movers.size() < count) {
      level_.level.movers.push_back(level_.level.movers[Gate]);
      level_.level.movers.back().name = "gate-" + std::to_string(level_.level.movers.size());
    }
    shares_.assign(count, 0);
    for (int i = 0; i < 3; ++i) frame();
    return ImGui::GetDrawData()->TotalVtxCount;
  };
  EXPECT_LT(verticesOf(5000), 1.1 * verticesOf(50));
}

TEST_F(MoversSectionTest, ScrollsALongListBelowItsHeaders) {
  while (level_.level.movers.size() < 100) {
    level_.level.movers.push_back(level_.level.movers[Gate]);
    level_.level.movers.back().name = "gate-" + std::to_string(level_.level.movers.size());
  }
  shares_.assign(100, 0);
  frame();
  moveTo(20, yOf(3));
  const auto header = [this] {
    Image part(200, kHeader);
    for (int y = 0; y < part.height(); ++y)
      for (int x = 0; x < part.width(); ++x) part.at(x, y) = picture_.at(left_ + x, y);
    return part;
  };
  const Image before = header();
  for (int i = 0; i < 100; ++i) send(WheelTurn{.up = -4});
  EXPECT_EQ(header(), before);
  std::optional<MoverShare> held;
  for (int y = kFirstRow; y < picture_.height() && (!held || held->mover < 99); y += 10) {
    moveTo(kShareLeft + 20, y);
    send(test::pressAt(left_ + kShareLeft + 20, y));
    if (section_.held()) held = section_.held();
    release();
  }
  ASSERT_TRUE(held);
  EXPECT_EQ(held->mover, 99) << "the last";
}

}  // namespace
}  // namespace hearth
