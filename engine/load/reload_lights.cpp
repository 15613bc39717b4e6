#include <utility>

#include "load/json/read_document.h"
#include "load/link/link.h"
#include "load/read/read.h"
#include "load/source.h"

namespace hearth {

namespace {

constexpr std::uint32_t kLights = 1;  // among files and documents: the level's own is the first

/// The level with these lights in place of its own.
Level levelWith(const LightsDescription& lights, const LoadedLevel& loaded,
                const LevelSource& source, Report& report) {
  const SectorNames names(source.level);
  TextureTable textures;
  Linking linking{source.level,    report, names, textures, loaded.level,
                  loaded.geometry, {},     {},    {},       {}};
  linking.level.lights.clear();
  linking.isDoubtful.resize(loaded.level.sectors.size());
  linkLights(linking, lights);
  return std::move(linking.level);
}

}  // namespace

std::optional<LoadResult> reloadLights(const LoadedLevel& loaded, LevelSource& source,
                                       const LoadLimits& limits,
                                       const std::optional<std::string>& unsavedLights,
                                       const FileSource& files) {
  if (source.documents.size() <= kLights) return std::nullopt;
  const std::filesystem::path& file = loaded.files[kLights];
  if (!unsavedLights && files.kindOf(file) == FileKind::None) return std::nullopt;

  Report report;
  Document document;
  LightsDescription lights;
  if (readDocument(files, file, unsavedLights, limits, document, kLights, report))
    lights = readLights(report, JsonValue(document, kLights, 0), limits);
  const bool wasBright = saysNothingOfLight(source.level, source.lights);
  if (!report.hasErrors() && saysNothingOfLight(source.level, lights) != wasBright)
    return std::nullopt;
  Level level = levelWith(lights, loaded, source, report);

  LoadResult result;
  std::swap(source.documents[kLights], document);
  result.diagnostics = report.resolve(source.documents);
  if (report.hasErrors()) {
    std::swap(source.documents[kLights], document);
    return result;
  }
  source.lights = std::move(lights);
  result.loaded = loaded;
  result.loaded->level = std::move(level);
  return result;
}

}  // namespace hearth
