// Pictures, levels and lights of extreme number, with what they take. Times are only printed, but
// for bounds that a mistake of n squared would break.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <numbers>

#include "as_truth.h"
#include "light/bakery.h"
#include "rooms.h"
#include "support/in_tree.h"
#include "truth/truth_light.h"
#include "truth/truth_view.h"

namespace hearth::extremes {
namespace {

using test::levelFrom;

constexpr double kSeconds = 240;  ///< a multiple of what each takes on two slow cores together
constexpr double kGigabytes = 3;  ///< of memory, at most, for all of this program

/// Of processor time, which does not pass while other programs run.
double seconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double maxGigabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

void expectBounded(std::string_view what, const std::function<void()>& work) {
  const double took = seconds(work);
  fmt::print("{}: {:.2f} s, {:.2f} GB at most so far\n", what, took, maxGigabytes());
  EXPECT_LT(took, kSeconds) << what;
  EXPECT_LT(maxGigabytes(), kGigabytes) << what;
}

LoadedLevel shippedLevel(std::string_view name) {
  return loadLevel(test::inTree(fmt::format("levels/{}.json", name))).loaded.value();
}

TEST(Large, picturesOfEveryShotHaveNoHole) {
  const LoadedLevel tutorial = shippedLevel("tutorial");
  for (std::size_t i = 0; i < tutorial.level.shots.size(); i += 4) {
    Camera camera = cameraOf(tutorial.level.shots[i]);
    camera.width = 7680;
    camera.height = 4320;
    EXPECT_EQ(holesIn(tutorial, camera), 0) << tutorial.level.shots[i].name;
  }
}

TEST(Large, pictureOfACheckeredFloorTurnsSlowlyAsTruth) {
  LoadedLevel hall = levelFrom(levelOf(
      BoxRoom{.x0 = -50, .y0 = -50, .x1 = 50, .y1 = 50, .floorTexture = "'brick'"}.sector("hall")));
  Image checker(2, 2, {255, 255, 255});
  checker.at(0, 0) = checker.at(1, 1) = {0, 0, 0};
  std::vector<Image> images = hall.textures;
  images[1] = checker;
  hall.textures = SharedImages(std::move(images));
  for (double angle = 30; angle < 31; angle += 0.13)
    expectAsTruth(hall, {SectorId(0), {0.3, 0.7, 1.6}, angle, -10, 90, 1920, 1200}, 11);
}

TEST(Large, levelOfAHundredThousandSectorsIsLoadedLitAndDrawn) {
  std::optional<LoadedLevel> grid;
  expectBounded("100,489 sectors: load",
                [&] { grid = levelFrom(levelOf(gridOfRooms(317, 317), "0")); });
  LightSource light;
  light.position = {158.5, 158.5, 1.5};
  light.sector = SectorId(158 * 317 + 158);
  light.falloff = 1;
  grid->level.lights.push_back(light);
  std::optional<BakedLight> baked;
  expectBounded("one light, texels of a metre: bake",
                [&] { baked = bake(grid->scene(), {.texel = 1}, 2); });
  EXPECT_GT(baked->stats.litSurfaces, 0U);
  const Renderer renderer(grid->scene(), grid->textures, *baked);
  expectBounded("a frame of 320 x 200", [&] {
    (void)renderer.draw({light.sector, light.position, 30, 0, 90, 320, 200}, LightMode::Both);
  });
}

TEST(Large, sectorOfTenThousandVerticesIsLitAndDrawn) {
  std::string vertices;
  for (int i = 0; i < 10'000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 10'000;
    vertices +=
        fmt::format("{}{},{}", i > 0 ? ", " : "", 50 * std::cos(angle), 50 * std::sin(angle));
  }
  const LoadedLevel disc = levelFrom(levelOf(test::sectorText("disc", vertices, 0, 3), "0"),
                                     "[{'x': 10, 'y': 3, 'z': 2, 'falloff': 0.1}]");
  std::optional<BakedLight> baked;
  expectBounded("10,000 vertices, texels of 2 m: bake",
                [&] { baked = bake(disc.scene(), {.texel = 2}, 2); });
  const Camera camera{SectorId(0), {1, 2, 1.5}, 30, 0, 90, 320, 200};
  EXPECT_EQ(holesIn(disc, camera), 0);
  expectBounded("a frame of 320 x 200", [&] {
    (void)Renderer(disc.scene(), disc.textures, *baked).draw(camera, LightMode::Both);
  });
}

TEST(Large, numberOfLightsIsBaked) {
  LoadedLevel room = levelFrom(levelOf(BoxRoom{.x1 = 100, .y1 = 100}.sector("room"), "0"),
                               "[{'x': 1, 'y': 1, 'z': 1}]");
  const LightSource first = room.level.lights[0];
  room.level.lights.clear();
  for (int i = 0; i < 10'000; ++i) {
    LightSource light = first;
    light.position = {0.5 + i % 100, 0.5 + i / 100, 2};
    light.intensity = 0.01;
    room.level.lights.push_back(light);
  }
  std::optional<BakedLight> baked;
  expectBounded("10,000 lights on texels of 2 m: bake",
                [&] { baked = bake(room.scene(), {.texel = 2}, 2); });
  // Each gives a hundredth of a level: too little alone, 100 levels together.
  for (const auto& map : baked->lightmaps) {
    ASSERT_TRUE(map.has_value());
    for (const std::uint8_t level : map->levels) ASSERT_EQ(level, 100);
  }
}

/// How baked light differs from truth at places that shots of a level show.
struct LightError {
  double squares = 0;
  int places = 0;
  int over2 = 0;

  double rms() const { return std::sqrt(squares / places); }
};

void addErrors(const LoadedLevel& loaded, double texel, LightError& error) {
  BakeSettings settings = loaded.level.bake;
  settings.texel = texel;
  settings.samples = 1;
  const BakedLight light = bake(loaded.scene(), settings, 2);
  const TruthLight truth(loaded.level);
  const std::vector<SurfaceId> shown = loaded.scene().shownSurfaces();
  for (const Shot& shot : loaded.level.shots) {
    const TruthView view(loaded.level, loaded.textures, shot);
    for (double j = 3.5; j < shot.height; j += 23)
      for (double i = 2.5; i < shot.width; i += 17) {
        const TruthHit hit = view.hit(i, j);
        if (isSky(hit.kind)) continue;
        for (const SurfaceId id : shown) {
          const Surface& surface = loaded.level[id];
          const auto& lit = light.surfaces[id.index()];
          if (surface.kind != hit.kind || surface.sector != hit.sector ||
              surface.segment != hit.segment || !lit)
            continue;
          const Vec2 st = lit->grid.toTexels(hit.point);
          if (!lit->outline.contains(st)) continue;
          const auto& map = light.lightmaps[id.index()];
          const double miss =
              (map ? map->sample(st.x, st.y) : 0) - std::min(255.0, truth.at(hit).x);
          error.squares += miss * miss;
          error.over2 += std::abs(miss) > 2 ? 1 : 0;
          ++error.places;
          break;
        }
      }
  }
}

TEST(Large, numberOfTexelsBringsLightNearerToTruth) {
  std::vector<LoadedLevel> levels;
  for (const char* name : {"tutorial", "keep"}) {
    levels.push_back(shippedLevel(name));
    for (LightSource& light : levels.back().level.lights) light.radius = 0;
    levels.back().level.shots.resize(std::min<std::size_t>(levels.back().level.shots.size(), 8));
  }
  LightError before{1e9, 1, 1'000'000};
  for (const double texel : {1.0, 1.0 / 2, 1.0 / 4, 1.0 / 8, 1.0 / 16, 1.0 / 32}) {
    LightError error;
    for (const LoadedLevel& level : levels) addErrors(level, texel, error);
    fmt::print("texels of 1/{:<2.0f} m: {} places, rms {:.2f} levels, {:.2f} % over 2\n", 1 / texel,
               error.places, error.rms(), 100.0 * error.over2 / error.places);
    EXPECT_LT(error.rms(), before.rms()) << texel;
    EXPECT_LT(error.over2, before.over2) << texel;
    before = error;
  }
}

}  // namespace
}  // namespace hearth::extremes
