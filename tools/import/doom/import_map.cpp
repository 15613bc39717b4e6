#include "import/doom/import_map.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "files/replace_file.h"
#include "folders/temporary_folder.h"
#include "import/doom/convert.h"
#include "import/doom/ground_plan.h"
#include "import/doom/map.h"
#include "load/load.h"
#include "text/json_layout.h"

namespace hearth::doom {

namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

/// The level's file without its `.json`.
fs::path stemFor(const fs::path& folder, const std::string& map) { return folder / fileName(map); }

std::string textOf(const Json& json) {
  return layOut(json.dump(), std::numeric_limits<std::uint64_t>::max()).value();
}

tl::expected<void, std::string> writeNew(const fs::path& file, const std::string& text) {
  const auto written = createFile(file, [&](std::ostream& stream) {
    stream << text;
    return stream.good();
  });
  if (!written) return tl::unexpected(written.error());
  if (!*written)
    return tl::unexpected(fmt::format(
        "{} is there already: remove it, or give another folder with -o", file.string()));
  return {};
}

/// The level comes last, so that it is there only where all is that it needs. Where there is one
/// already, no lights are left beside it.
tl::expected<void, std::string> write(const Converted& converted, const fs::path& stem) {
  if (auto written = converted.materials.write(stem.parent_path() / "textures"); !written)
    return written;
  const fs::path lightsFile = fs::path(stem) += ".lights.json";
  if (auto written = writeNew(lightsFile, converted.lights); !written) return written;
  auto written = writeNew(fs::path(stem) += ".json", converted.level);
  std::error_code ignored;
  if (!written) fs::remove(lightsFile, ignored);
  return written;
}

/// Converting leaves nothing that would be refused; a mistake in it must not cost the user what a
/// level that does not load would. Limits of loading are told here, too.
tl::expected<void, std::string> tryLoading(const Converted& converted, const std::string& name) {
  const TemporaryFolder folder;
  const fs::path stem = stemFor(folder.path(), name);
  if (auto written = write(converted, stem); !written) return written;
  for (const Diagnostic& diagnostic : loadLevel(fs::path(stem) += ".json").diagnostics)
    if (diagnostic.isError)
      return tl::unexpected(fmt::format("{}: its level would not load, and is not written: {}",
                                        name, diagnostic.message));
  return {};
}

}  // namespace

tl::expected<Converted, std::string> convertMap(const Source& source, const std::string& name,
                                                const ImportSettings& settings,
                                                Imported& imported) {
  const auto map = readMap(source.wad, name);
  if (!map) return tl::unexpected(map.error());
  const auto plan = GroundPlan::of(*map, settings.doors, imported.findings);
  if (!plan) return tl::unexpected(fmt::format("{}: {}", name, plan.error()));
  Materials materials(source.pictures, name, imported.findings, settings.imagePixels);
  Json level = levelJson(*plan, settings.ambient, materials, imported.findings);
  Sprites sprites(source.pictures, materials, imported.findings);
  Json things = spritesJson(*plan, sprites, settings.things, imported.findings);
  imported.sprites = things.size();
  if (!things.empty()) level["things"] = std::move(things);
  level["$things"] = allThingsJson(*map);
  const Json lights =
      lightsJson(*plan, source.lights, materials,
                 {settings.things.game, settings.lightFrom, settings.lights}, imported.findings);

  imported.map = name;
  imported.level = stemFor(settings.folder, name) += ".json";
  imported.mapSectors = map->sectors.size();
  imported.sectors = plan->regions().size();
  imported.lines = map->lines.size();
  for (const auto& region : plan->regions())
    for (const auto& loop : region.loops) imported.walls += loop.size();
  imported.mapThings = map->things.size();
  imported.lights = lights["lights"].size();
  imported.emitters = lights.contains("emit") ? lights["emit"].size() : 0;
  imported.textures = materials.count();
  imported.movers = plan->movers().movers.size();
  imported.specials = plan->movers().lines;
  return Converted{textOf(level), textOf(lights), std::move(materials)};
}

tl::expected<Imported, std::string> importMap(const Source& source, const std::string& name,
                                              const ImportSettings& settings) {
  Imported imported;
  const auto converted = convertMap(source, name, settings, imported);
  if (!converted) return tl::unexpected(converted.error());
  if (auto loaded = tryLoading(*converted, name); !loaded) return tl::unexpected(loaded.error());
  if (auto written = write(*converted, stemFor(settings.folder, name)); !written)
    return tl::unexpected(written.error());
  return imported;
}

}  // namespace hearth::doom
