#include "load/load.h"

#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <string>

#include "load/grid/expand_grid.h"
#include "load/json/read_document.h"
#include "load/level_linker.h"
#include "load/read/read.h"
#include "load/source.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

class Loader {
 public:
  Loader(const fs::path& file, const LoadLimits& limits,
         const std::optional<std::string>& unsavedLights, const FileSource& files)
      : file_(file), limits_(limits), unsavedLights_(unsavedLights), from_(files) {
    source_.documents.reserve(2);  // values point into them
  }

  SourcedResult load() {
    LoadResult result;
    if (const std::optional<JsonValue> root = rootOf(file_, {})) {
      source_.level = readLevel(report_, *root, limits_);
      if (source_.level.grid) expandGrid(report_, limits_.vertices, source_.level);
      source_.lights = readLightsOf(source_.level);
      result.loaded = link(source_.level, source_.lights);
    }
    result.diagnostics = report_.resolve(source_.documents);
    return {std::move(result), std::move(source_)};
  }

 private:
  std::optional<JsonValue> rootOf(const fs::path& path, const std::optional<std::string>& unsaved);
  LightsDescription readLightsOf(const LevelDescription& description);
  std::optional<LoadedLevel> link(const LevelDescription& description,
                                  const LightsDescription& lights);

  const fs::path& file_;
  const LoadLimits& limits_;
  std::optional<std::string> unsavedLights_;
  const FileSource& from_;
  Report report_;
  LevelSource source_;
  std::vector<fs::path> files_;
  fs::path lights_;
};

/// The root of a file; reported when there is none.
std::optional<JsonValue> Loader::rootOf(const fs::path& path,
                                        const std::optional<std::string>& unsaved) {
  const auto index = static_cast<std::uint32_t>(source_.documents.size());
  Document& document = source_.documents.emplace_back();
  files_.push_back(path);
  if (!readDocument(from_, path, unsaved, limits_, document, index, report_)) return std::nullopt;
  return JsonValue(document, index, 0);
}

LightsDescription Loader::readLightsOf(const LevelDescription& description) {
  lights_ =
      description.lights ? file_.parent_path() / description.lights->name : lightsBeside(file_);
  if (!unsavedLights_ && from_.kindOf(lights_) == FileKind::None) {
    if (description.lights)
      report_.error(description.lights->place, fmt::format("there is no file {}", lights_.string()),
                    "correct the path, which is relative to the level file");
    return {};
  }
  const std::optional<JsonValue> root = rootOf(lights_, unsavedLights_);
  return root ? readLights(report_, *root, limits_) : LightsDescription{};
}

std::optional<LoadedLevel> Loader::link(const LevelDescription& description,
                                        const LightsDescription& lights) {
  if (description.sectors.empty() || !description.isReadable) return std::nullopt;
  std::optional<LinkedLevel> linked =
      LevelLinker(report_, {from_, file_, limits_}).link(description, lights);
  if (!linked) return std::nullopt;
  for (auto* files : {&linked->models, &linked->textures.files})
    files_.insert(files_.end(), files->begin(), files->end());
  source_.outlines = std::move(linked->outlines);
  source_.edgeOf = std::move(linked->edgeOf);
  return LoadedLevel{std::move(linked->level),
                     std::move(linked->geometry),
                     SharedImages(std::move(linked->textures.images)),
                     file_,
                     lights_,
                     files_,
                     linked->textures.decoded,
                     std::hash<std::string>{}(source_.documents.front().text)};
}

}  // namespace

fs::path lightsBeside(const fs::path& level) {
  return level.parent_path() / (level.stem().string() + ".lights.json");
}

LoadResult loadLevel(const fs::path& file, const LoadLimits& limits, const FileSource& files) {
  return Loader(file, limits, {}, files).load().result;
}

SourcedResult loadLevelWithSource(const fs::path& file, const LoadLimits& limits,
                                  const std::optional<std::string>& unsavedLights,
                                  const FileSource& files) {
  return Loader(file, limits, unsavedLights, files).load();
}

}  // namespace hearth
