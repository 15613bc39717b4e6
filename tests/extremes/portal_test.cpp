// Portals that lead back, to their own sector, or on for ever so long.

#include <gtest/gtest.h>

#include <functional>

#include "as_truth.h"
#include "changes.h"
#include "rooms.h"
#include "support/canvas.h"

namespace hearth::extremes {
namespace {

using test::levelFrom;

TEST(Portals, ofAGridAreLookedThroughOnceEach) {
  const LoadedLevel grid = levelFrom(levelOf(gridOfRooms(30, 30)));
  const BakedLight light = noLightOf(grid.level);
  const Renderer renderer(grid.scene(), grid.textures, light);
  for (double angle = 0; angle < 360; angle += 22.5) {
    const Camera camera{SectorId(0), {0.5, 0.5, 1.5}, angle, 0, 90, 160, 100};
    EXPECT_EQ(holesIn(grid, camera), 0) << angle;
    FrameScratch scratch;
    test::Canvas picture(camera.width, camera.height);
    renderer.draw(camera, LightMode::None, scratch, picture);
    // A column's ray enters a room at most once. Rooms are looked into again for what is seen past
    // another corner, but no more often than there are columns.
    EXPECT_LE(scratch.found().viewports, 160 * 60) << angle;
  }
}

TEST(Portals, ofThreeRoomsInARingEndWhereTheLookEnds) {
  // Round a common corner, 270 degrees: each opens to the next, the last to the first through a
  // room that overlaps it.
  const auto room = [](double x, double y) {
    return BoxRoom{.x0 = x, .y0 = y, .x1 = x + 4, .y1 = y + 4};
  };
  const LoadedLevel ring = levelFrom(
      levelOf(room(0, 0).sector(
                  "a", fmt::format("[{0}, {1}, {2}, {0}]", kSolid, portalTo("b"), portalTo("c"))) +
              "," +
              room(4, 0).sector(
                  "b", fmt::format("[{0}, {0}, {1}, {2}]", kSolid, portalTo("d"), portalTo("a"))) +
              "," +
              room(4, 4).sector(
                  "d", fmt::format("[{1}, {0}, {0}, {2}]", kSolid, portalTo("b"), portalTo("c"))) +
              "," +
              room(0, 4).sector(
                  "c", fmt::format("[{1}, {2}, {0}, {0}]", kSolid, portalTo("a"), portalTo("d")))));
  for (double angle = 0; angle < 360; angle += 10)
    expectAsTruth(ring, {SectorId(0), {3, 3, 1.5}, angle, 0, 90, 64, 40});
}

TEST(Portals, toTheirOwnSectorAreRefused) {
  const LoadResult result = tryLoad(filesOf(levelOf(
      BoxRoom{}.sector("room", fmt::format("[{0}, {1}, {0}, {0}]", kSolid, portalTo("room"))))));
  EXPECT_FALSE(result.loaded);
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].pointer, "/sectors/room/loops/border/walls/1");
}

TEST(Portals, aThousandInOneLineOfSightAreAllLookedThrough) {
  // The middle column and row look straight through all of them.
  const LoadedLevel row = levelFrom(levelOf(gridOfRooms(1000, 1)));
  const Camera camera{SectorId(0), {0.1, 0.5, 1.5}, 0, 0, 30, 161, 101};
  EXPECT_EQ(holesIn(row, camera), 0);
  const BakedLight light = noLightOf(row.level);
  FrameScratch scratch;
  test::Canvas picture(camera.width, camera.height);
  Renderer(row.scene(), row.textures, light).draw(camera, LightMode::None, scratch, picture);
  EXPECT_EQ(scratch.found().viewports, 1000) << "each room is looked into once";
}

}  // namespace
}  // namespace hearth::extremes
