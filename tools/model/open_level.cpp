#include "model/open_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "load/link/place_model.h"
#include "load/model/read_model.h"
#include "math/tolerance.h"
#include "model/model_air.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

/// The files of a source, each read once: one that is saved meanwhile stays as it was at first.
/// Beside them there may be texts that no folder holds.
class FilesReadOnce final : public FileSource {
 public:
  explicit FilesReadOnce(const FileSource& files) : files_(files) {}

  void add(const fs::path& path, std::string text) { texts_[path] = std::move(text); }

  FileKind kindOf(const fs::path& path) const override {
    return textOf(path) ? FileKind::Regular : files_.kindOf(path);
  }
  /// The user's limit is for files, not for what was added.
  tl::expected<std::string, ReadError> read(const fs::path& path,
                                            std::uint64_t maxBytes) const override {
    if (const std::string* text = textOf(path)) return *text;
    tl::expected<std::string, ReadError> read = files_.read(path, maxBytes);
    if (read) texts_[path] = *read;
    return read;
  }
  tl::expected<std::unique_ptr<std::istream>, ReadError> open(const fs::path& path) const override {
    const std::string* text = textOf(path);
    if (text) return std::make_unique<std::istringstream>(*text);
    return files_.open(path);
  }
  std::vector<fs::path> namesIn(const fs::path& folder) const override {
    return files_.namesIn(folder);
  }

 private:
  const std::string* textOf(const fs::path& path) const {
    const auto found = texts_.find(path);
    return found == texts_.end() ? nullptr : &found->second;
  }

  const FileSource& files_;
  mutable std::map<fs::path, std::string> texts_;
};

ModelFigures figuresOf(const Model& model) {
  ModelFigures figures{.vertices = model.vertices,
                       .faces = model.polygons,
                       .triangles = model.faces.size(),
                       .materials = model.materials.size(),
                       .box = {}};
  std::set<fs::path> images;
  for (const ModelMaterial& material : model.materials)
    if (material.image) images.insert(*material.image);
  figures.images = images.size();
  for (const ModelFace& face : model.faces)
    for (const Vec3& corner : face.corners) figures.box.add(inOtherAxes(corner));
  return figures;
}

OrbitView frontOf(const Model& model, const Box3& box) {
  FrontView front(box, kModelFov, kFrontSize);
  for (const ModelFace& face : model.faces)
    for (const Vec3& corner : face.corners) front.add(inOtherAxes(corner));
  return front.view();
}

/// At its place in the model's files: the author has no level that could name them.
Diagnostic diagnosticOf(const ModelMistake& mistake) {
  return {mistake.file.string(),
          std::max(mistake.line, 1),
          1,
          mistake.isError,
          "",
          mistake.message,
          mistake.advice,
          mistake.isError ? "" : "model-skips"};
}

Diagnostic errorIn(const fs::path& model, std::string message, std::string advice) {
  return {model.string(), 1, 1, true, "", std::move(message), std::move(advice)};
}

bool isOfAir(const Diagnostic& diagnostic, const AirFiles& air) {
  return diagnostic.file == air.level.string() || diagnostic.file == air.lights.string();
}

/// Whether a message of the loader repeats one of the model's own.
bool isTold(const Diagnostic& diagnostic) {
  return diagnostic.kind == "model-skips" || diagnostic.kind == "far-away";
}

std::optional<Diagnostic> warningIfFar(const fs::path& model, const Box3& box) {
  const auto reach = [](Vec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); };
  const double farthest = std::max(reach(box.min), reach(box.max));
  if (farthest <= kPreciseReach) return std::nullopt;
  return Diagnostic{
      model.string(),
      1,
      1,
      false,
      "",
      fmt::format("the model reaches {:.6g} m from its origin: light may miss its faces", farthest),
      fmt::format("move it to within {:.0f} m of its origin", kPreciseReach),
      "far-away"};
}

/// The user's limits are for the model. The few parts of the air always pass.
LoadLimits limitsWithAir(LoadLimits limits) {
  constexpr std::size_t kParts = 100;
  limits.vertices = std::max(limits.vertices, kParts);
  limits.lights = std::max(limits.lights, kParts);
  return limits;
}

/// Loads the model in its air. Messages about the files of the air name the model's file.
void loadInAir(const fs::path& file, const AirFiles& air, const LoadLimits& limits,
               const FileSource& files, OpenedLevel& opened) {
  auto [result, source] = loadLevelWithSource(air.level, limitsWithAir(limits), {}, files);
  for (Diagnostic& diagnostic : result.diagnostics) {
    if (isTold(diagnostic)) continue;
    if (isOfAir(diagnostic, air)) {
      diagnostic.file = file.string();
      diagnostic.line = diagnostic.column = 1;
      diagnostic.pointer.clear();
    }
    opened.result.diagnostics.push_back(std::move(diagnostic));
  }
  opened.source = std::move(source);
  opened.result.loaded = std::move(result.loaded);
  if (!opened.result.loaded) return;
  opened.result.loaded->path = file;
  std::erase_if(opened.result.loaded->files,
                [&air](const fs::path& read) { return read == air.level || read == air.lights; });
}

OpenedLevel openModel(const fs::path& file, const LoadLimits& limits, const FileSource& source) {
  OpenedLevel opened;
  FilesReadOnce files(source);
  std::vector<Diagnostic>& diagnostics = opened.result.diagnostics;
  ModelRead read = readModel(file, limits, files);
  for (const ModelMistake& mistake : read.mistakes) diagnostics.push_back(diagnosticOf(mistake));
  if (!read.model) return opened;
  const ModelFigures figures = figuresOf(*read.model);
  if (const auto mistake = mistakeInSize(figures.box)) {
    diagnostics.push_back(errorIn(file, mistake->message, mistake->advice));
    return opened;
  }
  if (const auto warning = warningIfFar(file, figures.box)) diagnostics.push_back(*warning);
  const auto air = airFiles(file, figures.box, frontOf(*read.model, figures.box));
  if (!air) {
    diagnostics.push_back(errorIn(file, "the name of the file is not UTF-8", "rename it"));
    return opened;
  }
  read.model.reset();  // before the level's copy takes as much memory
  files.add(air->level, air->levelText);
  files.add(air->lights, air->lightsText);
  loadInAir(file, *air, limits, files, opened);
  if (opened.result.loaded) opened.model = figures;
  return opened;
}

}  // namespace

bool isModel(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending == ".obj";
}

OpenedLevel openLevel(const fs::path& file, const LoadLimits& limits,
                      const std::optional<std::string>& unsavedLights, const FileSource& files) {
  if (isModel(file)) return openModel(file, limits, files);
  auto [result, source] = loadLevelWithSource(file, limits, unsavedLights, files);
  return {std::move(result), std::move(source), std::nullopt};
}

}  // namespace hearth
