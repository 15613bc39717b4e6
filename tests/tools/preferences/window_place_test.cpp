// Where a window lies, from one walk to the next.

#include "desktop/window_place.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

namespace hearth {
namespace {

namespace fs = std::filesystem;

constexpr std::array kScreens = {Screen{0, 30, 1000, 770}, Screen{1000, 0, 2000, 1000}};

TEST(WindowPlaceTest, StaysWhereItFits) {
  for (const WindowPlace& place : {WindowPlace{0, 30, {1000, 770}}, {1500, 0, {800, 600}, true}})
    EXPECT_EQ(onScreen(place, kScreens), place);
  EXPECT_EQ(onScreen({-5, 5, {9, 9}}, {}), (WindowPlace{-5, 5, {9, 9}}));
}

TEST(WindowPlaceTest, IsMovedOntoTheScreenThatHasMostOfIt) {
  EXPECT_EQ(onScreen({900, 500, {400, 600}}, kScreens), (WindowPlace{1000, 400, {400, 600}}));
  EXPECT_EQ(onScreen({700, 0, {400, 600}}, kScreens), (WindowPlace{600, 30, {400, 600}}));
  EXPECT_EQ(onScreen({5000, 5000, {400, 600}}, kScreens), (WindowPlace{600, 200, {400, 600}}));
}

TEST(WindowPlaceTest, IsMadeAsSmallAsTheScreen) {
  EXPECT_EQ(onScreen({-100, 100, {1100, 900}}, kScreens), (WindowPlace{0, 30, {1000, 770}}));
}

class KeptWindowPlace : public testing::Test {
 protected:
  KeptWindowPlace() { fs::remove_all(folder_); }
  ~KeptWindowPlace() override { fs::remove_all(folder_); }

  fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path file_ = folder_ / "hearth" / "window.json";
};

TEST_F(KeptWindowPlace, IsReadAsItWasKept) {
  EXPECT_FALSE(readWindowPlace(file_));
  for (const bool isFullScreen : {true, false}) {
    const WindowPlace place{-7, 12, {640, 400}, isFullScreen};
    keepWindowPlace(file_, place);
    EXPECT_EQ(readWindowPlace(file_), place);
  }
}

TEST_F(KeptWindowPlace, IsNoneWhereItMakesNoSense) {
  fs::create_directories(file_.parent_path());
  for (const char* text : {"", "[]", "{}", R"({"x":0,"y":0,"width":0,"height":9})",
                           R"({"x":1e99,"y":0,"width":9,"height":99999})",
                           R"({"x":9999999,"y":0,"width":9,"height":9})"}) {
    std::ofstream(file_) << text;
    EXPECT_FALSE(readWindowPlace(file_)) << text;
  }
}

TEST_F(KeptWindowPlace, IsNotKeptWhereThatCannotBe) {
  keepWindowPlace("/dev/null/hearth/window.json", {1, 2, {3, 4}});
  EXPECT_FALSE(readWindowPlace("/dev/null/hearth/window.json"));
}

}  // namespace
}  // namespace hearth
