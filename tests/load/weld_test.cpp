#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "load_text.h"

/// Outlines of linked sectors fit together exactly, however their files split and round them.
namespace hearth {
namespace {

std::vector<Segment> segmentsOf(const Level& level, std::string_view name) {
  const auto segments = level.segmentsOf(sectorNamed(level, name));
  return {segments.begin(), segments.end()};
}

/// Those that one authored wall became.
std::vector<Segment> piecesOf(const Level& level, std::string_view sector, std::uint32_t wall) {
  std::vector<Segment> pieces;
  for (const Segment& segment : segmentsOf(level, sector))
    if (segment.wallIndex == wall) pieces.push_back(segment);
  return pieces;
}

constexpr std::string_view kPlain = "{'texture': '#808080'}";

std::string wallList(std::initializer_list<std::string_view> walls) {
  std::string text = "[";
  for (const std::string_view wall : walls) {
    if (text.size() > 1) text += ", ";
    text += wall;
  }
  return text + "]";
}

TEST(Weld, splitsAPortalWhereTheOtherSideHasVertices) {
  const LoadedLevel loaded = loadSectors(
      sectorText("a", "0,0, 4,0, 4,4, 0,4", wallList({kPlain, "{'next': 'b'}", kPlain, kPlain})) +
      "," +
      sectorText(
          "b", "4,0, 8,0, 8,4, 4,4, 4,3, 4,1",
          wallList({kPlain, kPlain, kPlain, "{'next': 'a'}", "{'next': 'a'}", "{'next': 'a'}"})));
  const Level& level = loaded.level;
  expectTwins(loaded.scene());
  const std::vector<Segment> pieces = piecesOf(level, "a", 1);
  ASSERT_EQ(pieces.size(), 3U);
  const double s[] = {0, 1, 3, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pieces[i].p0, (Vec2{4, s[i]}));
    EXPECT_EQ(pieces[i].p1, (Vec2{4, s[i + 1]}));
    EXPECT_EQ(pieces[i].sBefore, s[i]);
    EXPECT_EQ(pieces[i].sAfter, 4 - s[i + 1]);
    EXPECT_TRUE(std::holds_alternative<Portal>(pieces[i].wall));
  }
  EXPECT_EQ(segmentsOf(level, "b").size(), 6U);
}

TEST(Weld, fitsASlantedWallWithARoundedVertexAtOneThird) {
  const LoadedLevel loaded = loadSectors(
      sectorText("a", "0,0, 10,7, 0,7", wallList({"{'next': 'b'}", kPlain, kPlain})) + "," +
      sectorText("b", "0,0, 10,0, 10,7, 3.3333333333333335,2.3333333333333335",
                 wallList({kPlain, kPlain, "{'next': 'a'}", "{'next': 'a'}"})));
  const Level& level = loaded.level;
  expectTwins(loaded.scene());
  const std::vector<Segment> pieces = piecesOf(level, "a", 0);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].p1, (Vec2{10.0 / 3, 7.0 / 3}));
  const double length = std::sqrt(149.0);
  EXPECT_NEAR(pieces[1].sBefore, length / 3, 1e-12);
  for (const Segment& piece : pieces)
    EXPECT_NEAR(piece.sBefore + piece.length + piece.sAfter, length, 1e-12);
}

TEST(Weld, givesVerticesHalfAMillimetreApartTheCoordinatesOfTheFirstSector) {
  const LoadedLevel loaded = loadSectors(
      sectorText("a", "0,0, 4,0, 4,4, 0,4", wallList({kPlain, "{'next': 'b'}", kPlain, kPlain})) +
      "," +
      sectorText("b", "4.0005,0, 8,0, 8,4, 4.0003,4.0004, 3.9996,2",
                 wallList({kPlain, kPlain, kPlain, "{'next': 'a'}", "{'next': 'a'}"})));
  const Level& level = loaded.level;
  expectTwins(loaded.scene());
  const std::vector<Segment> b = segmentsOf(level, "b");
  EXPECT_EQ(b[0].p0, (Vec2{4, 0}));
  EXPECT_EQ(b[3].p0, (Vec2{4, 4}));
  EXPECT_EQ(b[4].p0, (Vec2{3.9996, 2}));
  EXPECT_EQ(piecesOf(level, "a", 1)[0].p1, (Vec2{3.9996, 2}));
}

TEST(Weld, measuresItsToleranceByTheShortestEdgeWhereThatIsLess) {
  // A room of 4 mm: its noise is 4 micrometres.
  const auto room = [](std::string_view x) {
    return "{'light': 1, 'sectors': {" +
           sectorText("a", "0,0, 0.004,0, 0.004,0.004, 0,0.004",
                      wallList({kPlain, "{'next': 'b'}", kPlain, kPlain})) +
           "," +
           sectorText("b",
                      std::string(x) + ",0, 0.008,0, 0.008,0.004, " + std::string(x) + ",0.004",
                      wallList({kPlain, kPlain, kPlain, "{'next': 'a'}"})) +
           "}}";
  };
  EXPECT_TRUE(loadText(room("0.004003")).loaded);
  EXPECT_FALSE(loadText(room("0.0045")).loaded);
}

TEST(Weld, handsASplitOnThroughAStackToTheWallOnItsOtherSide) {
  // Seen from b, one wall is a stack that leads to a below and to c above; only c is split.
  const LoadedLevel loaded = loadSectors(
      sectorText("a", "0,0, 4,0, 4,3, 0,3",
                 wallList({kPlain, "{'next': 'b', 'texture': '#808080'}", kPlain, kPlain}),
                 "'ceiling': {'z': 2, 'texture': '#404040'}") +
      "," +
      sectorText(
          "b", "4,0, 8,0, 8,3, 4,3",
          wallList({kPlain, kPlain, kPlain, "{'walls': [{'z': 2, 'next': 'a'}, {'next': 'c'}]}"})) +
      "," +
      sectorText("c", "0,0, 4,0, 4,1, 4,3, 0,3",
                 wallList({kPlain, "{'next': 'b', 'texture': '#808080'}",
                           "{'next': 'b', 'texture': '#808080'}", kPlain, kPlain}),
                 "'floor': {'z': 2, 'texture': '#404040'}"));
  const Level& level = loaded.level;
  expectTwins(loaded.scene());
  EXPECT_EQ(piecesOf(level, "b", 3).size(), 2U);
  EXPECT_EQ(piecesOf(level, "a", 1).size(), 2U);
  EXPECT_EQ(piecesOf(level, "c", 1).size(), 1U);
}

TEST(Weld, splitsAStackWhereItsTwoNextSectorsSplitDifferently) {
  const LoadedLevel loaded = loadSectors(
      sectorText("a", "0,0, 4,0, 4,1.5, 4,3, 0,3",
                 wallList({kPlain, "{'next': 'b', 'texture': '#808080'}",
                           "{'next': 'b', 'texture': '#808080'}", kPlain, kPlain}),
                 "'ceiling': {'z': 2, 'texture': '#404040'}") +
      "," +
      sectorText(
          "b", "4,0, 8,0, 8,3, 4,3",
          wallList({kPlain, kPlain, kPlain, "{'walls': [{'z': 2, 'next': 'a'}, {'next': 'c'}]}"})) +
      "," +
      sectorText("c", "0,0, 4,0, 4,1, 4,2, 4,3, 0,3",
                 wallList({kPlain, "{'next': 'b', 'texture': '#808080'}",
                           "{'next': 'b', 'texture': '#808080'}",
                           "{'next': 'b', 'texture': '#808080'}", kPlain, kPlain}),
                 "'floor': {'z': 2, 'texture': '#404040'}"));
  const Level& level = loaded.level;
  expectTwins(loaded.scene());
  const std::vector<Segment> pieces = piecesOf(level, "b", 3);
  ASSERT_EQ(pieces.size(), 4U);
  EXPECT_EQ(pieces[0].p1, (Vec2{4, 2}));
  EXPECT_EQ(pieces[1].p1, (Vec2{4, 1.5}));
  EXPECT_EQ(pieces[2].p1, (Vec2{4, 1}));
}

TEST(Weld, cutsAWallWhereAHoleOfItsSectorTouchesIt) {
  const Level level = loadText(
                          "{'light': 1, 'sectors': {'a': {'floor': {'texture': '#808080'},"
                          "'ceiling': {'texture': '#404040'}, 'loops': {"
                          "'border': {'v': [0,0, 9,6, 0,6], 'walls': {'texture': '#808080'}},"
                          "'hole': {'v': [3,2, 2,3, 3,4], 'walls': {'texture': '#808080'}}}}}}")
                          .loaded.value()
                          .level;
  const std::vector<Segment> pieces = piecesOf(level, "a", 0);
  EXPECT_EQ(pieces[0].p1, (Vec2{3, 2}));
  EXPECT_EQ(pieces[1].p0, (Vec2{3, 2}));
}

TEST(Weld, cutsBothSidesOfAFlatPortalAlike) {
  const Level level =
      loadSectors(sectorText("up", "0,0, 4,0, 4,2, 4,4, 0,4", kPlain,
                             "'floor': {'z': 4, 'next': 'up-down'}, 'ceiling': {'z': 8, "
                             "'texture': '#404040'}") +
                  "," +
                  sectorText("down", "0.0004,0, 4,0, 4,4, 0,4", kPlain,
                             "'ceiling': {'z': 4.0005, 'next': 'up-down'}"))
          .level;
  EXPECT_EQ(segmentsOf(level, "up").size(), 5U);
  EXPECT_EQ(segmentsOf(level, "down").size(), 5U);
  EXPECT_EQ(segmentsOf(level, "down")[0].p0, (Vec2{0, 0}));
  EXPECT_EQ(sectorNamed(level, "down").ceiling.z, 4.0);
}

/// A grid of rooms, in each of which every vertex is off by up to 0.19 mm along each axis (two by
/// 0.54 mm; the shortest walls, of 0.57 m, allow 0.57 mm) and every wall is cut at
/// random places, independently of what its neighbour does.
class JitteredGrid {
 public:
  explicit JitteredGrid(unsigned seed) : random_(seed) {}

  std::string text() {
    std::string sectors;
    for (int y = 0; y < kRooms; ++y)
      for (int x = 0; x < kRooms; ++x) append(sectors, room(x, y));
    return sectors;
  }

 private:
  static constexpr int kRooms = 5;
  static constexpr double kJitter = 1.9e-4;

  double fraction() { return static_cast<double>(random_()) / 4294967296.0; }

  /// Corner (x, y) of a slanted grid.
  static Vec2 corner(double x, double y) { return {3.1 * x - 1.7 * y, 0.9 * x + 2.3 * y}; }

  std::string vertex(Vec2 p) {
    const auto jittered = [&](double value) { return value + kJitter * (2 * fraction() - 1); };
    const double x = jittered(p.x);
    return fmt::format("{},{}", x, jittered(p.y));
  }

  std::string room(int x, int y) {
    constexpr int kSide[4][4] = {{0, 0, 0, -1}, {1, 0, 1, 0}, {1, 1, 0, 1}, {0, 1, -1, 0}};
    std::string vertices;
    std::string walls;
    for (int side = 0; side < 4; ++side) {
      const int nextX = x + kSide[side][2];
      const int nextY = y + kSide[side][3];
      const bool isInside = nextX >= 0 && nextX < kRooms && nextY >= 0 && nextY < kRooms;
      const std::string wall =
          isInside ? fmt::format("{{'next': '{}'}}", name(nextX, nextY)) : std::string(kPlain);
      const Vec2 from = corner(x + kSide[side][0], y + kSide[side][1]);
      const Vec2 to = corner(x + kSide[(side + 1) % 4][0], y + kSide[(side + 1) % 4][1]);
      const auto cuts = static_cast<int>(3 * fraction());
      for (int cut = 0; cut <= cuts; ++cut) {
        const double s = cut == 0 ? 0 : (cut - 0.4 + 0.3 * fraction()) / (cuts + 1);
        append(vertices, vertex(lerp(from, to, s)));
        append(walls, wall);
      }
    }
    return sectorText(name(x, y), vertices, fmt::format("[{}]", walls));
  }

  static void append(std::string& list, std::string_view item) {
    if (!list.empty()) list += ", ";
    list += item;
  }

  static std::string name(int x, int y) { return fmt::format("r{}{}", x, y); }

  std::mt19937 random_;
};

TEST(Weld, fitsGridsWhoseVerticesAreAllOffByLessThanAMillimetre) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const LoadResult result =
        loadText(fmt::format("{{'light': 1, 'sectors': {{{}}}}}", JitteredGrid(seed).text()));
    ASSERT_TRUE(result.loaded) << listed(result);
    EXPECT_EQ(result.diagnostics.size(), 0U) << listed(result);
    expectTwins(result.loaded->scene());
  }
}

}  // namespace
}  // namespace hearth
