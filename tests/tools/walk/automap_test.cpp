// The map of what was seen, at pixels worked out by hand.

#include "viewer/overlay/automap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "loaded.h"
#include "support/canvas.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr Rgb kPaper = {64, 64, 64};
constexpr Rgb kDarkened = {16, 16, 16};

/// Two rooms of 4 m x 4 m side by side, the second one 0.3 m higher; and one upstairs.
LoadedLevel house() {
  const std::string walls =
      "[{'texture':'#808080'},{'next':'east','texture':'#808080'},{'texture':'#808080'},"
      "{'texture':'#808080'}]";
  const std::string back =
      "[{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'},"
      "{'next':'west','texture':'#808080'}]";
  return test::levelFrom("{'light':1,'sectors':{" +
                         test::sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 3, walls) + "," +
                         test::sectorText("east", "4,0, 8,0, 8,4, 4,4", 0.3, 3, back) + "," +
                         test::sectorText("upstairs", "-4,0, 0,0, 0,4, -4,4", 4, 7) + "}}");
}

class AutomapTest : public testing::Test {
 protected:
  /// 100 x 100 pixels, 10 to the metre.
  Image draw(double metres = 10) const {
    test::Canvas picture(100, 100, kPaper);
    drawAutomap(picture, scene_, seen_, eye_, metres);
    return picture.image();
  }
  static bool has(const Image& picture, Rgb color) {
    return std::ranges::find(picture.pixels(), color) != picture.pixels().end();
  }

  LoadedLevel house_ = house();
  const Level& level_ = house_.level;
  const Scene scene_ = house_.scene();
  SectorId west_ = sectorNamed(level_, "west");
  SectorId east_ = sectorNamed(level_, "east");
  SectorId upstairs_ = sectorNamed(level_, "upstairs");
  SeenSectors seen_{level_};
  Eye eye_{west_, {2, 2, 1.6}, 0, 0};
};

TEST_F(AutomapTest, ShowsOnlyWhatWasSeen) {
  const Image nothing = draw();
  EXPECT_FALSE(has(nothing, kSolidColor));
  EXPECT_TRUE(has(nothing, kPlayerColor));
  seen_.add(west_);
  const Image west = draw();
  EXPECT_EQ(west.at(30, 50), kSolidColor) << "the wall at x = 0, two metres to the left";
  EXPECT_EQ(west.at(50, 30), kSolidColor) << "the wall at y = 0, two metres up the picture";
  EXPECT_EQ(west.at(90, 30), kDarkened) << "the other room";
  seen_.add(east_);
  EXPECT_EQ(draw().at(90, 30), kSolidColor);
}

TEST_F(AutomapTest, TellsStepsFromWallsAndPlainOpenings) {
  seen_.add(west_);
  seen_.add(east_);
  EXPECT_EQ(draw().at(70, 40), kStepColor) << "seen from both sides, the step is what counts";
  const auto kindAtX4 = [&](SectorId sector) {
    for (const Segment& segment : level_.segmentsOf(level_[sector]))
      if (segment.p0.x == 4 && segment.p1.x == 4) return wallKind(scene_, segment);
    return WallKind::Solid;
  };
  EXPECT_EQ(kindAtX4(west_), WallKind::Step);
  EXPECT_EQ(kindAtX4(east_), WallKind::Opening) << "all of the higher room's wall is open";
}

TEST_F(AutomapTest, OtherStoreysAreDim) {
  seen_.add(upstairs_);
  const Image fromBelow = draw();
  EXPECT_FALSE(has(fromBelow, kSolidColor));
  EXPECT_EQ(fromBelow.at(20, 30), (Rgb{85, 85, 85}));
  eye_.point.z = 5.6;
  EXPECT_EQ(draw().at(20, 30), kSolidColor);
}

TEST_F(AutomapTest, TheArrowPointsWhereThePlayerLooks) {
  const auto countRightAndBelow = [&](double angle) {
    eye_.angle = angle;
    const Image picture = draw();
    std::pair<int, int> count{0, 0};
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 100; ++x)
        if (picture.at(x, y) == kPlayerColor) {
          count.first += x >= 54 ? 1 : 0;
          count.second += y >= 54 ? 1 : 0;
        }
    return count;
  };
  const auto [eastRight, eastBelow] = countRightAndBelow(0);
  const auto [southRight, southBelow] = countRightAndBelow(90);
  EXPECT_GT(eastRight, 0);
  EXPECT_EQ(southRight, 1) << "the tail's corner";
  EXPECT_EQ(eastBelow, 1);
  EXPECT_GT(southBelow, 0);
}

TEST_F(AutomapTest, ZoomHasBounds) {
  EXPECT_LT(zoomedIn(kFirstMapMetres), kFirstMapMetres);
  EXPECT_DOUBLE_EQ(zoomedOut(zoomedIn(kFirstMapMetres)), kFirstMapMetres);
  double metres = kFirstMapMetres;
  for (int i = 0; i < 100; ++i) metres = zoomedIn(metres);
  EXPECT_EQ(metres, 2);
  for (int i = 0; i < 100; ++i) metres = zoomedOut(metres);
  EXPECT_EQ(metres, 4096);
}

TEST_F(AutomapTest, FlatPortalsAreDotted) {
  const LoadedLevel rooms = loaded("tests/levels/rooms.json");
  SeenSectors seen(rooms.level);
  seen.add(rooms.level.player->sector);
  test::Canvas picture(200, 200, kPaper);
  drawAutomap(picture, rooms.scene(), seen, {rooms.level.player->sector, rooms.level.player->eye},
              10);
  EXPECT_TRUE(has(picture.image(), kMapFlatPortalColor));
}

TEST_F(AutomapTest, AnyPictureAndAnyPlaceWillDo) {
  seen_.add(west_);
  eye_.point = {1e6, -1e6, 1.6};
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 100}, {300, 2}}) {
    test::Canvas around(width + 2, height + 2, kPaper);
    const PixelRows& rows = around;
    const PixelRows picture = rows.part(1, 1, width, height);
    drawAutomap(picture, scene_, seen_, eye_, 2);
    picture.fill(kPaper);
    EXPECT_EQ(around.image(), Image(width + 2, height + 2, kPaper)) << "nothing beside it";
  }
}

TEST_F(AutomapTest, SpansTellWhatIsSeen) {
  seen_.add(Span{0, 0, 1, *level_[east_].floorSurface, nullptr, nullptr, 2.0});
  EXPECT_TRUE(seen_.has(east_));
  EXPECT_FALSE(seen_.has(west_));
}

}  // namespace
}  // namespace hearth
