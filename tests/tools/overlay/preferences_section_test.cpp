// The sections that let choose how a walk is steered, and where to go.

#include "viewer/overlay/preferences_section.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "support/canvas.h"
#include "viewer/overlay/bookmarks_section.h"
#include "viewer/overlay/overlay.h"
#include "walk/stage.h"

namespace hearth {
namespace {

using test::down;

constexpr int kFirstRow = 18;

/// A panel with one section alone, and a hand that clicks into it.
class SectionTest : public testing::Test {
 protected:
  void open() {
    overlay_.toggle();
    frame();
    left_ = overlay_.widthBeside(picture_.width());
  }
  virtual void show() = 0;

  void frame() {
    overlay_.draw(
        now_ += 0.02, [this] { show(); }, picture_);
  }
  void click(int x, int y) {
    for (const Event& event : test::clickAt(x, y)) {
      overlay_.handle(event);
      frame();
      frame();
    }
  }

  Overlay overlay_;
  test::Canvas picture_{900, 900};
  int left_ = 0;
  double now_ = 1;
};

class PreferencesSectionTest : public SectionTest {
 protected:
  PreferencesSectionTest() { open(); }
  void show() override { wasWritten_ |= section_.show(preferences_); }

  /// Clicks down the second column until a key is waited for, and presses it.
  bool give(Key key) {
    for (int y = 88; y < 378; y += 6) {
      click(left_ + 242, y);
      if (section_.handle(down(key), preferences_)) return true;
    }
    return false;
  }

  PreferencesSection section_;
  Preferences preferences_;
  bool wasWritten_ = false;
};

TEST_F(PreferencesSectionTest, GivesAnActionTheKeyThatIsPressed) {
  EXPECT_FALSE(section_.handle(down(Key::F9), preferences_)) << "no key is waited for yet";
  ASSERT_TRUE(give(Key::F9));
  EXPECT_TRUE(preferences_.keys.actionOf(Key::F9));
  frame();
  EXPECT_TRUE(wasWritten_);
  EXPECT_FALSE(section_.handle(down(Key::F8), preferences_)) << "only one";
}

TEST_F(PreferencesSectionTest, TakesAKeyFromTheActionThatHadIt) {
  ASSERT_EQ(preferences_.keys.actionOf(Key::H), Action::Keys);
  ASSERT_TRUE(give(Key::H));
  EXPECT_NE(preferences_.keys.actionOf(Key::H), Action::Keys);
  EXPECT_TRUE(preferences_.keys.keysOf(Action::Keys).empty());
}

TEST_F(PreferencesSectionTest, LeavesAllAsItWasWithEsc) {
  ASSERT_TRUE(give(Key::Escape));
  EXPECT_EQ(preferences_, Preferences{});
  frame();
  EXPECT_FALSE(wasWritten_);
}

TEST_F(PreferencesSectionTest, ChangesNothingByItself) {
  preferences_.degreesPerPixel = 3.456;
  for (int i = 0; i < 4; ++i) frame();
  EXPECT_EQ(preferences_.degreesPerPixel, 3.456);
  EXPECT_FALSE(wasWritten_);
}

TEST_F(PreferencesSectionTest, HasASliderForTheMouse) {
  click(left_ + 250, kFirstRow);
  EXPECT_GT(preferences_.degreesPerPixel, 0.3);
  EXPECT_TRUE(wasWritten_);
}

class BookmarksSectionTest : public SectionTest {
 protected:
  BookmarksSectionTest() {
    static_cast<void>(bookmarks_.add({"door", "hall", {1, 2, 3}}));
    open();
  }
  void show() override {
    if (const auto request = section_.show(bookmarks_, permissions_)) request_ = request;
  }
  /// Clicks along the row of the bookmark until something is asked for.
  std::optional<BookmarkRequest> requestFrom(int begin) {
    request_.reset();
    for (int x = begin; x < begin + 40 && !request_; x += 8) click(left_ + x, 40);
    return request_;
  }

  BookmarksSection section_;
  Bookmarks bookmarks_;
  BookmarkPermissions permissions_{true, true};
  std::optional<BookmarkRequest> request_;
};

TEST_F(BookmarksSectionTest, AsksToGoToABookmark) {
  ASSERT_TRUE(requestFrom(10));
  EXPECT_EQ(request_->what, BookmarkRequest::What::GoTo);
  EXPECT_EQ(request_->name, "door");
}

TEST_F(BookmarksSectionTest, AsksForNothingThatCannotBeHad) {
  permissions_ = {};
  for (int x = 10; x < 130; x += 8) click(left_ + x, 40);
  EXPECT_FALSE(request_);
}

}  // namespace
}  // namespace hearth
