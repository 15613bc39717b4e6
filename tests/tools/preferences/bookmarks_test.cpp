// Places that are kept, gone back to, and written as shots of the level.

#include "viewer/preferences/bookmarks.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "desktop/disk.h"
#include "viewer/edit/shots_edit.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRoom =
    R"("hall": { "floor": { "texture": "#808080" }, "ceiling": { "texture": "#808080" },
    "loops": { "border": { "v": [0,0, 9,0, 9,9, 0,9], "walls": { "texture": "#808080" } } } })";

class BookmarksTest : public testing::Test {
 protected:
  BookmarksTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~BookmarksTest() override { fs::remove_all(folder_); }

  LoadedLevel level(const std::string& text) {
    std::ofstream(level_) << text;
    return *loadLevel(level_).loaded;
  }
  std::string file() const {
    std::ifstream stream(level_);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static std::string rooms(const std::string& before = "") {
    return "{\n  \"light\": 1,\n" + before + "  \"sectors\": { " + kRoom + " }\n}\n";
  }

  Disk disk_;
  fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path level_ = folder_ / "rooms.json";
  fs::path kept_ = folder_ / "state" / "rooms.json";
  Bookmark mark_{"door", "hall", {1.5, 2, 1.6}, 30, -5, 60, true};
};

TEST_F(BookmarksTest, AreKeptInTheirFile) {
  Bookmarks marks(disk_, kept_);
  EXPECT_EQ(marks.freeName(), "place-1");
  Bookmark other = mark_;
  other.name = "place-1";
  ASSERT_TRUE(marks.add(mark_));
  ASSERT_TRUE(marks.add(other));
  EXPECT_EQ(marks.freeName(), "place-2");
  mark_.eye.x = 4;
  ASSERT_TRUE(marks.add(mark_)) << "in place of the one of its name";
  EXPECT_EQ(Bookmarks(disk_, kept_).all(), (std::vector{mark_, other}));
  ASSERT_TRUE(marks.remove("place-1"));
  EXPECT_EQ(Bookmarks(disk_, kept_).all(), std::vector{mark_});
}

TEST_F(BookmarksTest, AreReadAsFarAsTheyMakeSense) {
  ASSERT_TRUE(Bookmarks(disk_, kept_).add(mark_));
  std::ifstream stream(kept_);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  text.insert(text.find('[') + 1, R"({"name": "x"}, 7, )");
  std::ofstream(kept_) << text;
  EXPECT_EQ(Bookmarks(disk_, kept_).all(), std::vector{mark_});
  std::ofstream(kept_) << "{";
  EXPECT_TRUE(Bookmarks(disk_, kept_).all().empty());
}

TEST_F(BookmarksTest, SayWhenTheyCannotBeKept) {
  Bookmarks marks(disk_, "/dev/null/place.json");
  const auto added = marks.add(mark_);
  ASSERT_FALSE(added);
  EXPECT_TRUE(added.error().starts_with("/dev/null/place.json: cannot be written"))
      << added.error();
}

TEST_F(BookmarksTest, LeadBackToTheirPlace) {
  const LoadedLevel loaded = level(rooms());
  Walker walker = walkerAt(loaded.scene(), SectorId(0), {3.12345678, 4, 1.6}, 12.3456, 7);
  walker.isFlying = true;
  const Bookmark mark = bookmarkOf(loaded.scene(), walker, 75, "here");
  EXPECT_EQ(mark, (Bookmark{"here", "hall", {3.123, 4, 1.6}, 12.35, 7, 75, true}));
  const auto back = walkerAt(loaded.scene(), mark);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->feet.x, 3.123);
  EXPECT_EQ(back->angle, 12.35);
  EXPECT_EQ(back->pitch, 7);
  EXPECT_TRUE(back->isFlying);
}

TEST_F(BookmarksTest, AreTheVeryPlaceWhereTheSectorEndsCloseBy) {
  std::string narrower = rooms();
  narrower.replace(narrower.find("9,0, 9,9"), 8, "8.9997,0, 8.9997,9");
  const LoadedLevel loaded = level(narrower);
  const Walker walker = walkerAt(loaded.scene(), SectorId(0), {8.9996, 4, 1.6}, 0, 0);
  EXPECT_EQ(bookmarkOf(loaded.scene(), walker, 90, "").eye.x, 8.9996);
}

TEST_F(BookmarksTest, LeadNowhereWhereTheLevelHasChanged) {
  const LoadedLevel loaded = level(rooms());
  mark_.eye.x = 20;
  EXPECT_FALSE(walkerAt(loaded.scene(), mark_));
  mark_.sector = "cellar";
  EXPECT_FALSE(walkerAt(loaded.scene(), mark_));
}

TEST_F(BookmarksTest, BecomeShotsAndLeaveTheRestOfTheFile) {
  const std::string shot =
      R"({ "name": "door", "camera": [1.5, 2, 1.6, 30, -5], "fov": 60, "sector": "hall" })";
  ASSERT_TRUE(writeShot(disk_, level(rooms()), mark_));
  EXPECT_EQ(file(), rooms("  \"shots\": [\n    " + shot + "\n  ],\n"));
  const LoadedLevel loaded = *loadLevel(level_).loaded;
  ASSERT_EQ(loaded.level.shots.size(), 1);
  EXPECT_EQ(loaded.level.shots[0].eye, mark_.eye);

  mark_.name = "second";
  mark_.fov = 90;
  ASSERT_TRUE(writeShot(disk_, loaded, mark_));
  EXPECT_EQ(file(), rooms("  \"shots\": [\n    " + shot +
                          ",\n    { \"name\": \"second\", \"camera\": [1.5, 2, 1.6, 30, -5], "
                          "\"sector\": \"hall\" }\n  ],\n"));
}

TEST_F(BookmarksTest, BecomeNoShotsOfATakenNameOrAChangedFile) {
  const LoadedLevel loaded = level(rooms());
  ASSERT_TRUE(writeShot(disk_, loaded, mark_));
  const std::string written = file();
  const auto late = writeShot(disk_, loaded, mark_);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error(), level_.string() +
                              ": has changed since it was loaded; "
                              "try again once it is shown as it is");
  const auto again = writeShot(disk_, *loadLevel(level_).loaded, mark_);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error(), level_.string() +
                               ": has a shot \"door\" already; "
                               "give the bookmark another name");
  EXPECT_EQ(file(), written);
}

}  // namespace
}  // namespace hearth
