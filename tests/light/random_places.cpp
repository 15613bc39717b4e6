#include "random_places.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "light/sampling/sample_placement.h"
#include "load/load.h"
#include "random_levels/random_level.h"

namespace hearth::test {

namespace {

void askInLevel(const Scene& scene, const std::function<void(const RandomPlace&)>& ask) {
  const LitSurfaces surfaces = makeLitSurfaces(scene, 0.25);
  for (const SurfaceId id : scene.shownSurfaces()) {
    const std::optional<LitSurface>& lit = surfaces[id.index()];
    if (!lit) continue;
    const TexelRect rect = lit->texels;
    const SamplePoint at =
        SamplePlacement(surfaces, id)
            .place({rect.i0 + rect.width / 2 + 0.5, rect.j0 + rect.height / 3 + 0.5});
    ask({scene, at.target, scene[at.surface].sector, surfaces[at.surface.index()]->normal});
  }
}

}  // namespace

void forEachRandomPlace(const std::function<void(Level&)>& change,
                        const std::function<void(const RandomPlace&)>& ask) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-places-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  for (std::uint64_t seed = 1; seed <= 60 && !testing::Test::HasFailure(); ++seed) {
    const RandomLevel random = makeRandomLevel(seed);
    ASSERT_TRUE(writeRandomLevel(folder, random));
    LoadResult result = loadLevel(folder / (random.name + ".json"));
    ASSERT_TRUE(result.loaded) << seed;
    change(result.loaded->level);
    askInLevel(result.loaded->scene(), ask);
  }
  std::filesystem::remove_all(folder);
}

}  // namespace hearth::test
