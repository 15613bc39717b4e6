#include "hearth/import/import_map.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hearth/import/convert.h"
#include "hearth/import/ground_plan.h"
#include "hearth/import/lights.h"
#include "hearth/import/map.h"
#include "hearth/import/materials.h"
#include "hearth/layout.h"
#include "image/replace_file.h"

namespace hearth::doom {

namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

/// The level's file without its `.json`.
fs::path stemFor(const fs::path& folder, const std::string& map) { return folder / fileName(map); }

tl::expected<void, std::string> writeNew(const fs::path& file, const Json& json) {
  const auto text = layOut(json.dump(), std::numeric_limits<std::uint64_t>::max());
  const auto written = createFile(file, [&](std::ostream& stream) {
    stream << *text;
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
tl::expected<void, std::string> write(const fs::path& stem, const Materials& materials,
                                      const Json& lights, const Json& level) {
  if (auto written = materials.write(stem.parent_path() / "textures"); !written) return written;
  const fs::path lightsFile = fs::path(stem) += ".lights.json";
  if (auto written = writeNew(lightsFile, lights); !written) return written;
  auto written = writeNew(fs::path(stem) += ".json", level);
  std::error_code ignored;
  if (!written) fs::remove(lightsFile, ignored);
  return written;
}

}  // namespace

tl::expected<Imported, std::string> importMap(const Source& source, const std::string& name,
                                              const ImportSettings& settings) {
  const auto map = readMap(source.wad, name);
  if (!map) return tl::unexpected(map.error());
  const fs::path stem = stemFor(settings.folder, name);
  Imported imported;
  imported.map = name;
  imported.level = fs::path(stem) += ".json";
  const GroundPlan plan(*map, settings.doors, imported.findings);
  if (plan.regions().empty())
    return tl::unexpected(name + ": its lines enclose nothing: there is no level in it");
  Materials materials(source.pictures, name, imported.findings);
  const Json level = levelJson(plan, settings.ambient, materials, imported.findings);
  const Json lights = lightsJson(plan, source.lights, imported.findings);
  if (auto written = write(stem, materials, lights, level); !written)
    return tl::unexpected(written.error());

  imported.mapSectors = map->sectors.size();
  imported.sectors = plan.regions().size();
  imported.lines = map->lines.size();
  for (const auto& region : plan.regions())
    for (const auto& loop : region.loops) imported.walls += loop.size();
  imported.lights = lights["lights"].size();
  imported.textures = materials.count();
  return imported;
}

}  // namespace hearth::doom
