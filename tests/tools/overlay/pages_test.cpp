// The pages of a panel, and their tabs.

#include "viewer/overlay/pages.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <optional>

#include "image/pixel_rows.h"
#include "viewer/overlay/overlay.h"
#include "walk/stage.h"

namespace hearth {
namespace {

/// A panel of three pages, which says which of them shows.
class PagesTest : public testing::Test {
 protected:
  PagesTest() {
    overlay_.toggle();
    frames();
  }

  /// Until what has happened is settled.
  void frames() {
    for (int i = 0; i < 4; ++i) {
      shown_.reset();
      overlay_.draw(
          now_ += 0.02, [this] { pages_.show(all_); }, picture_);
    }
  }

  /// As a hand does: there first, then the button.
  void clickAt(int x, int y) {
    for (const Event& event : {test::moveTo(x, y), test::pressAt(x, y), test::releaseAt(x, y)}) {
      overlay_.take(event);
      frames();
    }
  }

  std::array<Page, 3> all_ = {{{"A", [this] { shown_ = 0; }},
                               {"B", [this] { shown_ = 1; }},
                               {"C", [this] { shown_ = 2; }}}};
  Overlay overlay_;
  Pages pages_;
  PixelBuffer memory_;
  PixelRows picture_ = memory_.rows(700, 400);
  std::optional<std::size_t> shown_;
  double now_ = 1;
};

TEST_F(PagesTest, ShowTheFirst) { EXPECT_EQ(shown_, 0); }

TEST_F(PagesTest, AreTurnedByTheirTabs) {
  const int left = overlay_.leaves(picture_.width);
  clickAt(left + 33, 17);
  EXPECT_EQ(shown_, 1);
  clickAt(left + 15, 17);
  EXPECT_EQ(shown_, 0);
}

TEST_F(PagesTest, AreTurnedByTheProgram) {
  pages_.turnTo(2);
  frames();
  EXPECT_EQ(shown_, 2);
  frames();
  EXPECT_EQ(shown_, 2);
}

TEST_F(PagesTest, StayTurnedWhereLettersGrow) {
  pages_.turnTo(2);
  frames();
  picture_ = memory_.rows(1600, 1440);
  frames();
  EXPECT_EQ(shown_, 2);
}

}  // namespace
}  // namespace hearth
