#include "peers/peer_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/doom/import_map.h"
#include "math/parallel.h"

namespace hearth {

namespace {

constexpr LoadLimits kLimits;

tl::expected<std::filesystem::path, std::string> imported(const std::string& map,
                                                          const std::filesystem::path& folder) {
  const auto wad = doom::Wad::open(freedoomWad(map), kLimits.fileBytes);
  if (!wad) return tl::unexpected(wad.error() + ": apt-get install freedoom");
  const auto pictures = doom::Pictures::read(*wad);
  if (!pictures) return tl::unexpected(pictures.error());
  const auto lights = doom::parseLightTable(doom::ownLightTable());
  if (!lights) return tl::unexpected(lights.error());
  doom::ImportSettings settings{.folder = folder, .doors = doom::Doors::Closed};
  settings.things.game.skill = 4;  // as in the demos that dsda-doom plays
  return doom::importMap({*wad, *pictures, *lights}, map, settings)
      .map([](const doom::Imported& made) { return made.level; });
}

tl::expected<LoadedLevel, std::string> loaded(const std::filesystem::path& file) {
  LoadResult result = loadLevel(file, kLimits);
  if (!result.loaded) return tl::unexpected(format(result.diagnostics.front()));
  return *std::move(result.loaded);
}

}  // namespace

PeerLevel::PeerLevel(LoadedLevel level)
    : loaded(std::move(level)),
      light(bake(loaded.scene(), loaded.level.bake, availableThreads())),
      renderer(loaded.scene(), loaded.textures, light) {}

PeerLevel::PeerLevel(LoadedLevel level, Unlit)
    : loaded(std::move(level)), renderer(loaded.scene(), loaded.textures, light) {
  light.surfaces.resize(loaded.level.surfaces.size());
  light.lightmaps.resize(loaded.level.surfaces.size());
}

PeerInputs::PeerInputs(std::filesystem::path levels, Clock clock)
    : levels_(std::move(levels)), clock_(std::move(clock)) {}

tl::expected<std::filesystem::path, std::string> PeerInputs::freedoomFile(const std::string& map) {
  std::filesystem::path& file = freedoomFiles_[map];
  if (!file.empty()) return file;
  auto level = imported(map, folder() / map);
  if (level) file = *level;
  return level;
}

tl::expected<const PeerLevel*, std::string> PeerInputs::level(const std::filesystem::path& file) {
  std::unique_ptr<PeerLevel>& known = ownLevels_[file];
  if (known) return known.get();
  return loaded(file).map([&](LoadedLevel level) {
    known = std::make_unique<PeerLevel>(std::move(level));
    return known.get();
  });
}

tl::expected<const PeerLevel*, std::string> PeerInputs::whiteLitLevel(
    const std::filesystem::path& file) {
  std::unique_ptr<PeerLevel>& known = whiteLitLevels_[file];
  if (known) return known.get();
  return loaded(file).map([&](LoadedLevel level) {
    for (LightSource& light : level.level.lights) std::ranges::fill(light.color, 255);
    known = std::make_unique<PeerLevel>(std::move(level));
    return known.get();
  });
}

tl::expected<const PeerLevel*, std::string> PeerInputs::freedoomLevel(const std::string& map) {
  return freedoomFile(map).and_then([&](const std::filesystem::path& file) { return level(file); });
}

std::filesystem::path freedoomWad(std::string_view map) {
  return fmt::format("/usr/share/games/doom/freedoom{}.wad", map.starts_with("MAP") ? 2 : 1);
}

}  // namespace hearth
