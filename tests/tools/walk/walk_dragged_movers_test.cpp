// Movers that are dragged and edited in the overlay of a walk.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "staged_walk.h"
#include "support/hall_and_cellar.h"

namespace hearth {
namespace {

using test::down;
using test::moveTo;
using test::pressAt;
using test::releaseAt;
using test::up;

enum Movers { Gate, Lift };

constexpr ImageSize kWindow{800, 400};

// Pixels of the window, as the panel is laid out.
constexpr int kPanel = 336;
constexpr int kTabs = 17;
constexpr int kTab = kPanel + 411;
constexpr int kShareLeft = kPanel + 149;
constexpr int kShareRight = kPanel + 226;
constexpr int kSpeed = kPanel + 410;
constexpr int kFirstRow = 60;
constexpr int kRow = 23;

const test::Place& hall() {
  static const test::Place place(*test::hallAndCellar().result.loaded);
  return place;
}

/// Of a walk that can write its level.
WalkSettings writing(std::vector<MoverEdit>* written = nullptr) {
  WalkSettings settings;
  settings.writeMover = [written](const MoverEdit& edit) {
    if (written) written->push_back(edit);
    return tl::expected<void, std::string>();
  };
  return settings;
}

/// A walk whose panel shows the movers.
class PanelWalk : public test::StagedWalk {
 public:
  explicit PanelWalk(const WalkSettings& settings = writing(),
                     WalkSession::Record record = WalkSession::Record::No)
      : StagedWalk(settings, hall(), record) {
    stage.window = kWindow;
    now();
    begun = walker();
    send(down(Key::F1));
    click(kTab, kTabs);
  }

  void send(const Event& event) {
    now(event);
    ticks(4);
  }
  void press(int x, int y) {
    send(moveTo(x, y));
    send(pressAt(x, y));
  }
  void release() { send(releaseAt(kShareLeft, kTabs)); }
  void click(int x, int y) {
    press(x, y);
    send(releaseAt(x, y));
  }
  /// Presses the use key; the door is ahead.
  void use() {
    now(down(Key::E));
    now(up(Key::E));
    ticks(100);
  }
  double share(Movers mover) const { return shares()[mover]; }

  Walker begun;
};

TEST(WalkDraggedMovers, RestWhereTheyWereDragged) {
  PanelWalk walk;
  const Image shut = walk.stage.shown;
  walk.press(kShareRight, kFirstRow);
  EXPECT_EQ(walk.share(Gate), 1);
  walk.send(moveTo((kShareLeft + kShareRight) / 2, kFirstRow));
  walk.release();
  const double share = walk.share(Gate);
  EXPECT_NEAR(share, 0.5, 0.05);
  EXPECT_NE(walk.stage.shown, shut);
  walk.ticks(200);
  EXPECT_EQ(walk.share(Gate), share);
}

TEST(WalkDraggedMovers, AreHeldAgainstWhatStartsThem) {
  PanelWalk walk;
  walk.press((kShareLeft + kShareRight) / 2, kFirstRow);
  const double share = walk.share(Gate);
  walk.use();
  EXPECT_NEAR(walk.share(Gate), share, 0.02) << "no farther than a tick";
  walk.release();
  walk.use();
  EXPECT_EQ(walk.share(Gate), 1);
}

TEST(WalkDraggedMovers, WantTheLightOfTheirOtherEnd) {
  PanelWalk walk;
  EXPECT_TRUE(walk.loop().wantedLight().empty());
  walk.press((kShareLeft + kShareRight) / 2, kFirstRow);
  ASSERT_EQ(walk.loop().wantedLight().size(), 1U);
  EXPECT_EQ(walk.loop().wantedLight()[0], (std::vector<double>{1, 0}));
}

TEST(WalkDraggedMovers, AreLetGoWhenThePanelClosesOrTheWindowLosesTheFocus) {
  for (const Event& event : {down(Key::F1), Event(WindowEvent::FocusLost)}) {
    PanelWalk walk;
    walk.press((kShareLeft + kShareRight) / 2, kFirstRow);
    walk.send(event);
    walk.use();
    EXPECT_EQ(walk.share(Gate), 1);
  }
}

TEST(WalkDraggedMovers, TakeThePlayerAlong) {
  PanelWalk walk;
  walk.now(down(Key::S));  // onto the lift behind
  for (int i = 0; i < 200 && walk.share(Lift) < 1; ++i) walk.ticks(1);
  walk.now(up(Key::S));
  ASSERT_EQ(walk.walker().feet.z, 1);
  walk.press((kShareLeft + kShareRight) / 2, kFirstRow + kRow);
  EXPECT_NEAR(walk.walker().feet.z, 0.5, 0.05);
  EXPECT_EQ(walk.walker().feet.z, walk.share(Lift));
}

TEST(WalkDraggedMovers, AreNotDraggedInARecordedWalk) {
  PanelWalk walk({}, WalkSession::Record::Yes);
  for (int y = kFirstRow; y < kWindow.height; y += 8) {
    walk.press(kShareRight, y);
    walk.release();
    EXPECT_EQ(walk.share(Gate), 0) << y;
    EXPECT_EQ(walk.share(Lift), 0) << y;
  }
  EXPECT_EQ(walk.walker().feet, walk.begun.feet);
}

TEST(WalkDraggedMovers, AreNotDraggedInAReplay) {
  const std::vector<WalkInput> still(2000);
  PanelWalk walk;
  walk.loop().replay(still);
  for (int y = kFirstRow; y < kFirstRow + 4 * kRow; y += 8) {
    walk.press(kShareRight, y);
    walk.release();
    EXPECT_EQ(walk.share(Gate), 0) << y;
  }
  EXPECT_TRUE(walk.isOn);
}

TEST(WalkDraggedMovers, AreWrittenOnceASpeedIsLetGo) {
  std::vector<MoverEdit> written;
  PanelWalk walk(writing(&written));
  walk.press(kSpeed, kFirstRow);
  for (const int way : {10, 20, 30}) walk.send(moveTo(kSpeed + way, kFirstRow));
  EXPECT_TRUE(written.empty());
  walk.release();
  walk.ticks(100);
  ASSERT_EQ(written.size(), 1U);
  EXPECT_EQ(written[0].name, "gate");
  EXPECT_GT(written[0].speed, 1.5);
}

TEST(WalkDraggedMovers, ShowASpeedAsItIsWhereItCannotBeWritten) {
  WalkSettings settings;
  settings.writeMover = [](const MoverEdit&) {
    return tl::expected<void, std::string>(tl::unexpect, "the disk is full");
  };
  PanelWalk walk(settings);
  walk.send(moveTo(kSpeed, kFirstRow));
  const Image before = walk.stage.shown;
  walk.send(pressAt(kSpeed, kFirstRow));
  walk.send(moveTo(kSpeed + 30, kFirstRow));
  EXPECT_NE(walk.stage.shown, before);
  walk.release();
  walk.send(moveTo(kSpeed, kFirstRow));
  walk.ticks(1000);  // until the message is gone
  EXPECT_EQ(walk.stage.shown, before);
}

TEST(WalkDraggedMovers, HaveNoPageInALevelWithoutMovers) {
  test::StagedWalk walk({}, test::rooms(), WalkSession::Record::No);
  walk.stage.window = kWindow;
  walk.now(down(Key::F1));
  walk.ticks(4);
  walk.now(moveTo(kTab, kTabs));
  walk.ticks(4);
  const Image before = walk.stage.shown;
  for (const Event& event : test::clickAt(kTab, kTabs)) {
    walk.now(event);
    walk.ticks(4);
  }
  EXPECT_EQ(walk.stage.shown, before);
}

}  // namespace
}  // namespace hearth
