#include "import/doom/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "map_builder.h"

namespace hearth::doom {

namespace {

class RegionsOfAMap : public testing::Test, protected MapBuilder {
 protected:
  const std::vector<Region>& find() {
    findings_.clear();
    regions_ = findRegions(map, starters_, findings_).value();
    return regions_.regions;
  }

  /// Square metres; more than 0 where the loop runs clockwise on a map with y down.
  double areaOf(const std::vector<std::uint32_t>& loop) const {
    double area = 0;
    for (const std::uint32_t h : loop)
      area += cross(regions_.halfEdges[h].from, regions_.halfEdges[h].to) / 2;
    return area;
  }

  /// Of a region without its holes.
  double areaOf(const Region& region) const {
    double area = 0;
    for (const auto& loop : region.loops) area += areaOf(loop);
    return area;
  }

  std::multiset<std::pair<std::uint32_t, double>> sectorsAndAreas() const {
    std::multiset<std::pair<std::uint32_t, double>> all;
    for (const Region& region : regions_.regions) all.emplace(region.sector, areaOf(region));
    return all;
  }

  /// All that holds of loops of any map.
  void expectSoundLoops() const {
    for (const Region& region : regions_.regions) {
      for (std::size_t i = 0; i < region.loops.size(); ++i) {
        const auto& loop = region.loops[i];
        EXPECT_EQ(areaOf(loop) > 0, i == 0) << "only the border runs clockwise";
        std::set<std::pair<double, double>> points;
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const HalfEdge& edge = regions_.halfEdges[loop[k]];
          EXPECT_EQ(edge.to, regions_.halfEdges[loop[(k + 1) % loop.size()]].from);
          EXPECT_TRUE(points.emplace(edge.from.x, edge.from.y).second) << "a point comes twice";
        }
      }
    }
  }

  std::size_t countOf(Outcome outcome, std::size_t line) const {
    return static_cast<std::size_t>(std::ranges::count_if(findings_, [&](const Finding& finding) {
      return finding.outcome == outcome && finding.part == Part::Line && finding.number == line;
    }));
  }

  Regions regions_;
  std::set<std::uint32_t> starters_;
  Findings findings_;
};

TEST_F(RegionsOfAMap, aRoomIsOneOfTheAreaThatItsWallsEnclose) {
  walls(sector(), square(0, 0, 64));
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(areaOf(find()[0]), 4);
  EXPECT_EQ(find()[0].loops[0].size(), 4U);
  expectSoundLoops();
  EXPECT_TRUE(findings_.empty());
}

TEST_F(RegionsOfAMap, roomsBesideEachOtherShareTheLineBetweenThem) {
  const auto a = sector();
  const auto b = sector();
  for (const auto& [from, to] :
       {std::pair{Vertex{64, 0}, Vertex{0, 0}}, {{0, 0}, {0, 64}}, {{0, 64}, {64, 64}}})
    line(from, to, a);
  line({64, 64}, {64, 0}, a, b);
  for (const auto& [from, to] :
       {std::pair{Vertex{64, 64}, Vertex{128, 64}}, {{128, 64}, {128, 0}}, {{128, 0}, {64, 0}}})
    line(from, to, b);
  ASSERT_EQ(find().size(), 2U);
  const auto& loop = regions_.regions[a].loops[0];
  const auto open = std::ranges::count_if(
      loop, [&](std::uint32_t h) { return regions_.halfEdges[Regions::twinOf(h)].region == b; });
  EXPECT_EQ(open, 1);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, partsOfASectorThatLieApartAreTwo) {
  const auto both = sector();
  walls(both, square(0, 0, 64));
  walls(both, square(256, 0, 32));
  find();
  EXPECT_EQ(sectorsAndAreas(), (std::multiset<std::pair<std::uint32_t, double>>{{0, 4}, {0, 1}}));
}

TEST_F(RegionsOfAMap, partsOfASectorAreTwoOnlyWhereSomethingHangsBetweenThem) {
  const auto both = sector();
  walls(both, {{0, 0}, {0, 64}, {64, 64}, {128, 64}, {128, 0}, {64, 0}});
  const Line& fence = line({64, 64}, {64, 0}, both, both);
  EXPECT_EQ(find().size(), 1U);
  sideOf(fence).middle = "FENCE";
  EXPECT_EQ(find().size(), 2U);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, partsOfASectorThatTouchInAPointAreTwo) {
  const auto both = sector();
  walls(both, square(0, 0, 64));
  walls(both, square(64, 64, 64));
  EXPECT_EQ(find().size(), 2U);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, aPillarIsAHole) {
  const auto room = sector();
  walls(room, square(0, 0, 128));
  for (auto corners = square(32, 32, 32); const std::size_t i : {3U, 2U, 1U, 0U})
    line(corners[i], corners[(i + 3) % 4], room);
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(find()[0].loops.size(), 2U);
  EXPECT_EQ(areaOf(find()[0]), 15);
  EXPECT_EQ(regions_.regionAt(placeOf(48, 48)), std::nullopt);
  EXPECT_EQ(regions_.regionAt(placeOf(16, 48)), 0U);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, aPillarThatTouchesTheWallInAPointIsAHoleBesideIt) {
  const auto room = sector();
  walls(room, {{0, 0}, {0, 64}, {0, 128}, {128, 128}, {128, 0}});
  line({0, 64}, {32, 32}, room);
  line({32, 32}, {32, 96}, room);
  line({32, 96}, {0, 64}, room);
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(find()[0].loops.size(), 2U);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, pillarsThatTouchInAPointAreTwoHoles) {
  const auto room = sector();
  walls(room, square(0, 0, 256));
  for (const auto& corners : {square(64, 64, 32), square(96, 96, 32)})
    for (const std::size_t i : {3U, 2U, 1U, 0U}) line(corners[i], corners[(i + 3) % 4], room);
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(find()[0].loops.size(), 3U);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, aRoomInARoomInARoomLiesInTheRightOne) {
  const auto outer = sector();
  const auto middle = sector();
  const auto inner = sector();
  walls(outer, square(0, 0, 256));
  for (const auto& [corners, out, in] :
       {std::tuple{square(32, 32, 192), outer, middle}, {square(64, 64, 128), middle, inner}})
    for (std::size_t i = 0; i < 4; ++i) line(corners[i], corners[(i + 1) % 4], in, out);
  find();
  EXPECT_EQ(sectorsAndAreas(), (std::multiset<std::pair<std::uint32_t, double>>{
                                   {outer, 64 - 36}, {middle, 36 - 16}, {inner, 16}}));
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, aLineInARoomThatDividesNothingIsLeftOut) {
  const auto room = sector();
  walls(room, square(0, 0, 128));
  line({32, 32}, {96, 32}, room, room);
  line({32, 64}, {96, 64}, room);
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(find()[0].loops.size(), 1U);
  EXPECT_EQ(countOf(Outcome::Dropped, 4), 0U) << "both sides say the same";
  EXPECT_EQ(countOf(Outcome::Dropped, 5), 1U);
}

TEST_F(RegionsOfAMap, aLineFromWallToWallOfOneSectorDividesNothing) {
  const auto room = sector();
  walls(room, {{0, 0}, {0, 64}, {64, 64}, {128, 64}, {128, 0}, {64, 0}});
  line({64, 0}, {64, 64}, room, room);
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(areaOf(find()[0]), 8);
}

TEST_F(RegionsOfAMap, linesWithoutWallsBetweenThemAndTheRoomMakeASectorOfTheirOwn) {
  const auto room = sector();
  const auto pit = sector(-64);
  walls(room, square(0, 0, 256));
  const auto corners = square(64, 64, 64);
  for (std::size_t i = 0; i < 4; ++i) line(corners[i], corners[(i + 1) % 4], pit, pit);
  ASSERT_EQ(find().size(), 2U);
  EXPECT_EQ(regions_.regions[*regions_.regionAt(placeOf(96, 96))].sector, pit);
  EXPECT_EQ(regions_.regions[*regions_.regionAt(placeOf(16, 16))].sector, room);
}

TEST_F(RegionsOfAMap, aSectorThatIsNotClosedIsNone) {
  const auto open = sector();
  line({0, 0}, {0, 64}, open);
  line({0, 64}, {64, 64}, open);
  line({64, 64}, {64, 0}, open);
  EXPECT_TRUE(find().empty());
  EXPECT_EQ(findings_.size(), 3U);
}

TEST_F(RegionsOfAMap, aSideThatNamesAnotherSectorThanTheRestOfTheOutlineIsOverruled) {
  const auto room = sector();
  const auto other = sector();
  walls(room, square(0, 0, 128));
  map.sides[2].sector = other;
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(find()[0].sector, room);
  EXPECT_EQ(countOf(Outcome::Repaired, 2), 1U);
}

TEST_F(RegionsOfAMap, aPointAsHighAsACornerToItsLeftLiesInTheRegionBetween) {
  const auto wedge = sector();
  const auto room = sector();
  walls(room, {{60, 0}, {0, 64}, {0, 128}, {200, 128}, {200, 0}});
  walls(wedge, {{0, 64}, {60, 0}, {10, 0}});
  find();
  EXPECT_EQ(regions_.regions[*regions_.regionAt(placeOf(100, 64))].sector, room);
  EXPECT_EQ(regions_.regions[*regions_.regionAt(placeOf(20, 16))].sector, wedge);
}

TEST_F(RegionsOfAMap, aLineWithinASectorDividesItOnlyWhereItStartsSomething) {
  const auto a = sector();
  walls(a, {{0, 0}, {0, 64}, {0, 128}, {128, 128}, {128, 64}, {128, 0}});
  line({0, 64}, {128, 64}, a, a);
  EXPECT_EQ(find().size(), 1U);
  starters_ = {6};
  EXPECT_EQ(find().size(), 2U);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, aLineThatStartsSomethingAndEndsInsideIsASideOfASliver) {
  const auto a = sector();
  walls(a, square(0, 0, 128));
  line({4, 64}, {124, 64}, a, a);
  EXPECT_EQ(find().size(), 1U);
  starters_ = {4};
  ASSERT_EQ(find().size(), 2U);
  expectSoundLoops();
  const double sliver = 120.0 / 32 / 32;
  EXPECT_EQ(sectorsAndAreas(),
            (std::multiset<std::pair<std::uint32_t, double>>{{a, 16 - sliver}, {a, sliver}}));
  EXPECT_TRUE(findings_.empty());
}

TEST_F(RegionsOfAMap, aSliverIsCutWhereItMeetsWalls) {
  const auto a = sector();
  walls(a, square(0, 0, 128));
  line({64, 64}, {64, 128}, a, a);
  line({4, 64}, {124, 66}, a, a);
  starters_ = {4, 5};
  EXPECT_GE(find().size(), 3U);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, linesThatMeetNearlyInAPointMeetInIt) {
  const auto a = sector();
  walls(a, square(0, 0, 1000));
  line({0, 0}, {1000, 999}, a, a);
  line({0, 1}, {999, 1000}, a, a);
  line({500, 0}, {499, 1000}, a, a);
  for (Side& side : map.sides) side.middle = "FENCE";
  find();
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, linesAreCutWhereTheyCross) {
  const auto a = sector();
  walls(a, square(0, 0, 128));
  walls(a, square(96, 96, 128));
  find();
  EXPECT_EQ(sectorsAndAreas(),
            (std::multiset<std::pair<std::uint32_t, double>>{{a, 15}, {a, 1}, {a, 15}}));
  EXPECT_EQ(findings_.size(), 2U);
  expectSoundLoops();
}

TEST_F(RegionsOfAMap, aGridOfManyLinesIsNotCutWithoutEnd) {
  const auto room = sector();
  for (int i = 0; i < 300; ++i) {
    line({i, -1}, {i, 301}, room);
    line({-1, i}, {301, i}, room);
  }
  const auto found = findRegions(map, starters_, findings_);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error(), "its lines cross in more than 50000 places: too many to cut them there");
}

TEST_F(RegionsOfAMap, linesOnOneAnotherAreNotCutWithoutEnd) {
  const auto room = sector();
  for (int i = 0; i < 800; ++i) line({i, 0}, {2000 - i, 0}, room);
  const auto found = findRegions(map, starters_, findings_);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error(),
            "its lines meet so often that they would have to be cut into more than 250000 pieces");
  EXPECT_LT(findings_.size(), 250'000U);
}

TEST_F(RegionsOfAMap, aPieceOfALineKnowsHowFarItsLeftEndIs) {
  const auto a = sector();
  const auto b = sector();
  line({0, 0}, {0, 64}, a);
  line({0, 64}, {96, 64}, a);
  line({96, 64}, {96, 0}, a);
  line({96, 0}, {0, 0}, a, b);
  // Its walls end on the line between the two.
  line({64, 0}, {64, -64}, b);
  line({64, -64}, {32, -64}, b);
  line({32, -64}, {32, 0}, b);
  ASSERT_EQ(find().size(), 2U);
  std::multiset<double> fromFront;
  for (const std::uint32_t h : find()[0].loops[0])
    if (const auto& face = regions_.halfEdges[h].face; face->line == 3)
      fromFront.insert(face->along);
  EXPECT_EQ(fromFront, (std::multiset<double>{0, 1, 2}));
  for (const std::uint32_t h : find()[1].loops[0]) {
    const auto& face = regions_.halfEdges[h].face;
    EXPECT_EQ(face->along, face->line == 3 ? 1 : 0) << "seen from behind";
  }
}

TEST_F(RegionsOfAMap, ofTwoLinesInOnePlaceTheFirstCounts) {
  walls(sector(), square(0, 0, 64));
  line({0, 0}, {0, 64}, sector());
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(find()[0].sector, 0U);
  EXPECT_EQ(countOf(Outcome::Repaired, 4), 1U);
}

TEST_F(RegionsOfAMap, aLineWithoutLengthIsLeftOut) {
  const auto room = sector();
  walls(room, square(0, 0, 64));
  line({0, 0}, {0, 0}, room);
  ASSERT_EQ(find().size(), 1U);
  EXPECT_EQ(countOf(Outcome::Dropped, 4), 1U);
}

}  // namespace

}  // namespace hearth::doom
