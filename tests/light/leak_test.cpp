// No light where none can come: behind walls however thin, and in corners however acute.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/trig.h"
#include "support/baked_room.h"
#include "support/level_text.h"
#include "truth/truth_light.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::sectorText;

std::string levelOf(const std::string& sectors) {
  return fmt::format("{{'light': 0, 'sectors': {{{}}}}}", sectors);
}

std::string lightsOf(std::string_view lights, std::string_view samples) {
  return fmt::format("{{'lights':[{}],'bake':{{'samples':{}}}}}", lights, samples);
}

constexpr std::string_view kSampleCounts[] = {"1", "16", "'auto'"};

void expectDark(const BakedRoom& rooms, std::string_view sector) {
  for (const SurfaceId id : rooms.scene().shownSurfaces())
    if (rooms.level()[rooms.level()[id].sector].name == sector) {
      EXPECT_FALSE(rooms.light().lightmaps[id.index()].has_value())
          << name(rooms.level()[id].kind) << " of " << sector;
    }
}

std::string roomsWithWall(double thickness) {
  const double x = 6 + thickness;
  return levelOf(sectorText("bright", "0,0, 6,0, 6,4, 0,4", 0, 3) + "," +
                 sectorText("dark", fmt::format("{0},0, {1},0, {1},4, {0},4", x, x + 4), 0, 3));
}

TEST(Leak, noneIntoASealedRoomBehindAWallOfAnyThickness) {
  for (const double thickness : {1.0, 0.1, 0.01, 0.0})
    for (const std::string_view samples : kSampleCounts) {
      SCOPED_TRACE(fmt::format("wall of {} m, {} samples", thickness, samples));
      expectDark(BakedRoom(roomsWithWall(thickness),
                           lightsOf("{'x':5.9,'y':2,'z':1.5},{'x':1,'y':1,'z':1.5}", samples)),
                 "dark");
    }
}

TEST(Leak, noneOfABallThatReachesThroughTheWall) {
  for (const double thickness : {0.1, 0.0}) {
    SCOPED_TRACE(fmt::format("wall of {} m", thickness));
    expectDark(
        BakedRoom(roomsWithWall(thickness),
                  "{'lights':[{'x':5.8,'y':3.9,'z':2.9,'radius':0.5}],'bake':{'texel':0.5}}"),
        "dark");
  }
}

TEST(Leak, noneThroughAFloorOfAnyThickness) {
  for (const double thickness : {1.0, 0.1, 0.01, 0.0}) {
    SCOPED_TRACE(fmt::format("floor of {} m", thickness));
    const BakedRoom rooms(
        levelOf(sectorText("bright", "0,0, 6,0, 6,4, 0,4", 0, 3) + "," +
                sectorText("dark", "0,0, 6,0, 6,4, 0,4", -3 - thickness, -thickness)),
        "[{'x':5.9,'y':2,'z':0.1,'sector':'bright'},"
        "{'x':1,'y':1,'z':0.2,'radius':0.4,'sector':'bright'}]");
    expectDark(rooms, "dark");
  }
}

/// A wedge with its tip at the origin, and a room that surrounds it without a wall between.
std::string wedge(double degrees) {
  const SinCos half = sinCosDegrees(degrees / 2);
  const double x = 6 * half.cos;
  const double y = 6 * half.sin;
  return levelOf(fmt::format(
      "{0}, 'outer': {{'floor':{{'texture':'#808080'}},'ceiling':{{'z':3,'texture':'#808080'}},"
      "'loops':{{'border':{{'v':[-3,-6, 9,-6, 9,6, -3,6],'walls':{{'texture':'#808080'}}}},"
      "'wedge':{{'v':[0,0, {1},{2}, {1},-{2}],'walls':{{'texture':'#808080'}}}}}}}}",
      sectorText("wedge", fmt::format("0,0, {0},-{1}, {0},{1}", x, y), 0, 3), x, y));
}

/// The most light, by truth, on the surface within a texel of a point.
double brightestAround(const TruthLight& truth, const Level& level, const LitSurface& lit,
                       SurfaceId id, Vec2 texel) {
  const Surface& surface = level[id];
  double brightest = 0;
  for (double s = -1; s <= 1; s += 0.25)
    for (double t = -1; t <= 1; t += 0.25) {
      const Vec2 p = texel + Vec2{s, t};
      if (!lit.outline.contains(p)) continue;
      brightest = std::max(
          brightest,
          truth.at({surface.kind, surface.sector, surface.segment, lit.toWorld(p), lit.normal}).x);
    }
  return brightest;
}

TEST(Leak, noneIntoAcuteCorners) {
  for (const double degrees : {60.0, 30.0, 10.0, 1.0})
    for (const std::string_view samples : kSampleCounts) {
      SCOPED_TRACE(fmt::format("{} degrees, {} samples", degrees, samples));
      // Off the middle, so that both sides differ; the light falls off fast.
      const double y = 5 * sinCosDegrees(degrees / 4).sin;
      const BakedRoom room(
          wedge(degrees),
          lightsOf(fmt::format("{{'x':5,'y':{},'z':1.5,'falloff':2}}", y), samples));
      const TruthLight truth(room.level());
      for (const SurfaceId id : room.scene().shownSurfaces()) {
        const auto& map = room.light().lightmaps[id.index()];
        const LitSurface& lit = *room.light().surfaces[id.index()];
        if (!map) continue;
        for (int t = map->rect.j0; t < map->rect.j0 + map->rect.height; ++t)
          for (int s = map->rect.i0; s < map->rect.i0 + map->rect.width; ++s) {
            const Vec2 middle{s + 0.5, t + 0.5};
            if (!lit.outline.contains(middle)) continue;
            ASSERT_LE(map->at(s, t), brightestAround(truth, room.level(), lit, id, middle) + 0.5)
                << name(room.level()[id].kind) << ' ' << s << ' ' << t;
          }
      }
    }
}

}  // namespace
}  // namespace hearth
