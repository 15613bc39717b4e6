// The tabs of a panel.

#include "viewer/overlay/tab_bar.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "image/pixel_rows.h"
#include "viewer/overlay/overlay.h"
#include "walk/stage.h"

namespace hearth {
namespace {

/// A panel of three tabs, which says which of them shows.
class TabBarTest : public testing::Test {
 protected:
  TabBarTest() {
    overlay_.toggle();
    frames();
  }

  /// Until what has happened is settled.
  void frames() {
    for (int i = 0; i < 4; ++i) {
      shown_.reset();
      overlay_.draw(
          now_ += 0.02, [this] { tabs_.show(std::span(all_).first(count_)); }, picture_);
    }
  }

  /// As a hand does: there first, then the button.
  void clickAt(int x, int y) {
    for (const Event& event : {test::moveTo(x, y), test::pressAt(x, y), test::releaseAt(x, y)}) {
      overlay_.handle(event);
      frames();
    }
  }

  std::array<Tab, 3> all_ = {{{"A", [this] { shown_ = 0; }},
                              {"B", [this] { shown_ = 1; }},
                              {"C", [this] { shown_ = 2; }}}};
  std::size_t count_ = 3;
  Overlay overlay_;
  TabBar tabs_;
  PixelBuffer memory_;
  PixelRows picture_ = memory_.rows(700, 400);
  std::optional<std::size_t> shown_;
  double now_ = 1;
};

TEST_F(TabBarTest, ShowsTheFirstTab) { EXPECT_EQ(shown_, 0); }

TEST_F(TabBarTest, ShowsTheTabThatIsClicked) {
  const int left = overlay_.widthBeside(picture_.width);
  clickAt(left + 33, 17);
  EXPECT_EQ(shown_, 1);
  clickAt(left + 15, 17);
  EXPECT_EQ(shown_, 0);
}

TEST_F(TabBarTest, ShowsTheTabThatTheProgramNames) {
  tabs_.turnTo("C");
  frames();
  EXPECT_EQ(shown_, 2);
  frames();
  EXPECT_EQ(shown_, 2);
}

TEST_F(TabBarTest, KeepsItsTabWhereLettersGrow) {
  tabs_.turnTo("C");
  frames();
  picture_ = memory_.rows(1600, 1440);
  frames();
  EXPECT_EQ(shown_, 2);
}

TEST_F(TabBarTest, ShowsAnotherTabWhereTheShownOneIsGone) {
  tabs_.turnTo("C");
  frames();
  count_ = 2;
  frames();
  EXPECT_TRUE(shown_);
  count_ = 3;
  frames();
  tabs_.turnTo("C");
  frames();
  EXPECT_EQ(shown_, 2);
}

}  // namespace
}  // namespace hearth
