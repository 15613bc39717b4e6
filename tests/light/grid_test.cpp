// Texel grids: anchored to the plane and not to the piece, so that cutting moves no texel.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "math/trig.h"
#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::sectorText;

constexpr std::string_view kSolid = "{'texture':'#808080'}";
constexpr std::string_view kLights =
    "[{'x':1.3,'y':1.1,'z':2.3,'falloff':0.5},{'x':4.9,'y':3.2,'z':0.7,'falloff':0.9}]";

std::string levelOf(const std::string& sectors) {
  return fmt::format("{{'light': 0, 'sectors': {{{}}}}}", sectors);
}

std::string wholeRoom() {
  return levelOf(sectorText("room", "0.1,0.2, 6.3,0.2, 6.3,4.1, 0.1,4.1", 0, 3));
}

/// Of coordinates only: one texel that differs by one level shows as far more.
constexpr double kRounding = 1e-9;

/// The light of two levels, compared all over the room that both describe.
void expectSameLight(const BakedRoom& a, const BakedRoom& b) {
  for (double x = 0.15; x < 6.3; x += 0.0937)
    for (double y = 0.25; y < 4.1; y += 0.0871) {
      EXPECT_NEAR(a.at(SurfaceKind::Floor, {x, y, 0}), b.at(SurfaceKind::Floor, {x, y, 0}),
                  kRounding)
          << x << ' ' << y;
      EXPECT_NEAR(a.at(SurfaceKind::Ceiling, {x, y, 3}), b.at(SurfaceKind::Ceiling, {x, y, 3}),
                  kRounding)
          << x << ' ' << y;
    }
  for (double x = 0.15; x < 6.3; x += 0.0937)
    for (double z = 0.05; z < 3; z += 0.0871) {
      EXPECT_NEAR(a.at(SurfaceKind::Solid, {x, 0.2, z}), b.at(SurfaceKind::Solid, {x, 0.2, z}),
                  kRounding)
          << x << ' ' << z;
      EXPECT_NEAR(a.at(SurfaceKind::Solid, {x, 4.1, z}), b.at(SurfaceKind::Solid, {x, 4.1, z}),
                  kRounding)
          << x << ' ' << z;
    }
}

TEST(TexelGrid, staysWhenAWallIsCut) {
  const BakedRoom whole(wholeRoom(), kLights);
  const BakedRoom cut(
      levelOf(sectorText("room", "0.1,0.2, 2.77,0.2, 6.3,0.2, 6.3,4.1, 3.33,4.1, 0.1,4.1", 0, 3)),
      kLights);
  expectSameLight(whole, cut);
}

/// The room as two sectors, open to each other from (x0, 0.2) to (x1, 4.1).
std::string roomCutBetween(double x0, double x1) {
  return levelOf(sectorText("west", fmt::format("0.1,0.2, {},0.2, {},4.1, 0.1,4.1", x0, x1), 0, 3,
                            fmt::format("[{0},{{'next':'east'}},{0},{0}]", kSolid)) +
                 "," +
                 sectorText("east", fmt::format("{},0.2, 6.3,0.2, 6.3,4.1, {},4.1", x0, x1), 0, 3,
                            fmt::format("[{0},{0},{0},{{'next':'west'}}]", kSolid)));
}

TEST(TexelGrid, staysWhenASectorIsCut) {
  expectSameLight(BakedRoom(wholeRoom(), kLights), BakedRoom(roomCutBetween(2.7, 3.3), kLights));
}

TEST(TexelGrid, staysWhenASectorIsCutAcrossATexelsCentre) {
  // 2.8125 is a centre of floor texels: samples lie on the very end of the portal. Walls along x
  // have their texels' centres at 0.1 + (i + 1/2) / 8.
  const BakedRoom whole(wholeRoom(), kLights);
  for (const double x : {2.8125, 2.7875})
    expectSameLight(whole, BakedRoom(roomCutBetween(x, x), kLights));
}

/// The room cut at x = 2.6, east of which a wedge makes up floor and ceiling; all of it if `west`
/// has one too.
std::string roomOfWedges(bool west) {
  const std::string_view wedges =
      ", 'slopeFloor':{'z':[0.5,0.5,0.5,0.5],'sidewall':'#808080'}"
      ", 'slopeCeil':{'z':[0.5,0.5,0.5,0.5],'sidewall':'#808080'}";
  if (west)
    return levelOf(
        sectorText("room", "0.1,0.2, 6.3,0.2, 6.3,4.1, 0.1,4.1", -0.5, 3.5, kSolid, wedges));
  return levelOf(
      sectorText("west", "0.1,0.2, 2.6,0.2, 2.6,4.1, 0.1,4.1", 0, 3,
                 fmt::format("[{0},{{'next':'east'}},{0},{0}]", kSolid)) +
      "," +
      sectorText("east", "2.6,0.2, 6.3,0.2, 6.3,4.1, 2.6,4.1", -0.5, 3.5,
                 fmt::format("[{0},{0},{0},{{'next':'west','upper':'#808080','lower':'#808080'}}]",
                             kSolid),
                 wedges));
}

TEST(TexelGrid, goesOnFromAFlatToAWedgeInItsPlane) {
  const BakedRoom flats(wholeRoom(), kLights);
  const BakedRoom wedges(roomOfWedges(true), kLights);
  const BakedRoom both(roomOfWedges(false), kLights);
  const auto expectLightOf = [&](const BakedRoom& whole, SurfaceKind kind, Vec3 p) {
    EXPECT_NEAR(both.at(kind, p), whole.at(kind, p), kRounding) << p.x << ' ' << p.y << ' ' << p.z;
  };
  for (const double x : {2.4, 2.53, 2.59})
    for (double y = 0.25; y < 4.1; y += 0.0871) {
      expectLightOf(flats, SurfaceKind::Floor, {x, y, 0});
      expectLightOf(flats, SurfaceKind::Ceiling, {x, y, 3});
    }
  for (const double x : {2.61, 2.65, 2.8})
    for (double y = 0.25; y < 4.1; y += 0.0871) {
      expectLightOf(wedges, SurfaceKind::SlopeFloor, {x, y, 0});
      expectLightOf(wedges, SurfaceKind::SlopeCeiling, {x, y, 3});
    }
}

TEST(TexelGrid, staysWhenASectorIsCutByAFlatPortal) {
  const BakedRoom whole(wholeRoom(), kLights);
  for (const double z : {1.3, 1.3125}) {
    const auto half = [&](std::string_view name, std::string_view floor, std::string_view ceiling) {
      return fmt::format(
          "'{}':{{'floor':{},'ceiling':{},'loops':{{'border':{{'v':[0.1,0.2, 6.3,0.2, 6.3,4.1, "
          "0.1,4.1],'walls':{{'texture':'#808080'}}}}}}}}",
          name, floor, ceiling);
    };
    const std::string portal = fmt::format("{{'z':{},'next':'up-low'}}", z);
    const BakedRoom cut(levelOf(half("up", portal, "{'z':3,'texture':'#808080'}") + "," +
                                half("low", "{'texture':'#808080'}", portal)),
                        kLights);
    expectSameLight(whole, cut);
  }
}

TEST(TexelGrid, goesOnThroughAOneWayPortalOnlyItsWay) {
  // The walls along y = 0 are one plane; "open" looks into "closed", which does not look back.
  const std::string rooms =
      levelOf(sectorText("open", "0,0, 2,0, 2,2, 0,2", 0, 3,
                         fmt::format("[{0},{{'next':'closed'}},{0},{0}]", kSolid)) +
              "," + sectorText("closed", "2,0, 4,0, 4,2, 2,2", 0, 3));
  const BakedRoom lit(rooms, "[{'x':3,'y':1,'z':1.5,'intensity':200}]");
  EXPECT_EQ(lit.at(SurfaceKind::Solid, {2.01, 0, 1}, "closed"), 200);
  EXPECT_NEAR(lit.at(SurfaceKind::Solid, {2 - 1e-9, 0, 1}, "open"), 100, 1e-3)
      << "half way to the first texel beyond the portal";
}

TEST(TexelGrid, doesNotTakeLightFromBehindAThinWall) {
  // Two rooms side by side whose floors are one plane, joined far away by a third.
  const BakedRoom rooms(
      levelOf(sectorText("bright", "0,0, 4,0, 4,8, 0,8", 0, 3,
                         fmt::format("[{0},{0},{{'next':'hall'}},{0}]", kSolid)) +
              "," +
              sectorText("dark", "4.01,0, 8,0, 8,8, 4.01,8", 0, 3,
                         fmt::format("[{0},{0},{{'next':'hall'}},{0}]", kSolid)) +
              "," +
              sectorText(
                  "hall", "0,8, 4,8, 4.01,8, 8,8, 8,9, 0,9", 0, 3,
                  fmt::format("[{{'next':'bright'}},{0},{{'next':'dark'}},{0},{0},{0}]", kSolid))),
      "[{'x':3.5,'y':1,'z':1.5,'intensity':200}]");
  for (double y = 0.5; y < 7; y += 0.31) {
    EXPECT_EQ(rooms.at(SurfaceKind::Floor, {4.02, y, 0}, "dark"), 0) << y;
    EXPECT_EQ(rooms.at(SurfaceKind::Floor, {3.99, y, 0}, "bright"), 200) << y;
  }
}

TEST(TexelGrid, doesNotTakeLightPastTheSolidPartOfAStack) {
  // The walls along y = 0 are one plane; between the rooms the wall is solid up to 2 m.
  const std::string_view solid = "{'texture':'#808080'}";
  const auto stackTo = [&](std::string_view next) {
    return fmt::format("{{'walls':[{{'texture':'#808080','z':2}},{{'next':'{}'}}]}}", next);
  };
  const BakedRoom rooms(
      levelOf(sectorText("dark", "0,0, 2,0, 2,2, 0,2", 0, 3,
                         fmt::format("[{0},{1},{0},{0}]", solid, stackTo("bright"))) +
              "," +
              sectorText("bright", "2,0, 4,0, 4,2, 2,2", 0, 3,
                         fmt::format("[{0},{0},{0},{1}]", solid, stackTo("dark")))),
      "[{'x':3,'y':1,'z':0.5,'intensity':200}]");
  EXPECT_EQ(rooms.at(SurfaceKind::Solid, {2.01, 0, 1}, "bright"), 200);
  EXPECT_EQ(rooms.at(SurfaceKind::Solid, {2 - 1e-9, 0, 1}, "dark"), 0);
}

TEST(TexelGrid, doesNotTakeLightPastASillOfALevelOfAThousandth) {
  // Rooms of 4 mm; between their floors stands a sill of 0.3 mm, which is no author's noise there.
  const std::string_view solid = "{'texture':'#808080'}";
  const auto overSillTo = [&](std::string_view next) {
    return fmt::format("{{'walls':[{{'texture':'#808080','z':0.0003}},{{'next':'{}'}}]}}", next);
  };
  const BakedRoom rooms(
      levelOf(sectorText("dark", "0,0, 0.004,0, 0.004,0.004, 0,0.004", 0, 0.003,
                         fmt::format("[{0},{1},{0},{0}]", solid, overSillTo("bright"))) +
              "," +
              sectorText("bright", "0.004,0, 0.008,0, 0.008,0.004, 0.004,0.004", 0, 0.003,
                         fmt::format("[{0},{0},{0},{1}]", solid, overSillTo("dark")))),
      "{'lights':[{'x':0.006,'y':0.002,'z':0.0001,'intensity':200}],'bake':{'texel':0.000125}}");
  EXPECT_EQ(rooms.at(SurfaceKind::Floor, {0.004 + 1e-6, 0.002, 0}, "bright"), 200);
  EXPECT_EQ(rooms.at(SurfaceKind::Floor, {0.004 - 1e-6, 0.002, 0}, "dark"), 0);
}

TEST(TexelGrid, doesNotTakeLightPastWhereASlopeClosesAPortal) {
  // The slopes are one plane, and the portal between them ends at 1 m: it is open up to y = 1.
  const std::string_view solid = "{'texture':'#808080'}";
  const std::string_view slope = ", 'slopeFloor':{'z':[0,0,2,2],'sidewall':'#808080'}";
  const auto stackTo = [&](std::string_view next) {
    return fmt::format("{{'walls':[{{'next':'{}','z':1}},{{'texture':'#808080'}}]}}", next);
  };
  const BakedRoom rooms(
      levelOf(sectorText("dark", "0,0, 2,0, 2,2, 0,2", 0, 3,
                         fmt::format("[{0},{1},{0},{0}]", solid, stackTo("bright")), slope) +
              "," +
              sectorText("bright", "2,0, 4,0, 4,2, 2,2", 0, 3,
                         fmt::format("[{0},{0},{0},{1}]", solid, stackTo("dark")), slope)),
      "[{'x':3.5,'y':1.7,'z':2.8,'intensity':200}]");
  EXPECT_EQ(rooms.at(SurfaceKind::SlopeFloor, {2.01, 1.8, 1.8}, "bright"), 200);
  EXPECT_EQ(rooms.at(SurfaceKind::SlopeFloor, {2 - 1e-9, 1.8, 1.8}, "dark"), 0);
}

TEST(TexelGrid, isOneForSlopesThatAOneWayPortalJoins) {
  const std::string_view solid = "{'texture':'#808080'}";
  const std::string_view slope = ", 'slopeFloor':{'z':[0,0,2,2],'sidewall':'#808080'}";
  const BakedRoom rooms(
      levelOf(sectorText("west", "0,0, 2,0, 2,2, 0,2", 0, 3, "{'texture':'#808080'}", slope) + "," +
              sectorText("east", "2,0, 4,0, 4,2, 2,2", 0, 3,
                         fmt::format("[{0},{0},{0},{{'next':'west'}}]", solid), slope)),
      "[]");
  const auto west = rooms.surfaceAt(SurfaceKind::SlopeFloor, {1, 1, 1}, "west");
  const auto east = rooms.surfaceAt(SurfaceKind::SlopeFloor, {3, 1, 1}, "east");
  ASSERT_TRUE(west && east);
  EXPECT_EQ(rooms.light().surfaces[west->index()]->grid,
            rooms.light().surfaces[east->index()]->grid);
}

/// The texels of a surface at a point.
TexelGrid gridAt(const BakedRoom& rooms, SurfaceKind kind, Vec3 p, std::string_view sector) {
  const auto surface = rooms.surfaceAt(kind, p, sector);
  return surface ? rooms.light().surfaces[surface->index()]->grid : TexelGrid{};
}

TEST(TexelGrid, isNotOneForWallsThatOnlyAHallBehindThemJoins) {
  // "low" and, over it, "high" have walls along y = 0 and look through them into "hall".
  const std::string_view solid = "{'texture':'#808080'}";
  const std::string hallWalls = fmt::format(
      "[{{'next':'low','upper':'#808080'}},{{'walls':[{{'next':'low','upper':'#808080','z':1.5}},"
      "{{'next':'high','lower':'#808080'}}]}},{0},{0},{0}]",
      solid);
  const BakedRoom rooms(
      levelOf(sectorText("low", "-1,-2, 3,-2, 3,0, 0.3,0, -1,0", 0, 1,
                         fmt::format("[{0},{0},{{'next':'hall'}},{{'next':'hall'}},{0}]", solid)) +
              "," +
              sectorText("high", "0.3,-2, 3,-2, 3,0, 0.3,0", 2, 3,
                         fmt::format("[{0},{0},{{'walls':[{{'texture':'#808080','z':0.5}},"
                                     "{{'next':'hall'}}]}},{0}]",
                                     solid)) +
              "," + sectorText("hall", "-1,0, 0.3,0, 3,0, 3,2, -1,2", 0, 3, hallWalls)),
      "[]");
  EXPECT_EQ(gridAt(rooms, SurfaceKind::StackSolid, {1, 0, 2.2}, "high").toTexels({0.3, 0, 0}),
            (Vec2{0, 0}));
}

enum class Open { Whole, BelowOneMetre, AboveTwoMetres };

std::string portalTo(std::string_view next, Open open) {
  if (open == Open::BelowOneMetre)
    return fmt::format("{{'walls':[{{'next':'{}','z':1}},{{'texture':'#808080'}}]}}", next);
  if (open == Open::AboveTwoMetres)
    return fmt::format("{{'walls':[{{'texture':'#808080','z':2}},{{'next':'{}'}}]}}", next);
  return fmt::format("{{'next':'{}'}}", next);
}

/// "west" and "east", whose walls along y = 0 are one plane, and the wedge-shaped "mid" between
/// them, with its tip at (2, 0).
std::string fan(Open west, Open east, std::string_view slope) {
  const std::string_view solid = "{'texture':'#808080'}";
  return levelOf(
      sectorText("west", "0,0, 2,0, 1,2, 0,2", 0, 3,
                 fmt::format("[{0},{1},{0},{0}]", solid, portalTo("mid", west))) +
      "," +
      sectorText("mid", "2,0, 3,2, 1,2", 0, 3,
                 fmt::format("[{},{},{}]", portalTo("east", east), solid, portalTo("west", west)),
                 slope) +
      "," +
      sectorText("east", "2,0, 4,0, 4,2, 3,2", 0, 3,
                 fmt::format("[{0},{0},{0},{1}]", solid, portalTo("mid", east))));
}

std::string wedgeAtTip(double height) {
  return fmt::format(", 'slopeFloor':{{'z':[{},0,0],'sidewall':'#808080'}}", height);
}

TEST(TexelGrid, isNotOneForWallsBetweenWhichNothingIsOpen) {
  const auto originOfEast = [](const std::string& level) {
    const BakedRoom rooms(level, "[]");
    return gridAt(rooms, SurfaceKind::Solid, {3, 0, 1}, "east").origin.xy();
  };
  EXPECT_EQ(originOfEast(fan(Open::Whole, Open::Whole, "")), (Vec2{0, 0}));
  EXPECT_EQ(originOfEast(fan(Open::Whole, Open::Whole, wedgeAtTip(2.5))), (Vec2{0, 0}));
  EXPECT_EQ(originOfEast(fan(Open::Whole, Open::Whole, wedgeAtTip(3))), (Vec2{2, 0}));
  EXPECT_EQ(originOfEast(fan(Open::BelowOneMetre, Open::AboveTwoMetres, "")), (Vec2{2, 0}));
}

TEST(TexelGrid, doesNotTakeLightPastAWedge) {
  const BakedRoom rooms(fan(Open::Whole, Open::Whole, wedgeAtTip(1.5)),
                        "[{'x':3.5,'y':0.8,'z':0.4,'intensity':200}]");
  for (double z = 0.1; z < 1.3; z += 0.0431) {
    EXPECT_EQ(rooms.at(SurfaceKind::Solid, {2.01, 0, z}, "east"), 200) << z;
    EXPECT_EQ(rooms.at(SurfaceKind::Solid, {2 - 1e-9, 0, z}, "west"), 0) << z;
  }
}

TEST(TexelGrid, isFoundWhereTheCornersOfManyPillarsMeet) {
  // "west" and "east" meet along x = 0; each has 20 pillars with a corner at (0, 0), all of them
  // open: there are 2^40 ways to go round.
  std::string pillars;
  const auto half = [&](std::string_view name, std::string_view v, std::string_view walls,
                        double from) {
    std::string loops;
    for (int i = 0; i < 20; ++i) {
      const SinCos a = sinCosDegrees(from + 4 * i + 1);
      const SinCos b = sinCosDegrees(from + 4 * i + 3);
      const std::string pillar = fmt::format("{}{}", name, i);
      pillars +=
          "," + sectorText(pillar, fmt::format("0,0, {},{}, {},{}", a.cos, a.sin, b.cos, b.sin), 0,
                           3, fmt::format("{{'next':'{}'}}", name));
      loops += fmt::format(",'{}':{{'v':[0,0, {},{}, {},{}],'walls':{{'next':'{}'}}}}", pillar,
                           b.cos, b.sin, a.cos, a.sin, pillar);
    }
    return fmt::format(
        "'{}':{{'floor':{{'z':0,'texture':'#808080'}},'ceiling':{{'z':3,'texture':'#808080'}},"
        "'loops':{{'border':{{'v':[{}],'walls':{}}}{}}}}}",
        name, v, walls, loops);
  };
  const std::string_view solid = "{'texture':'#808080'}";
  const std::string west = half("west", "-2,0, 0,0, 0,2, -2,2",
                                fmt::format("[{0},{{'next':'east'}},{0},{0}]", solid), 95);
  const std::string east =
      half("east", "0,0, 2,0, 2,2, 0,2", fmt::format("[{0},{0},{0},{{'next':'west'}}]", solid), 5);
  const BakedRoom rooms(levelOf(west + "," + east + pillars), "[]");
  EXPECT_EQ(gridAt(rooms, SurfaceKind::Solid, {1, 0, 1}, "east").origin.xy(), (Vec2{-2, 0}));
}

TEST(TexelGrid, doesNotTakeLightFromASidewallRoundAThinWall) {
  // "dark" and "bright" lie side by side; both see the wedge of "hall", which joins them behind it.
  const std::string_view solid = "{'texture':'#808080'}";
  const std::string walls = fmt::format("[{0},{0},{{'next':'hall'}},{0}]", solid);
  const BakedRoom rooms(
      levelOf(sectorText("dark", "0,-2, 2,-2, 2,0, 0,0", 0, 3, walls) + "," +
              sectorText("bright", "2,-2, 4,-2, 4,0, 2,0", 0, 3, walls) + "," +
              sectorText("hall", "0,0, 2,0, 4,0, 4,2, 0,2", 0, 3,
                         fmt::format("[{{'next':'dark'}},{{'next':'bright'}},{0},{0},{0}]", solid),
                         ", 'slopeFloor':{'z':[1,1,1,0,0],'sidewall':'#808080'}")),
      "[{'x':3,'y':-1,'z':0.5,'intensity':200}]");
  for (double z = 0.1; z < 1; z += 0.0431) {
    EXPECT_EQ(rooms.at(SurfaceKind::FloorSidewall, {2.01, 0, z}, "bright"), 200) << z;
    EXPECT_EQ(rooms.at(SurfaceKind::FloorSidewall, {2 - 1e-9, 0, z}, "dark"), 0) << z;
  }
}

/// Corners turned about (0, 0), as `v` of a loop.
std::string turned(double degrees, std::initializer_list<Vec2> corners) {
  const SinCos turn = sinCosDegrees(degrees);
  std::string text;
  for (const Vec2 p : corners)
    text += fmt::format("{}{},{}", text.empty() ? "" : ", ", turn.cos * p.x - turn.sin * p.y,
                        turn.sin * p.x + turn.cos * p.y);
  return text;
}

Vec3 turned(double degrees, Vec3 p) {
  const SinCos turn = sinCosDegrees(degrees);
  return {turn.cos * p.x - turn.sin * p.y, turn.sin * p.x + turn.cos * p.y, p.z};
}

std::string lightAt(Vec3 p) {
  return fmt::format("[{{'x':{},'y':{},'z':{},'intensity':200}}]", p.x, p.y, p.z);
}

TEST(TexelGrid, doesNotTakeLightPastAPortalThatAWedgeClosesUpToTheCeiling) {
  const std::string_view solid = "{'texture':'#808080'}";
  for (double degrees = -80; degrees < 80; degrees += 7.3) {
    const BakedRoom rooms(
        levelOf(sectorText("dark", turned(degrees, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}), 0.5, 1.7,
                           fmt::format("[{0},{{'next':'bright'}},{0},{0}]", solid)) +
                "," +
                sectorText("bright", turned(degrees, {{2, 0}, {4, 0}, {4, 2}, {2, 2}}), 0.5, 1.7,
                           fmt::format("[{0},{0},{0},{{'next':'dark'}}]", solid),
                           ", 'slopeFloor':{'z':[1.2,0,0,1.2],'sidewall':'#808080'}")),
        lightAt(turned(degrees, Vec3{3.5, 1, 1.6})));
    for (double y = 0.1; y < 2; y += 0.0631) {
      EXPECT_EQ(rooms.at(SurfaceKind::Ceiling, turned(degrees, Vec3{2 - 1e-5, y, 1.7}), "dark"), 0)
          << degrees << ' ' << y;
    }
    EXPECT_EQ(rooms.at(SurfaceKind::Ceiling, turned(degrees, Vec3{3, 1, 1.7}), "bright"), 200);
  }
}

TEST(TexelGrid, takesItsOwnLightOnTheVeryEdgeOfItsSurface) {
  // A column of texel centres lies where the walls along y = 0 meet: "open" looks into "closed",
  // which is lit and does not look back.
  const std::string_view solid = "{'texture':'#808080'}";
  for (double degrees = -80; degrees < 80; degrees += 3.7) {
    const BakedRoom rooms(
        levelOf(sectorText("open", turned(degrees, {{0, 0}, {2.0625, 0}, {2.0625, 2}, {0, 2}}), 0,
                           3, fmt::format("[{0},{{'next':'closed'}},{0},{0}]", solid)) +
                "," +
                sectorText("closed", turned(degrees, {{2.0625, 0}, {4, 0}, {4, 2}, {2.0625, 2}}), 0,
                           3)),
        lightAt(turned(degrees, Vec3{3, 1, 1.5})));
    for (double z = 0.1; z < 3; z += 0.0431)
      EXPECT_NEAR(rooms.at(SurfaceKind::Solid, turned(degrees, Vec3{2.0625 - 1e-5, 0, z}), "open"),
                  0, 0.02)
          << degrees << ' ' << z;
  }
}

TEST(TexelGrid, staysWhereAPortalFromThePointOfAPillarCutsASector) {
  // The pillar's point touches the wall at (2, 0), where the cut begins.
  const std::string_view solid = "{'texture':'#808080'}";
  const std::string_view pillar = ", 'pillar':{'v':[2,0, 2.2,0.9, 2.9,0.8],'walls':";
  const auto room = [&](std::string_view name, std::string_view v, std::string_view walls,
                        bool hasPillar) {
    return fmt::format(
        "'{}':{{'floor':{{'z':0,'texture':'#808080'}},'ceiling':{{'z':3,'texture':'#808080'}},"
        "'loops':{{'border':{{'v':[{}],'walls':{}}}{}}}}}",
        name, v, walls, hasPillar ? fmt::format("{}{}}}", pillar, solid) : "");
  };
  const std::string_view light = "[{'x':3.3,'y':0.3,'z':1.5,'falloff':0.5}]";
  const BakedRoom whole(levelOf(room("room", "0,0, 2,0, 4,0, 4,2, 0,2", solid, true)), light);
  const BakedRoom cut(levelOf(room("west", "0,0, 2,0, 1,2, 0,2",
                                   fmt::format("[{0},{{'next':'east'}},{0},{0}]", solid), false) +
                              "," +
                              room("east", "2,0, 4,0, 4,2, 1,2",
                                   fmt::format("[{0},{0},{0},{{'next':'west'}}]", solid), true)),
                      light);
  for (double x = 0.01; x < 4; x += 0.0217)
    for (double z = 0.01; z < 3; z += 0.0431)
      EXPECT_NEAR(cut.at(SurfaceKind::Solid, {x, 0, z}), whole.at(SurfaceKind::Solid, {x, 0, z}),
                  kRounding)
          << x << ' ' << z;
}

TEST(TexelGrid, isAnchoredToTheFirstVertexOfTheRun) {
  const BakedRoom room(wholeRoom(), kLights);
  const auto surface = room.surfaceAt(SurfaceKind::Solid, {6.3, 2, 1}, "room");
  ASSERT_TRUE(surface);
  const TexelGrid& grid = room.light().surfaces[surface->index()]->grid;
  EXPECT_EQ(grid.toTexels({6.3, 0.2, 0}), (Vec2{0, 0}));
  EXPECT_NEAR(grid.toTexels({6.3, 1.2, 0.5}).x, 8, 1e-12);
  EXPECT_NEAR(grid.toTexels({6.3, 1.2, 0.5}).y, 4, 1e-12);
}

}  // namespace
}  // namespace hearth
