// Where an eye stands and how it looks: on lines, in corners, along walls and at the horizon.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "as_truth.h"
#include "image/compare.h"
#include "load/positions.h"
#include "rooms.h"

namespace hearth::extremes {
namespace {

using test::levelFrom;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

Camera cameraAt(SectorId sector, Vec3 eye, double angle, double pitch = 0) {
  return {sector, eye, angle, pitch, 90, 64, 40};
}

/// Two rooms side by side, open to each other at x = 4.
LoadedLevel twoRooms() {
  const BoxRoom west{.x1 = 4};
  const BoxRoom east{.x0 = 4, .floor = 0.4, .ceiling = 2.2, .floorTexture = "'#303060'"};
  return levelFrom(levelOf(west.sector("west", "[" + kSolid + "," + portalTo("east") + "," +
                                                   kSolid + "," + kSolid + "]") +
                           "," +
                           east.sector("east", "[" + kSolid + "," + kSolid + "," + kSolid + "," +
                                                   portalTo("west") + "]")));
}

TEST(Horizon, onARowsCentreAndBetweenRowsIsDrawnAsTruth) {
  // A floor and a ceiling so far away that the horizon's row shows little else, seen also from the
  // very height of the ceiling.
  const LoadedLevel hall = levelFrom(levelOf(
      BoxRoom{.x0 = -1e5, .y0 = -1e5, .x1 = 1e5, .y1 = 1e5, .floorTexture = "'brick'"}.sector(
          "hall")));
  constexpr double kDistancePx = 32;  // 64 columns, 90 degrees
  for (double row = -20; row <= 60; row += 2.5) {
    const double pitch = degrees(std::atan((row - 20) / kDistancePx));
    for (const double z : {0.0, 1e-9, 1.5, 3 - 1e-9, 3.0})
      expectAsTruth(hall, cameraAt(SectorId(0), {0, 0, z}, 30, pitch));
  }
}

TEST(Eye, atAPortalOrBesideItIsInTheRightSectorAndSeesNoHole) {
  const LoadedLevel rooms = twoRooms();
  for (const double distance : {0.0, 1e-12, 1e-9, 1e-6, 1e-3})
    for (const double side : {-1.0, 1.0})
      for (const double y : {0.0, 1e-12, 4.0, 8.0}) {
        const Vec3 eye{4 + side * distance, y, 1.5};
        const auto sector = locatePosition(rooms.scene(), eye, std::nullopt);
        ASSERT_TRUE(sector) << sector.error();
        if (std::abs(eye.x - 4) > 1e-6) {
          EXPECT_EQ(rooms.level[*sector].name, eye.x < 4 ? "west" : "east");
        }
        for (double angle = 0; angle < 360; angle += 45)
          expectAsTruth(rooms, cameraAt(*sector, eye, angle));
      }
}

TEST(Eye, besideAWallOfAnyHeightLooksAlongItAsTruth) {
  for (const double height : {3.0, 300.0, 30000.0}) {
    const LoadedLevel room =
        levelFrom(levelOf(BoxRoom{.ceiling = height, .wallTexture = "'brick'"}.sector("room")));
    for (const double distance : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1})
      for (const double angle : {0.0, 0.001, -0.001, 1.0, -1.0, 180.0})
        expectAsTruth(room, cameraAt(SectorId(0), {1, distance, 1.5}, angle), 3);
  }
}

TEST(Eye, atTheLimitsOfPitchSeesAsTruth) {
  const LoadedLevel rooms = twoRooms();
  for (const double pitch : {-60.0, 60.0})
    for (double angle = 0; angle < 360; angle += 30)
      expectAsTruth(rooms, cameraAt(SectorId(0), {2, 3, 1.5}, angle, pitch));
}

TEST(Eye, inACornerOfOneDegreeSeesNoHole) {
  // 10 m long, 0.17 m wide at its far end.
  const LoadedLevel corner = levelFrom(levelOf(test::sectorText(
      "corner", fmt::format("0,0, 10,0, 10,{}", 10 * std::tan(std::numbers::pi / 180)), 0, 3)));
  for (const double x : {0.0, 1e-9, 1e-6, 1e-3, 0.1, 5.0})
    for (double angle = 0; angle < 360; angle += 7.5)
      EXPECT_EQ(holesIn(corner, cameraAt(SectorId(0), {x, 0.3 * x / 60, 1.5}, angle)), 0)
          << x << ' ' << angle;
}

TEST(Eye, onAVertexOfManySectorsSeesNoHoleFromAnyOfThem) {
  constexpr int kSectors = 24;
  const auto vertex = [](int i) {
    const double angle = 2 * std::numbers::pi * i / kSectors;
    return fmt::format("{},{}", 5 * std::cos(angle), 5 * std::sin(angle));
  };
  std::string sectors;
  for (int i = 0; i < kSectors; ++i) {
    const std::string before = fmt::format("s{}", (i + kSectors - 1) % kSectors);
    const std::string after = fmt::format("s{}", (i + 1) % kSectors);
    sectors += (i > 0 ? "," : "") +
               test::sectorText(
                   fmt::format("s{}", i), "0,0, " + vertex(i) + ", " + vertex(i + 1), 0.01 * i, 3,
                   "[" + portalTo(before) + "," + kSolid + "," + portalTo(after) + "]");
  }
  const LoadedLevel wheel = levelFrom(levelOf(sectors));
  for (std::size_t i = 0; i < wheel.level.sectors.size(); ++i)
    for (double angle = 0; angle < 360; angle += 15)
      EXPECT_EQ(holesIn(wheel, cameraAt(SectorId(i), {0, 0, 1.5}, angle)), 0) << i << ' ' << angle;
}

TEST(Eye, thatComesNearerInDecimetresSeesNoHole) {
  const LoadedLevel rooms = twoRooms();
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{3, 3}, std::pair{17, 5},
                                      std::pair{64, 40}, std::pair{1, 99}, std::pair{321, 7}})
    for (int step = 0; step <= 80; ++step) {
      const Vec3 eye{step * 0.1, 3.3, 1.5};
      Camera camera = cameraAt(*locatePosition(rooms.scene(), eye, std::nullopt), eye, 0);
      camera.width = width;
      camera.height = height;
      EXPECT_EQ(holesIn(rooms, camera), 0) << eye.x << ' ' << width << 'x' << height;
    }
}

TEST(Eye, thatCrossesAPortalInMillimetresSeesNoPictureJump) {
  const LoadedLevel rooms = twoRooms();
  const BakedLight light = noLightOf(rooms.level);
  const Renderer renderer(rooms.scene(), rooms.textures, light);
  // Through its middle, along its line, and through its end.
  const std::pair<Vec3, Vec3> ways[] = {{{3.95, 4, 1.5}, {4.05, 4.01, 1.5}},
                                        {{4, 3, 1.5}, {4, 3.1, 1.5}},
                                        {{3.95, 0.002, 1.5}, {4.05, 0.002, 1.5}}};
  for (const auto& [from, to] : ways)
    for (const double angle : {0.0, 60.0, 90.0, 180.0}) {
      std::optional<Image> before;
      for (int step = 0; step <= 100; ++step) {
        const Vec3 eye = from + (step / 100.0) * (to - from);
        const auto sector = locatePosition(rooms.scene(), eye, std::nullopt);
        ASSERT_TRUE(sector) << sector.error();
        const Image now = renderer.draw(cameraAt(*sector, eye, angle), LightMode::None);
        // A millimetre moves edges by less than a pixel: by as many pixels as a column has.
        if (before) {
          EXPECT_LE(compare(*before, now).over8, 40) << eye.x << ' ' << eye.y << ' ' << angle;
        }
        before = now;
      }
    }
}

TEST(Eye, seesWallsAsFarAwayAsTruthDoes) {
  for (const double length : {1e4, 1e5, 1e6}) {
    const LoadedLevel hall = levelFrom(levelOf(
        BoxRoom{.x0 = -10, .y0 = -length / 8, .x1 = length, .y1 = length / 8, .ceiling = length / 8}
            .sector("hall")));
    for (const double angle : {0.0, 0.01, 5.0})
      expectAsTruth(hall, cameraAt(SectorId(0), {0, 0, 1.5}, angle));
  }
}

}  // namespace
}  // namespace hearth::extremes
