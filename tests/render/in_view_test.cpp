// That a frame is the same where only what it reads of the light was baked.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <optional>

#include "load/load.h"
#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "render/texels_in_view.h"

namespace hearth {
namespace {

class RandomLevels {
 public:
  RandomLevels() { EXPECT_TRUE(writeRandomLevelTextures(folder_ / "textures")); }
  ~RandomLevels() { std::filesystem::remove_all(folder_); }
  RandomLevels(const RandomLevels&) = delete;
  RandomLevels& operator=(const RandomLevels&) = delete;

  LoadedLevel load(std::uint64_t seed) const {
    const RandomLevel random = makeRandomLevel(seed);
    EXPECT_TRUE(writeRandomLevel(folder_, random));
    return loadLevel(folder_ / (random.name + ".json")).loaded.value();
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("hearth-in-view-{}", ::getpid());
};

BakeSettings bakeOf(const Level& level, std::uint64_t seed) {
  constexpr std::array<std::optional<int>, 4> kSamples = {1, 4, 1, std::nullopt};
  BakeSettings settings = level.bake;
  settings.texel = 0.25;
  settings.samples = kSamples[seed % kSamples.size()];
  return settings;
}

constexpr std::array kFrames = {
    DrawSettings{},
    DrawSettings{.lightFilter = LightFilter::Nearest},
    DrawSettings{.pixelSize = 3},
};

std::int64_t texelsOf(const WantedTexels& wanted) {
  std::int64_t sum = 0;
  for (const SurfaceTexels& part : wanted.surfaces) sum += part.texels.count();
  return sum;
}

std::int64_t raysToMeshes(const Level& level, const BakedLight& light) {
  std::int64_t sum = 0;
  for (const Mesh& mesh : level.meshes) sum += light.surfaceCosts[mesh.surface.index()].rays;
  return sum;
}

TEST(TexelsInView, areAllThatFramesOfRandomLevelsRead) {
  const RandomLevels levels;
  std::int64_t read = 0;
  std::int64_t all = 0;
  std::int64_t raysInView = 0;
  std::int64_t allRays = 0;
  for (std::uint64_t seed = 700; seed < 760; ++seed) {
    const LoadedLevel loaded = levels.load(seed);
    const Level& level = loaded.level;
    const Scene scene = loaded.scene();
    const BakeSettings bakeSettings = bakeOf(level, seed);
    const BakedLight whole = bake(scene, bakeSettings, 2);
    for (std::size_t i = 0; i < level.shots.size(); ++i) {
      SCOPED_TRACE(fmt::format("seed {}, shot {}", seed, i));
      const Camera camera = cameraOf(level.shots[i]);
      const DrawSettings& settings = kFrames[(seed + i) % kFrames.size()];
      const auto inView = texelsInView(scene, whole.surfaces, camera, settings);
      const BakedLight part = bakeOnly(inView, whole.surfaces, scene, bakeSettings, 2);
      for (const LightMode mode : {LightMode::Both, LightMode::Only})
        ASSERT_EQ(Renderer(scene, loaded.textures, part, settings).draw(camera, mode),
                  Renderer(scene, loaded.textures, whole, settings).draw(camera, mode));
      read += texelsOf(inView);
      all += whole.stats.texels;
      raysInView += raysToMeshes(level, part);
      allRays += raysToMeshes(level, whole);
    }
  }
  EXPECT_LT(5 * read, all);
  EXPECT_LT(5 * raysInView, allRays);
}

}  // namespace
}  // namespace hearth
