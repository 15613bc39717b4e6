#include "level/openings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/level_text.h"

namespace hearth {
namespace {

using test::levelFrom;
using test::sectorText;

constexpr std::string_view kSolid = "{'texture':'#808080'}";

void expectHeights(PortalHeights found, double zLowerTop, double zUpperBottom) {
  EXPECT_EQ(found.zLowerTop, zLowerTop);
  EXPECT_EQ(found.zUpperBottom, zUpperBottom);
}

TEST(PortalHeights, leaveTheOpeningBetweenTheNextSectorsFlats) {
  expectHeights(portalHeights(0, 3, 1, 2), 1, 2);
  expectHeights(portalHeights(0, 3, -1, 4), 0, 3);
  expectHeights(portalHeights(0, 3, 0, 3), 0, 3);
}

TEST(PortalHeights, fillTheRangeWhereNothingIsOpen) {
  expectHeights(portalHeights(0, 3, 1, 1), 1, 1);    // a closed door: lower to 1, upper above
  expectHeights(portalHeights(0, 3, 5, 6), 3, 3);    // all lower
  expectHeights(portalHeights(0, 3, -6, -5), 0, 0);  // all upper
  expectHeights(portalHeights(0, 3, 3, 6), 3, 3);
}

/// "0..1 lower step, 1..2 opening, ..." of the first portal wall of the first sector.
std::string piecesOf(const LoadedLevel& loaded, std::size_t segment) {
  const Scene scene = loaded.scene();
  std::string text;
  for (const WallPiece& piece : scene.piecesOf(scene[SegmentId(segment)])) {
    const SurfaceId* surface = std::get_if<SurfaceId>(&piece.content);
    text += fmt::format("{}{}..{} {}", text.empty() ? "" : ", ", piece.zBottom, piece.zTop,
                        surface ? name(scene[*surface].kind) : "opening");
  }
  return text;
}

LoadedLevel twoRooms(std::string_view wall, double floor, double ceiling,
                     std::string_view moreOfSecond = "") {
  return levelFrom(fmt::format(
      "{{'light':1,'sectors':{{{},{}}}}}",
      sectorText("west", "0,0, 6,0, 6,4, 0,4", 0, 3,
                 fmt::format("[{0},{1},{0},{0}]", kSolid, wall)),
      sectorText("east", "6,0, 10,0, 10,4, 6,4", floor, ceiling,
                 fmt::format("[{0},{0},{0},{{'next':'west','texture':'#808080'}}]", kSolid),
                 moreOfSecond)));
}

constexpr std::string_view kPortal = "{'next':'east','texture':'#808080'}";

TEST(Pieces, ofAPortalAreStepOpeningStep) {
  EXPECT_EQ(piecesOf(twoRooms(kPortal, 1, 2), 1), "0..1 lower step, 1..2 opening, 2..3 upper step");
}

TEST(Pieces, thatDoNotExistAreNotModelled) {
  EXPECT_EQ(piecesOf(twoRooms(kPortal, 0, 3), 1), "0..3 opening");
  EXPECT_EQ(piecesOf(twoRooms(kPortal, -2, 5), 1), "0..3 opening");
  EXPECT_EQ(piecesOf(twoRooms(kPortal, 1.5, 1.5), 1), "0..1.5 lower step, 1.5..3 upper step");
}

TEST(Pieces, ofAStackKeepToTheirRanges) {
  const std::string_view stack =
      "{'walls':[{'z':0.5,'texture':'#808080'},{'z':2,'next':'east','texture':'#808080'},"
      "{'texture':'#808080'}]}";
  EXPECT_EQ(piecesOf(twoRooms(stack, 1, 1.75), 1),
            "0..0.5 stack solid, 0.5..1 stack lower step, 1..1.75 opening, 1.75..2 stack upper "
            "step, 2..3 stack solid");
}

TEST(Pieces, behindTheSectorsOwnSlopeNeedNoTexture) {
  const LoadedLevel rooms =
      levelFrom(fmt::format("{{'light':1,'sectors':{{{},{}}}}}",
                            sectorText("ramp", "0,0, 6,0, 6,4, 0,4", 0, 3,
                                       fmt::format("[{0},{{'next':'landing'}},{0},{0}]", kSolid),
                                       ",'slopeFloor':{'z':[0,1,1,0]}"),
                            sectorText("landing", "6,0, 10,0, 10,4, 6,4", 1, 3,
                                       fmt::format("[{0},{0},{0},{{'next':'ramp'}}]", kSolid))));
  EXPECT_EQ(piecesOf(rooms, 1), "1..3 opening");
}

TEST(Sidewalls, showOnlyWhereTheWedgeStandsInTheOpening) {
  const auto sidewalls = [](const LoadedLevel& loaded) {
    int count = 0;
    for (const SurfaceId id : loaded.scene().shownSurfaces())
      count += isSidewall(loaded.level[id].kind) ? 1 : 0;
    return count;
  };
  EXPECT_EQ(
      sidewalls(twoRooms(kPortal, 0, 3, ",'slopeFloor':{'z':[1,0,0,1],'sidewall':'#808080'}")), 1);
  EXPECT_EQ(sidewalls(twoRooms(kPortal, 0, 3, ",'slopeFloor':{'z':[0,1,1,0]}")), 0)
      << "nothing of the wedge stands at the portal";
  EXPECT_EQ(sidewalls(twoRooms(kPortal, -2, 3, ",'slopeFloor':{'z':[2,0,0,2]}")), 0)
      << "the wedge ends where the opening begins";
}

TEST(LightOpenings, haveNoTopBetweenSkies) {
  const std::string text = fmt::format(
      "{{'light':1,'sectors':{{'a':{{'ceiling':{{'z':3,'texture':'#808080','parallax':true}},"
      "'floor':{{'texture':'#808080'}},'loops':{{'border':{{'v':[0,0, 6,0, 6,4, 0,4],'walls':[{0},"
      "{{'next':'b'}},{0},{0}]}}}}}},'b':{{'ceiling':{{'z':2,'texture':'#808080','parallax':true}},"
      "'floor':{{'z':0.5,'texture':'#808080'}},'loops':{{'border':{{'v':[6,0, 10,0, 10,4, 6,4],"
      "'walls':[{0},{0},{0},{{'next':'a'}}]}}}}}}}}}}",
      kSolid);
  std::string withStep = text;
  withStep.replace(withStep.find("{'next':'b'}"), 12, "{'next':'b','lower':'#808080'}");
  const LoadedLevel rooms = levelFrom(withStep);
  const auto openings = rooms.scene().lightOpeningsOf(rooms.level.segments[1]);
  ASSERT_EQ(openings.size(), 1U);
  EXPECT_EQ(openings[0].zBottom, 0.5);
  EXPECT_EQ(openings[0].zTop, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace hearth
