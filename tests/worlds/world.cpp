#include "worlds/world.h"

#include <fmt/format.h>

#include "agreement/compare_level.h"
#include "import/doom/import_map.h"
#include "light/bakery.h"
#include "load/load.h"
#include "measure/level_bench.h"
#include "render/renderer.h"
#include "worlds/standing_places.h"

namespace hearth::worlds {

namespace {

constexpr ImageSize kFrame{320, 200};  ///< of which the time is taken

/// Reads the level of the map, or says what is wrong with it.
std::optional<LoadedLevel> importAndLoad(const Archive& archive, World& world,
                                         const std::filesystem::path& folder) {
  const doom::LightTable lights = doom::parseLightTable(doom::ownLightTable()).value();
  const auto imported = doom::importMap({archive.wad(), archive.pictures(), lights}, world.map,
                                        {.folder = folder, .doors = doom::Doors::Open});
  if (!imported) {
    world.errors.push_back(imported.error());
    return std::nullopt;
  }
  world.repairs = imported->findings.size();
  LoadResult result = loadLevel(imported->level);
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.isError) world.errors.push_back(format(diagnostic));
  return std::move(result.loaded);
}

void measureBakeAndFrames(const LoadedLevel& loaded, World& world) {
  const Level& level = loaded.level;
  const Scene scene = loaded.scene();
  const double begin = steadySeconds();
  const BakedLight light = bake(scene, level.bake, 1);
  world.bakeSeconds = steadySeconds() - begin;
  world.texels = light.stats.texels;

  const Renderer renderer(scene, loaded.textures, light);
  FrameScratch scratch;
  PixelBuffer memory;
  const PixelRows picture = memory.rows(kFrame.width, kFrame.height);
  std::vector<double> milliseconds;
  for (const Shot& shot : level.shots) {
    Camera camera = cameraOf(shot);
    camera.width = kFrame.width;
    camera.height = kFrame.height;
    renderer.draw(camera, LightMode::Both, scratch, picture);  // takes the memory
    const double start = steadySeconds();
    renderer.draw(camera, LightMode::Both, scratch, picture);
    milliseconds.push_back(1e3 * (steadySeconds() - start));
  }
  world.frameMilliseconds = spreadOf(milliseconds).median;
}

}  // namespace

tl::expected<Archive, std::string> Archive::open(const std::filesystem::path& path) {
  auto wad = doom::Wad::open(path, LoadLimits{}.fileBytes);
  if (!wad) return tl::unexpected(wad.error());
  auto pictures = doom::Pictures::read(*wad);
  if (!pictures) return tl::unexpected(fmt::format("{}: {}", path.string(), pictures.error()));
  return Archive(std::move(*wad), std::move(*pictures));
}

World lookAt(const Archive& archive, const std::string& map, const Looks& looks,
             const std::filesystem::path& folder) {
  World world;
  world.map = map;
  auto loaded = importAndLoad(archive, world, folder / map);
  if (loaded) {
    Level& level = loaded->level;
    world.sectors = level.sectors.size();
    world.segments = level.segments.size();
    level.bake.texel = looks.texel;
    level.shots = standingPlaces(level, looks.places, looks.seed, looks.size);
    measureBakeAndFrames(*loaded, world);
    world.tally = agreement::compareLevel(*loaded, map, level.shots.size());
  }
  std::filesystem::remove_all(folder / map);
  return world;
}

std::string tableHead() {
  return "| map | sectors | segments | texels | bake, s | frame, ms | views | holes | textures off "
         "| light off | repairs |\n"
         "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
}

std::string tableRow(const World& world) {
  if (!world.errors.empty())
    return fmt::format("| {} | does not load: {} mistakes | | | | | | | | | |\n", world.map,
                       world.errors.size());
  const agreement::KindTally all = world.tally.sum();
  return fmt::format("| {} | {} | {} | {} | {:.2f} | {:.2f} | {} | {} | {} | {} | {} |\n",
                     world.map, world.sectors, world.segments, world.texels, world.bakeSeconds,
                     world.frameMilliseconds, world.tally.views, world.tally.holes,
                     all.texture.missed, all.gridLight.missed + all.exactLight.missed,
                     world.repairs);
}

}  // namespace hearth::worlds
