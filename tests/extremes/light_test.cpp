// Lights at extreme places and of extreme strength, on surfaces of extreme shapes.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "agreement/compare_level.h"
#include "level/locate.h"
#include "level_files.h"
#include "light/bakery.h"
#include "rooms.h"
#include "support/baked_room.h"
#include "truth/truth_light.h"

namespace hearth::extremes {
namespace {

using test::BakedRoom;
using test::sectorText;

std::string lightAt(Vec3 p, std::string_view more = "") {
  return fmt::format("{{'x': {}, 'y': {}, 'z': {}{}}}", p.x, p.y, p.z, more);
}

/// All levels of all lightmaps, in order; none where nothing is lit.
std::vector<int> levelsOf(const BakedLight& light) {
  std::vector<int> levels;
  for (const auto& map : light.lightmaps)
    if (map) levels.insert(levels.end(), map->levels.begin(), map->levels.end());
  return levels;
}

TEST(LightPlace, onATexelsCentreLightsAllButItsOwnPlane) {
  // Texels of 1/8 m have their centres at odd sixteenths.
  for (const std::string_view lambert : {"false", "true"}) {
    const BakedRoom room(levelOf(sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3), "0"),
                         fmt::format("{{'lights': [{}], 'bake': {{'lambert': {}}}}}",
                                     lightAt({3.0625, 2.0625, 0}), lambert));
    for (double x = 2.9; x < 3.2; x += 0.01)
      EXPECT_EQ(room.at(SurfaceKind::Floor, {x, 2.0625, 0}), 0) << x;
    EXPECT_EQ(room.at(SurfaceKind::Ceiling, {3.0625, 2.0625, 3}), 255);
    // The cosine at the wall, from 3 m away and a texel lower.
    const double cosine = 2.0625 / std::hypot(2.0625, 0.0625);
    EXPECT_NEAR(room.at(SurfaceKind::Solid, {3.0625, 0, 0.0625}),
                lambert == "true" ? 255 * cosine : 255, 1);
  }
}

/// Rooms in which every kind of surface shows but skies.
std::string roomOfAllKinds() {
  const std::string stack =
      "{'walls': [{'texture': '#808080', 'z': 1}, {'next': 'annex', 'texture': '#808080'}]}";
  const std::string curtain = "{'next': 'main', 'texture': '#808080', 'middle': '#808080'}";
  return levelOf(
      sectorText("main", "0,0, 4,0, 8,0, 8,4, 8,8, 0,8", 0, 3,
                 fmt::format("[{1}, {0}, {2}, {3}, {0}, {0}]", kSolid, stack, portalTo("steps"),
                             portalTo("ramp"))) +
          "," +
          sectorText("annex", "0,-4, 4,-4, 4,0, 0,0", 1.3, 2.5,
                     fmt::format("[{0}, {0}, {1}, {0}]", kSolid, curtain)) +
          "," +
          sectorText("steps", "8,0, 12,0, 12,4, 8,4", 0.5, 2.5,
                     fmt::format("[{0}, {0}, {0}, {1}]", kSolid, portalTo("main"))) +
          "," +
          sectorText("ramp", "8,4, 12,4, 12,8, 8,8", 0, 3,
                     fmt::format("[{0}, {0}, {0}, {1}]", kSolid, portalTo("main")),
                     ", 'slopeFloor': {'z': [1, 0, 0, 1], 'sidewall': '#808080'}, 'slopeCeil': "
                     "{'z': [1, 0, 0, 1], 'sidewall': '#808080'}"),
      "0");
}

/// A point of a surface's middle.
Vec3 middleOf(const LitSurface& surface) {
  const std::vector<Vec2> border = surface.outline.loops().front();
  Vec2 sum;
  for (const Vec2 p : border) sum = sum + p;
  return surface.toWorld((1.0 / static_cast<double>(border.size())) * sum);
}

TEST(LightPlace, inAPlaneOrAMicrometreBehindItDoesNotLightItWhateverItIs) {
  const LoadedLevel all = test::levelFrom(roomOfAllKinds());
  const LitSurfaces surfaces = makeLitSurfaces(all.scene(), 0.125);
  std::set<SurfaceKind> kinds;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i]) continue;
    const Surface& surface = all.level.surfaces[i];
    for (const double behind : {0.0, 0.9e-6}) {
      const Vec3 p = middleOf(*surfaces[i]) - behind * surfaces[i]->normal;
      const LevelFiles files = filesOf(
          roomOfAllKinds(),
          fmt::format("[{}]",
                      lightAt(p, fmt::format(", 'sector': '{}'", all.level[surface.sector].name))));
      const LoadResult result = tryLoad(files);
      ASSERT_TRUE(result.loaded) << name(surface.kind);
      const bool warned = std::ranges::any_of(result.diagnostics, [](const Diagnostic& d) {
        return d.message.find("does not light it") != std::string::npos;
      });
      EXPECT_TRUE(warned) << name(surface.kind) << ' ' << behind;
      const BakedLight light = bake(result.loaded->scene(), {}, 1);
      EXPECT_FALSE(light.lightmaps[i].has_value()) << name(surface.kind) << ' ' << behind;
      EXPECT_FALSE(levelsOf(light).empty());
      kinds.insert(surface.kind);
    }
  }
  EXPECT_EQ(kinds.size(), kSurfaceKindCount - 8) << "all but those of skies and things";
}

/// Four rooms round the origin, open to each other.
std::string fourRooms() {
  const auto room = [](double x, double y) {
    return BoxRoom{.x0 = x, .y0 = y, .x1 = x + 4, .y1 = y + 4};
  };
  return levelOf(
      room(0, 0).sector(
          "se", fmt::format("[{1}, {0}, {0}, {2}]", kSolid, portalTo("ne"), portalTo("sw"))) +
          "," +
          room(-4, 0).sector(
              "sw", fmt::format("[{1}, {2}, {0}, {0}]", kSolid, portalTo("nw"), portalTo("se"))) +
          "," +
          room(0, -4).sector(
              "ne", fmt::format("[{0}, {0}, {1}, {2}]", kSolid, portalTo("se"), portalTo("nw"))) +
          "," +
          room(-4, -4).sector(
              "nw", fmt::format("[{0}, {1}, {2}, {0}]", kSolid, portalTo("ne"), portalTo("sw"))),
      "0");
}

TEST(LightPlace, onAPortalsLineAndOnAVertexOfFourRoomsIsThatOfAMicrometreBeside) {
  const std::string more = ", 'falloff': 0.3";
  for (const Vec3 p : {Vec3{0, 0, 1.5}, Vec3{0, 2.1, 1.5}, Vec3{-3.3, 0, 1.5}}) {
    const BakedRoom on(fourRooms(), "[" + lightAt(p, more) + "]", 1);
    for (const Vec3 by :
         {Vec3{1e-6, 1e-6, 0}, Vec3{-1e-6, 1e-6, 0}, Vec3{1e-6, -1e-6, 0}, Vec3{-1e-6, -1e-6, 0}}) {
      const BakedRoom beside(fourRooms(), "[" + lightAt(p + by, more) + "]", 1);
      const std::vector<int> some = levelsOf(on.light());
      const std::vector<int> others = levelsOf(beside.light());
      ASSERT_EQ(some.size(), others.size());
      for (std::size_t i = 0; i < some.size(); ++i) ASSERT_NEAR(some[i], others[i], 1) << i;
    }
  }
}

TEST(LightRay, throughTheVeryJointOfTwoWallsIsBlocked) {
  // An octagonal room round an octagonal cell without a way in; each light, a vertex of the cell
  // and a texel's centre in it are in one line.
  const auto ring = [](double radius, int turn) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
      const double angle = turn * std::numbers::pi / 4 * i;
      text += fmt::format("{}{},{}", i > 0 ? ", " : "", radius * std::cos(angle),
                          radius * std::sin(angle));
    }
    return text;
  };
  const std::string rooms = levelOf(
      fmt::format("'ring': {{'floor': {{'texture': '#808080'}}, 'ceiling': {{'z': 3, 'texture': "
                  "'#808080'}}, 'loops': {{'border': {{'v': [{}], 'walls': {}}}, 'cell': {{'v': "
                  "[{}], 'walls': {}}}}}}},",
                  ring(8, 1), kSolid, ring(4, -1), kSolid) +
          sectorText("cell", ring(4, 1), 0, 3),
      "0");
  std::string lights;
  for (int i = 0; i < 8; ++i) {
    const double angle = std::numbers::pi / 4 * i;
    const Vec2 vertex{4 * std::cos(angle), 4 * std::sin(angle)};
    for (const Vec2 texel : {Vec2{0.0625, 0.0625}, Vec2{-1.0625, 0.3125}, Vec2{0.9375, -2.1875}}) {
      const Vec2 light = vertex + 0.5 * (vertex - texel);
      lights +=
          (lights.empty() ? "" : ",") + lightAt({light.x, light.y, 1.5}, ", 'sector': 'ring'");
    }
  }
  for (const std::string_view samples : {"1", "4", "'auto'"}) {
    const BakedRoom baked(
        rooms, fmt::format("{{'lights': [{}], 'bake': {{'samples': {}}}}}", lights, samples));
    for (const SurfaceId id : baked.scene().shownSurfaces())
      if (baked.level()[id].sector == SectorId(1)) {
        EXPECT_FALSE(baked.light().lightmaps[id.index()].has_value()) << samples;
      }
  }
}

TEST(LightRay, nearlyInASurfacesPlaneArrivesWhereTruthSays) {
  // Along a wall of 100 m in which a pillar throws a shadow of any length.
  for (const double distance : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const BakedRoom hall(
        levelOf(sectorText("hall", "0,0, 40,0, 40,0.5, 41,0.5, 41,0, 100,0, 100,4, 0,4", 0, 3),
                "0"),
        fmt::format("{{'lights': [{}], 'bake': {{'texel': 0.5}}}}",
                    lightAt({1, distance, 1.5}, ", 'falloff': 0.01")));
    const TruthLight truth(hall.level());
    for (const auto& [x, z] :
         {std::pair{5.25, 0.25}, std::pair{20.25, 1.75}, std::pair{39.75, 2.75},
          std::pair{60.25, 0.25}, std::pair{99.25, 2.25}}) {
      const SegmentId wall(x < 40 ? 0 : 4);
      const double expected =
          truth.at({SurfaceKind::Solid, SectorId(0), wall, {x, 0, z}, {0, 1, 0}}).x;
      EXPECT_NEAR(hall.at(SurfaceKind::Solid, {x, 0, z}), expected, 1) << distance << ' ' << x;
      EXPECT_EQ(expected > 0, x < 40) << distance << ' ' << x;
    }
  }
}

TEST(LightRay, passesFiftyPortalsInARow) {
  std::string sectors;
  for (int i = 0; i < 51; ++i) {
    const BoxRoom room{.x0 = 1.0 * i, .x1 = i + 1.0, .y1 = 2};
    sectors += (i > 0 ? "," : "") +
               room.sector(fmt::format("r{}", i),
                           fmt::format("[{0}, {1}, {0}, {2}]", kSolid,
                                       i < 50 ? portalTo(fmt::format("r{}", i + 1)) : kSolid,
                                       i > 0 ? portalTo(fmt::format("r{}", i - 1)) : kSolid));
  }
  const BakedRoom row(levelOf(sectors, "0"), "[" + lightAt({0.5, 1, 1.5}) + "]");
  EXPECT_EQ(row.at(SurfaceKind::Solid, {51, 1.3, 2}, "r50"), 255);
  EXPECT_EQ(row.at(SurfaceKind::Floor, {50.5, 0.3, 0}, "r50"), 255);
}

TEST(LightStrength, ofAnyNumberIsBakedWithinItsByte) {
  const std::string room = levelOf(sectorText("room", "0,0, 2,0, 2,2, 0,2", 0, 3), "0");
  const auto floorUnder = [&](std::string_view light) {
    const BakedRoom baked(room, "[" + lightAt({1, 1, 1}, light) + "]", 1);
    return baked.at(SurfaceKind::Floor, {1, 1, 0});
  };
  EXPECT_EQ(floorUnder(", 'intensity': 1e-30"), 0);
  EXPECT_EQ(floorUnder(", 'intensity': 1e38"), 255);
  EXPECT_EQ(floorUnder(", 'intensity': 1e38, 'falloff': 1e30"), 255);
  EXPECT_EQ(floorUnder(", 'intensity': 100, 'falloff': 0"), 100);
  EXPECT_EQ(floorUnder(", 'intensity': 100, 'falloff': 1e-30"), 100);
  EXPECT_EQ(floorUnder(", 'intensity': 100, 'falloff': 1e30"), 0);
  EXPECT_EQ(floorUnder(", 'curve': [[5, 42]]"), 42);
  EXPECT_EQ(floorUnder(", 'curve': [[0, 1e38], [1e9, 0]]"), 255);
  EXPECT_EQ(floorUnder(", 'curve': [[0, 0], [0, 7], [0, 9]]"), 9);
  EXPECT_EQ(floorUnder(", 'radius': 1e-9, 'intensity': 100"), 100);
}

TEST(LightRamp, ofEightLevelsOver512TexelsHasThemAll) {
  const BakedRoom hall(levelOf(sectorText("hall", "0,0, 64,0, 64,1, 0,1", 0, 1), "0"),
                       "[" + lightAt({0, 0.5, 0.5}, ", 'curve': [[0, 0], [64, 8]]") + "]");
  std::vector<int> seen;
  for (double x = 0.0625; x < 64; x += 0.125) {
    const double level = hall.at(SurfaceKind::Floor, {x, 0.4375, 0});
    EXPECT_EQ(level, std::round(level)) << x;
    if (seen.empty() || seen.back() != level) seen.push_back(static_cast<int>(level));
  }
  EXPECT_EQ(seen, (std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(LightOfNothing, makesAValidLevelWithoutLightmaps) {
  const std::string room = levelOf(sectorText("room", "0,0, 2,0, 2,2, 0,2", 0, 3), "0.5");
  for (const std::string& lights :
       {std::string("[]"), "[" + lightAt({1, 1, 1}, ", 'intensity': 0") + "]",
        "[" + lightAt({1, 1, 1}, ", 'curve': [[0, 0]]") + "]"}) {
    const BakedRoom baked(room, lights, 1);
    EXPECT_EQ(baked.light().stats.litSurfaces, 0U) << lights;
    EXPECT_EQ(baked.light().stats.bytes, 0) << lights;
  }
}

/// Expects light as truth has it at every pixel of a look round.
void expectLitAsTruth(const std::string& level, const std::string& lights, Vec3 eye) {
  LoadedLevel loaded = test::levelFrom(level, lights);
  for (double angle = 0; angle < 360; angle += 60)
    for (const double pitch : {-45.0, 0.0, 45.0})
      loaded.level.shots.push_back(
          {fmt::format("{} {}", angle, pitch), SectorId(0), eye, angle, pitch, 90, 64, 40});
  const agreement::Tally tally = agreement::compareLevel(loaded, "level", 100);
  EXPECT_EQ(tally.holes, 0);
  EXPECT_EQ(tally.missed(), 0) << tally.firstMiss;
}

TEST(Texels, ofTrianglesAndAnglesAndCorridorsOfOneTexelAreAsTruth) {
  const std::string lights = "[" + lightAt({0.6, 0.55, 1.2}, ", 'falloff': 0.4") + "]";
  for (const std::string vertices :
       {"0,0, 3,0.2, 0.4,2.7",                                  // a triangle
        "0,0, 4,0, 4,1.3, 1.4,1.3, 1.4,3.9, 0,3.9",             // an L
        "0,0.1768, 0.1768,0, 1,0.8232, 5,4.8232, 4.8232,5"}) {  // 45 degrees, a texel or two wide
    SCOPED_TRACE(vertices);
    const bool isCorridor = vertices.starts_with("0,0.1768");
    expectLitAsTruth(
        levelOf(sectorText("room", vertices, 0, 2), "0"),
        isCorridor ? "[" + lightAt({0.3, 0.28, 1.2}, ", 'falloff': 0.4") + "]" : lights,
        isCorridor ? Vec3{0.5, 0.48, 1} : Vec3{0.7, 0.6, 1});
  }
}

TEST(Texels, ofMapsOfAnyProportionAreAsTruth) {
  // Rooms of 8 x 4, 32 x 8 and n x 1 texels: with what filtering asks for beyond the edges, maps of
  // 10 x 6, 34 x 10, and so on.
  for (const auto& [x, y] : {std::pair{1.0, 0.5}, std::pair{4.0, 1.0}, std::pair{3.0, 0.125},
                             std::pair{0.125, 3.0}, std::pair{0.125, 0.125}}) {
    SCOPED_TRACE(fmt::format("{} x {} m", x, y));
    expectLitAsTruth(
        levelOf(sectorText("room", fmt::format("0,0, {0},0, {0},{1}, 0,{1}", x, y), 0, 1), "0"),
        "[" + lightAt({0.4 * x, 0.6 * y, 0.9}, ", 'falloff': 0.8") + "]", {0.7 * x, 0.5 * y, 0.5});
  }
}

TEST(Texels, ofLengthsOfWholeTexelsAndAnUlpMoreOrLessAreTheSame) {
  const auto roomOf = [](double length) {
    return BakedRoom(
        levelOf(sectorText("room", fmt::format("0,0, {0},0, {0},3, 0,3", length), 0, 3), "0"),
        "[" + lightAt({1.1, 1.3, 1.7}, ", 'falloff': 0.4") + "]", 1);
  };
  const BakedRoom exact = roomOf(4);
  for (const double length : {std::nextafter(4, 0), std::nextafter(4, 9)}) {
    const BakedRoom other = roomOf(length);
    for (double x = 0.01; x < 4; x += 0.03)
      for (double z = 0.01; z < 3; z += 0.09) {
        EXPECT_NEAR(exact.at(SurfaceKind::Solid, {x, 0, z}),
                    other.at(SurfaceKind::Solid, {x, 0, z}), 1);
        EXPECT_NEAR(exact.at(SurfaceKind::Floor, {x, z, 0}),
                    other.at(SurfaceKind::Floor, {x, z, 0}), 1);
      }
  }
}

TEST(Texels, largerThanTheirSurfaceHaveTheMeanOfSmallOnes) {
  // A pillar's top, a fifth of a texel wide, with a shadow's edge across it.
  const std::string level = levelOf(
      "'room': {'floor': {'texture': '#808080'}, 'ceiling': {'z': 3, 'texture': '#808080'}, "
      "'loops': {'border': {'v': [0,0, 4,0, 4,4, 0,4], 'walls': {'texture': '#808080'}}, "
      "'pillar': {'v': [2,2, 2,2.1, 2.1,2.1, 2.1,2], 'walls': {'next': 'top', 'texture': "
      "'#808080'}}}}," +
          sectorText("top", "2,2, 2.1,2, 2.1,2.1, 2,2.1", 1, 3,
                     "{'next': 'room', 'texture': '#808080'}"),
      "0");
  const auto topOf = [&](double texel, int samples) {
    return BakedRoom(level,
                     fmt::format("{{'lights': [{}], 'bake': {{'texel': {}, 'samples': {}}}}}",
                                 lightAt({0.7, 1.1, 2.2}, ", 'falloff': 0.5"), texel, samples));
  };
  const BakedRoom coarse = topOf(0.5, 16);
  const BakedRoom fine = topOf(0.005, 1);
  double sum = 0;
  int count = 0;
  for (double x = 2.0025; x < 2.1; x += 0.005)
    for (double y = 2.0025; y < 2.1; y += 0.005, ++count)
      sum += fine.at(SurfaceKind::Floor, {x, y, 1}, "top");
  EXPECT_NEAR(coarse.at(SurfaceKind::Floor, {2.05, 2.05, 1}, "top"), sum / count, 1);
}

}  // namespace
}  // namespace hearth::extremes
