// Where surfaces of one plane meet at a portal: what light each takes beside the seam.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::sectorText;

constexpr std::string_view kSolid = "{'texture':'#808080'}";

std::string levelOf(const std::string& sectors) {
  return fmt::format("{{'light': 0, 'sectors': {{{}}}}}", sectors);
}

/// "open", 0 <= x <= xPortal, looks through the wall `portal` into "closed", which goes on to x = 4
/// and has the wall `back` there. Both have walls along y = 0, which run from "open" to "closed",
/// and along y = 2, which run the other way.
std::string rooms(double xPortal, std::string_view portal, std::string_view back) {
  return levelOf(sectorText("open", fmt::format("0,0, {0},0, {0},2, 0,2", xPortal), 0, 3,
                            fmt::format("[{0},{1},{0},{0}]", kSolid, portal)) +
                 "," +
                 sectorText("closed", fmt::format("{0},0, 4,0, 4,2, {0},2", xPortal), 0, 3,
                            fmt::format("[{0},{0},{0},{1}]", kSolid, back)));
}

/// Between two texels' centres, and on one: then samples lie on the shared vertices.
constexpr double kPortals[] = {2, 2.0625};

constexpr std::string_view kLightInOpen = "[{'x':1,'y':1.1,'z':1.2,'intensity':200}]";
constexpr std::string_view kLightInClosed = "[{'x':3,'y':1.1,'z':1.2,'intensity':200}]";

/// Metres.
struct Span {
  double from;
  double to;
};

/// Expects one level all over a part of both walls of a sector that run along x.
void expectOnBothWalls(const BakedRoom& baked, std::string_view sector, Span x, Span z,
                       double level) {
  for (const double y : {0.0, 2.0})
    for (double at = x.from; at < x.to; at += 0.0217)
      for (double height = z.from; height < z.to; height += 0.0431)
        EXPECT_EQ(baked.at(SurfaceKind::Solid, {at, y, height}, sector), level)
            << sector << ' ' << at << ' ' << y << ' ' << height;
}

TEST(Seam, atAOneWayPortalIsNotDarkenedFromTheSideThatDoesNotLookBack) {
  for (const double x : kPortals) {
    const std::string level = rooms(x, "{'next':'closed'}", kSolid);
    const BakedRoom fromOpen(level, kLightInOpen);
    expectOnBothWalls(fromOpen, "open", {0.01, x}, {0, 3}, 200);
    expectOnBothWalls(fromOpen, "closed", {x + 1e-5, 4}, {0, 3}, 200);
    const BakedRoom fromClosed(level, kLightInClosed);
    expectOnBothWalls(fromClosed, "closed", {x + 1e-5, 4}, {0, 3}, 200);
    expectOnBothWalls(fromClosed, "open", {0.01, x - 0.125}, {0, 3}, 0);
  }
}

std::string stackTo(std::string_view next) {
  return fmt::format(
      "{{'walls':[{{'z':0.9,'next':'{0}'}},{{'z':1.6,'texture':'#808080'}},{{'next':'{0}'}}]}}",
      next);
}

TEST(Seam, besideAStackIsLitAsBesideAPlainWall) {
  for (const double x : kPortals)
    for (const std::string& back : {std::string(kSolid), stackTo("open")}) {
      const BakedRoom baked(rooms(x, stackTo("closed"), back), kLightInOpen);
      expectOnBothWalls(baked, "open", {0.01, x}, {0, 3}, 200);
    }
}

TEST(Seam, takesNothingFromBehindTheSolidPieceOfAStack) {
  // The lowest and the topmost texels that the solid piece touches are lit from its edges.
  constexpr Span kSolidPiece{1.0625, 1.4375};
  for (const double x : kPortals) {
    const BakedRoom baked(rooms(x, stackTo("closed"), kSolid), kLightInClosed);
    expectOnBothWalls(baked, "open", {0.01, x}, kSolidPiece, 0);
  }
}

TEST(Seam, besideAOneWayStackInOnePlaneIsLitOnItsOwnSideOnly) {
  // Walls at x = 2: "open" sees its own and, for 0 < y < 2, the stack. "closed" sees a solid wall
  // all along, which faces away from the light.
  const BakedRoom baked(
      levelOf(sectorText("open", "0,-1, 2,-1, 2,0, 2,2, 2,3, 0,3", 0, 3,
                         fmt::format("[{0},{0},{1},{0},{0},{0}]", kSolid, stackTo("closed"))) +
              "," + sectorText("closed", "2,-1, 4,-1, 4,3, 2,3, 2,2, 2,0", 0, 3)),
      kLightInOpen);
  for (double z = 0.01; z < 3; z += 0.0431) {
    for (double y = -0.99; y < 3; y += 0.0217) {
      EXPECT_EQ(baked.at(SurfaceKind::Solid, {2, y, z}, "closed"), 0) << y << ' ' << z;
      const bool isBeside = y < 0 || y > 2;
      if (isBeside || (z > 0.9 && z < 1.6)) {
        const SurfaceKind kind = isBeside ? SurfaceKind::Solid : SurfaceKind::StackSolid;
        EXPECT_EQ(baked.at(kind, {2, y, z}, "open"), 200) << y << ' ' << z;
      }
    }
  }
}

}  // namespace
}  // namespace hearth
