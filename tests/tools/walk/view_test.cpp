// What lies between the renderer's picture and the screen: its place, its rate, its file.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "desktop/screenshot_files.h"
#include "image/image_file.h"
#include "support/canvas.h"
#include "support/temporary_folder.h"
#include "viewer/overlay/captions.h"
#include "viewer/walk/frame_rate.h"
#include "viewer/walk/placement.h"

namespace hearth {
namespace {

TEST(PlacedPicture, KeepsItsAspectInTheMiddle) {
  EXPECT_EQ(placed({320, 200}, {960, 600}, Scaling::Smooth), (Placement{0, 0, 960, 600, true}));
  EXPECT_EQ(placed({320, 200}, {1000, 600}, Scaling::Smooth), (Placement{20, 0, 960, 600, true}));
  EXPECT_EQ(placed({320, 200}, {400, 400}, Scaling::Smooth), (Placement{0, 75, 400, 250, false}));
}

TEST(PlacedPicture, GrowsByWholePixelsOnly) {
  EXPECT_EQ(placed({320, 200}, {959, 700}, Scaling::Integer),
            (Placement{159, 150, 640, 400, true}));
  EXPECT_EQ(placed({320, 200}, {320, 200}, Scaling::Integer), (Placement{0, 0, 320, 200, true}));
}

TEST(PlacedPicture, ShrinksIntoASmallWindowWhateverTheScaling) {
  for (const Scaling scaling : {Scaling::Smooth, Scaling::Integer}) {
    EXPECT_EQ(placed({320, 200}, {160, 200}, scaling), (Placement{0, 50, 160, 100, false}));
    EXPECT_EQ(placed({16384, 1}, {1, 1}, scaling), (Placement{0, 0, 1, 1, false}));
  }
}

TEST(FrameRateTest, IsTheMeanOfASecond) {
  FrameRate rate;
  double now = 5;
  for (int i = 0; i < 8; ++i, now += 0.125) EXPECT_FALSE(rate.count(now, now + 0.0625)) << i;
  const auto mean = rate.count(now, now + 0.0625);
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->drawSeconds, 0.0625, 1e-9);
  EXPECT_NEAR(mean->framesPerSecond, 8, 1e-9);
  EXPECT_FALSE(rate.count(now + 0.125, now + 0.25)) << "the next second begins";
}

TEST(FrameRateTest, IsThatOfTheCapHoweverSoonFramesAreDrawn) {
  for (const int cap : {2, 60})
    for (const double drawSeconds : {0.0, 0.005, 0.4 / cap}) {
      FrameRate rate;
      int means = 0;
      for (int i = 0; i < 6 * cap; ++i) {
        const double begin = i / static_cast<double>(cap);
        const auto mean = rate.count(begin, begin + drawSeconds);
        if (!mean) continue;
        ++means;
        EXPECT_NEAR(mean->framesPerSecond, cap, 1e-9) << i;
        EXPECT_NEAR(mean->drawSeconds, drawSeconds, 1e-9) << i;
      }
      EXPECT_GE(means, 4);
    }
}

TEST(FrameRateTest, StartsAnewAfterARestAndWhenTheClockIsSetBack) {
  FrameRate rate;
  rate.count(0, 0.5);
  EXPECT_FALSE(rate.count(100, 100.5));
  EXPECT_FALSE(rate.count(100.5, 101));
  EXPECT_EQ(rate.count(101, 101.5)->framesPerSecond, 2);
  rate.count(101.5, 102);
  EXPECT_FALSE(rate.count(3, 3.75));
  EXPECT_FALSE(rate.count(3.75, 4.5));
  EXPECT_EQ(rate.count(4.5, 5.25)->drawSeconds, 0.75);
}

TEST(FrameRateTest, StartsAnewWhenTheClockIsSetBackWithinAFrame) {
  FrameRate rate;
  rate.count(100, 100.5);
  EXPECT_FALSE(rate.count(100.5, 3));
  EXPECT_FALSE(rate.count(3, 3.5));
  const auto mean = rate.count(3.5, 4);
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean->drawSeconds, 0.5);
  EXPECT_EQ(mean->framesPerSecond, 2);
}

class ScreenshotsTest : public testing::Test {
  test::TemporaryFolder temporary_;

 protected:
  std::filesystem::path folder_ = temporary_.path();
};

TEST_F(ScreenshotsTest, NeverReplaceAFile) {
  std::ofstream(folder_ / "hearth-yard-1.png") << "mine";
  ScreenshotFiles screenshots(folder_, "yard");
  Image picture(3, 2, {10, 20, 30});
  screenshots.take(picture, "a note");
  const auto first = screenshots.awaitNews();
  ASSERT_TRUE(first);
  EXPECT_TRUE(first->isSaved);
  EXPECT_EQ(first->text, "saved hearth-yard-2.png");
  EXPECT_EQ(first->note, "a note");
  picture.at(0, 0) = {};
  screenshots.take(picture, "");
  screenshots.take(picture, "");
  while (screenshots.awaitNews()) continue;
  EXPECT_EQ(readImage(folder_ / "hearth-yard-2.png", 100)->at(0, 0), (Rgb{10, 20, 30}));
  for (const char* name : {"hearth-yard-3.png", "hearth-yard-4.png"})
    EXPECT_EQ(*readImage(folder_ / name, 100), picture);
  std::string mine;
  std::ifstream(folder_ / "hearth-yard-1.png") >> mine;
  EXPECT_EQ(mine, "mine");
}

TEST_F(ScreenshotsTest, SayWhatIsWrong) {
  ScreenshotFiles screenshots(folder_ / "missing", "yard");
  screenshots.take(Image(1, 1), "");
  const auto news = screenshots.awaitNews();
  ASSERT_TRUE(news);
  EXPECT_FALSE(news->isSaved);
  EXPECT_NE(news->text.find("hearth-yard-1.png: cannot be written: No such"), std::string::npos)
      << news->text;
}

constexpr Rgb kPaper = {200, 200, 200};

TEST(Captions, StaysInsidePicturesOfAnySize) {
  for (const auto& [width, height] : {ImageSize{1, 1}, {3, 900}, {900, 3}, {320, 200}}) {
    test::Canvas around(width + 2, height + 2, kPaper);
    const PixelRows& rows = around;
    const PixelRows picture = rows.part(1, 1, width, height);
    drawKeys(picture, keyList({}));
    drawMessage(picture, "a message that is longer than the picture is wide");
    EXPECT_NE(imageOf(picture), Image(width, height, kPaper));
    picture.fill(kPaper);
    EXPECT_EQ(around.image(), Image(width + 2, height + 2, kPaper)) << "nothing beside it";
  }
}

TEST(Captions, HasRoomForAllKeysInASmallPicture) {
  const Image plain(320, 200, kPaper);
  test::Canvas picture(320, 200, kPaper);
  drawKeys(picture, keyList({}));
  for (int x = 0; x < 320; ++x) {
    EXPECT_EQ(picture.at(x, 0), plain.at(x, 0));
    EXPECT_EQ(picture.at(x, 199), plain.at(x, 199));
  }
  for (int y = 0; y < 200; ++y) {
    EXPECT_EQ(picture.at(0, y), plain.at(0, y));
    EXPECT_EQ(picture.at(319, y), plain.at(319, y));
  }
}

TEST(Captions, DarkenToAQuarterOfEachChannel) {
  test::Canvas picture(4, 1, {255, 7, 3});
  darken(picture, 1, -1, 3, 2);
  EXPECT_EQ(picture.at(0, 0), (Rgb{255, 7, 3}));
  EXPECT_EQ(picture.at(1, 0), (Rgb{63, 1, 0}));
  EXPECT_EQ(picture.at(2, 0), (Rgb{63, 1, 0}));
  EXPECT_EQ(picture.at(3, 0), (Rgb{255, 7, 3}));
}

TEST(Captions, IsLargerInLargerPictures) {
  EXPECT_EQ(captionScale(test::Canvas(320, 200)), 1);
  EXPECT_EQ(captionScale(test::Canvas(1920, 1080)), 3);
  EXPECT_EQ(captionScale(test::Canvas(600, 4000)), 1);
}

}  // namespace
}  // namespace hearth
