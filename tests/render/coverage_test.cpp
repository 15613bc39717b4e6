// Every pixel of an enclosed level is covered exactly once, from wherever one looks.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "level/locate.h"
#include "load/load.h"
#include "render/frame_scratch.h"
#include "render/renderer.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr Rgb kOnce = {0, 160, 0};  // of Channel::Overdraw

BakedLight withoutLight(const Level& level) {
  BakedLight light;
  light.surfaces.resize(level.surfaces.size());
  light.lightmaps.resize(level.surfaces.size());
  return light;
}

class Coverage : public testing::Test {
 protected:
  Coverage()
      : loaded_(loadLevel(test::inTree("levels/tutorial.json")).loaded.value()),
        light_(withoutLight(loaded_.level)),
        renderer_(loaded_.scene(), loaded_.textures, light_) {}

  const Level& level() const { return loaded_.level; }
  Scene scene() const { return loaded_.scene(); }

  void expectCoveredOnce(const Camera& camera) const {
    const Image drawn = renderer_.draw(camera, Channel::Overdraw);
    int wrong = 0;
    for (const Rgb pixel : drawn.pixels()) wrong += pixel == kOnce ? 0 : 1;
    EXPECT_EQ(wrong, 0) << fmt::format("{}x{} at {},{},{} in {} angle {} pitch {} fov {}",
                                       camera.width, camera.height, camera.eye.x, camera.eye.y,
                                       camera.eye.z, level()[camera.sector].name, camera.angle,
                                       camera.pitch, camera.fov);
  }

 private:
  LoadedLevel loaded_;
  BakedLight light_;
  Renderer renderer_;
};

TEST_F(Coverage, isCompleteAtEverySize) {
  constexpr std::pair<int, int> kSizes[] = {{1, 1}, {1, 200},   {200, 1},
                                            {3, 3}, {320, 200}, {2045, 960}};
  for (const Shot& shot : level().shots)
    for (const auto& [width, height] : kSizes) {
      Camera camera = cameraOf(shot);
      camera.width = width;
      camera.height = height;
      expectCoveredOnce(camera);
    }
}

TEST_F(Coverage, isCompleteForEveryFieldOfViewAndPitch) {
  for (const Shot& shot : level().shots)
    for (const double fov : {1.0, 30.0, 90.0, 150.0, 179.0})
      for (const double pitch : {-60.0, -7.0, 0.0, 45.0, 60.0}) {
        Camera camera = cameraOf(shot);
        camera.fov = fov;
        camera.pitch = pitch;
        expectCoveredOnce(camera);
      }
}

TEST_F(Coverage, isCompleteFromEveryVertexAndEveryMiddleOfAWall) {
  for (const Segment& segment : level().segments) {
    const Sector& sector = level()[segment.sector];
    for (const double fraction : {0.0, 0.5}) {
      const Vec2 p = lerp(segment.p0, segment.p1, fraction);
      const double z = (scene().airBottom(sector, p) + scene().airTop(sector, p)) / 2;
      for (const double angle : {0.0, 45.0, 90.0, 137.0, 180.0, 270.0, 301.0})
        expectCoveredOnce({segment.sector, {p.x, p.y, z}, angle, 0, 100, 61, 31});
    }
  }
}

TEST_F(Coverage, isCompleteALittleOffEveryWall) {
  for (const Segment& segment : level().segments) {
    const Sector& sector = level()[segment.sector];
    const Vec2 along = segment.p1 - segment.p0;
    const double angle = compassDegrees(along);
    for (const double distance : {1e-12, 1e-9, 1e-6, 1e-3}) {
      const Vec2 p =
          lerp(segment.p0, segment.p1, 0.37) + (distance / segment.length) * turned90(along);
      if (!contains(level(), sector, p)) continue;
      const double z = (scene().airBottom(sector, p) + scene().airTop(sector, p)) / 2;
      for (const double turn : {0.0, 90.0, 180.0, 270.0})
        expectCoveredOnce({segment.sector, {p.x, p.y, z}, angle + turn, 0, 90, 61, 31});
    }
  }
}

TEST_F(Coverage, isCompleteWithTheEyeOnFloorsAndCeilings) {
  for (const Shot& shot : level().shots) {
    const Sector& sector = level()[shot.sector];
    for (const double z :
         {scene().airBottom(sector, shot.eye.xy()), scene().airTop(sector, shot.eye.xy())})
      for (const double pitch : {-60.0, 0.0, 60.0}) {
        Camera camera = cameraOf(shot);
        camera.eye.z = z;
        camera.pitch = pitch;
        expectCoveredOnce(camera);
      }
  }
}

/// What holes would show is painted only where spans leave a pixel open.
TEST(FrameScratch, knowsWhichStripsSpansFill) {
  constexpr int kRows = 10;
  const SurfaceId wall(0);
  FrameScratch scratch;
  scratch.parts.resize(1);
  scratch.parts[0].range = {0, 2 * Strip::kColumns + 3};  // the last strip is narrower
  VisibleSpans& found = scratch.parts[0].visibility.found;
  found.level.clear(0, 3);
  found.overLevel.clear(0, 3);
  const auto add = [&](SpanGroups& to, int column, int begin, int end) {
    LaneRowRanges rows;
    rows.begin[static_cast<std::size_t>(column % Strip::kColumns)] = begin;
    rows.end[static_cast<std::size_t>(column % Strip::kColumns)] = end;
    to.add(wall, column / Strip::kColumns, rows);
  };
  const auto filled = [&] {
    return std::vector{scratch.isFilled(0, kRows), scratch.isFilled(1, kRows),
                       scratch.isFilled(2, kRows)};
  };
  for (int column = 0; column < scratch.parts[0].range.end; ++column) {
    add(found.level, column, 4, kRows);
    add(found.level, column, 0, column == 10 ? 3 : 4);
  }
  EXPECT_EQ(filled(), (std::vector{true, false, true}));
  // A masked middle texture can have holes.
  add(found.overLevel, 10, 3, 4);
  EXPECT_EQ(filled(), (std::vector{true, false, true}));
  add(found.level, 10, 3, 4);
  EXPECT_EQ(filled(), (std::vector{true, true, true}));
}

TEST(CoverageOfWedges, isCompleteWhereHeightsThatAreOffWouldPassTheFloor) {
  // The heights' plane is 0.2 mm below the floor in the corner (5, 12).
  const LoadedLevel loaded = test::levelFrom(
      "{'light': 1, 'sectors': {'a': {'floor': {'texture': '#808080'}, "
      "'ceiling': {'texture': '#808080'}, 'slopeFloor': {'z': [0, 0.5, 0.4998, null]}, "
      "'loops': {'border': {'v': [1,12, 1,7, 5,7, 5,12], 'walls': {'texture': '#808080'}}}}}}");
  const BakedLight light = withoutLight(loaded.level);
  const Renderer renderer(loaded.scene(), loaded.textures, light);
  for (double z = 0.01; z < 0.02; z += 0.0001) {
    const Image drawn =
        renderer.draw({SectorId(0), {4.9, 11.9, z}, 45, 0, 90, 61, 301}, Channel::Overdraw);
    EXPECT_EQ(std::ranges::count(drawn.pixels(), kHole), 0) << z;
  }
}

}  // namespace
}  // namespace hearth
