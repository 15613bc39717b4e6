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

/// A turned room.
class Shaft {
 public:
  Vec3 at(double x, double y, double z) const {
    return {3 + cos_ * x - sin_ * y, 1 + sin_ * x + cos_ * y, z};
  }

  std::string sector(std::string_view name, std::string_view floor,
                     std::string_view ceiling) const {
    std::string vertices;
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{kWidth, 0}, Vec2{kWidth, kDepth}, Vec2{0, kDepth}}) {
      const Vec3 p = at(corner.x, corner.y, 0);
      vertices += fmt::format("{}{},{}", vertices.empty() ? "" : ", ", p.x, p.y);
    }
    return fmt::format(
        "'{}':{{'floor':{},'ceiling':{},'loops':{{'border':{{'v':[{}],'walls':{}}}}}}}", name,
        floor, ceiling, vertices, kSolid);
  }

  static constexpr double kWidth = 3.1;
  static constexpr double kDepth = 2.3;

 private:
  static constexpr double kTurn = 17 * std::numbers::pi / 180;
  double cos_ = std::cos(kTurn);
  double sin_ = std::sin(kTurn);
};

TEST(Seam, atAFlatPortalOfATurnedRoomDoesNotShow) {
  const Shaft shaft;
  constexpr std::string_view kFlat = "{{'z':{},'texture':'#808080'}}";
  const std::string floor = fmt::format(kFlat, 0);
  const std::string ceiling = fmt::format(kFlat, 3);
  const Vec3 light = shaft.at(0.9, 1.4, 0.8);
  const std::string lights =
      fmt::format("[{{'x':{},'y':{},'z':{},'falloff':0.5}}]", light.x, light.y, light.z);
  const BakedRoom whole(levelOf(shaft.sector("whole", floor, ceiling)), lights);
  // Through the centres of a row of texels, and between them; at and above the light.
  for (const double row : {6.4, 9.5, 10.5, 11.5, 12.5, 12.74}) {
    const std::string portal = fmt::format("{{'z':{},'next':'up-low'}}", row / 8);
    const BakedRoom cut(
        levelOf(shaft.sector("up", portal, ceiling) + "," + shaft.sector("low", floor, portal)),
        lights);
    for (double z = 0.01; z < 3; z += 0.0213)
      for (double fraction = 0.003; fraction < 1; fraction += 0.0271)
        for (const Vec3 p : {shaft.at(fraction * Shaft::kWidth, 0, z),
                             shaft.at(fraction * Shaft::kWidth, Shaft::kDepth, z),
                             shaft.at(0, fraction * Shaft::kDepth, z),
                             shaft.at(Shaft::kWidth, fraction * Shaft::kDepth, z)})
          EXPECT_NEAR(cut.at(SurfaceKind::Solid, p), whole.at(SurfaceKind::Solid, p), 1e-9)
              << row << ' ' << p.x << ' ' << p.y << ' ' << z;
  }
}

}  // namespace
}  // namespace hearth
