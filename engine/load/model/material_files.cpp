#include "load/model/material_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "load/model/model_file.h"
#include "load/model/model_numbers.h"
#include "load/suggest.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

/// A model that names more is not one that an author wrote.
constexpr std::size_t kMaxMaterialFiles = 64;
constexpr Rgb kWhite{255, 255, 255};

std::uint8_t eightBits(double fraction) {
  return static_cast<std::uint8_t>(std::floor(fraction * 255 + 0.5));
}

/// `Kd r g b`, or one number for all three.
void readColor(const ModelLine& line, ModelReport& report, ModelMaterial& material) {
  const WantedNumbers wanted{{0, 1}, "red, green and blue"};
  std::string_view rest = line.rest;
  std::array<double, 3> color{};
  if (!takeNumbers(line, rest, wanted, std::span(color).first(1), report)) return;
  std::string_view others = rest;
  if (!takeWord(others))
    color.fill(color[0]);
  else if (!takeNumbers(line, rest, wanted, std::span(color).last(2), report))
    return;
  else
    leaveOutRest(line, rest, report);
  material.color = {eightBits(color[0]), eightBits(color[1]), eightBits(color[2])};
}

/// `map_Kd FILE`, or `map_Kd -OPTION VALUES FILE`, where the last word is the file.
void readImageName(const ModelLine& line, const fs::path& file, ModelReport& report,
                   ModelMaterial& material) {
  std::string_view name = line.rest;
  if (name.starts_with('-')) {
    report.leaveOut("options of map_Kd", line.number);
    name.remove_prefix(name.find_last_of(" \t") + 1);
  }
  if (name.empty()) return report.error(line.number, "\"map_Kd\" without a file", "name an image");
  auto path = pathOfNamed(name, file);
  if (!path) return report.error(line.number, path.error().message, path.error().advice);
  material.image = *std::move(path);
  material.imageNamedAt = fmt::format("{}:{}", file.string(), line.number);
}

}  // namespace

MaterialFiles::MaterialFiles(const fs::path& model, ModelReport& report, const LoadLimits& limits,
                             const FileSource& files)
    : model_(model), report_(report), source_(files), bytesLeft_(limits.fileBytes) {}

void MaterialFiles::read(const ModelLine& line) {
  std::string_view rest = line.rest;
  if (rest.empty())
    report_.error(line.number, "\"mtllib\" without a file", "name a file, or remove it");
  while (const auto name = takeWord(rest)) {
    if (report_.isFull() || names_.size() > kMaxMaterialFiles) return;
    if (names_.emplace(*name).second) isComplete_ &= readFile(*name, line.number);
  }
}

/// Whether it could be read to its end. Errors in it do not count.
bool MaterialFiles::readFile(std::string_view name, std::uint32_t line) {
  const auto refuse = [&](std::string message, std::string advice) {
    report_.error(line, std::move(message), std::move(advice));
    return false;
  };
  if (names_.size() > kMaxMaterialFiles)
    return refuse(fmt::format("more than {} files of materials", kMaxMaterialFiles),
                  "put the materials into one file");
  const auto path = pathOfNamed(name, model_);
  if (!path) return refuse(path.error().message, path.error().advice);
  const auto text =
      readModelText(source_, *path, bytesLeft_,
                    "correct the name, which is relative to the folder of this file and ends at "
                    "the first blank");
  if (!text)
    return refuse(fmt::format("{}: {}", path->string(), text.error().message), text.error().advice);
  bytesLeft_ -= text->size();
  filesRead_.push_back(*path);
  readMaterials(*path, *text);
  return !reports_.back().isFull();
}

void MaterialFiles::readMaterials(const fs::path& path, std::string_view text) {
  ModelReport& report = reports_.emplace_back(path);
  ModelLines lines(text);
  ModelMaterial* material = nullptr;
  while (!report.isFull()) {
    const auto line = lines.next();
    if (!line) return;
    const bool isColor = line->keyword == "Kd";
    if (line->keyword == "newmtl")
      material = &begin(*line, report);
    else if (!isColor && line->keyword != "map_Kd")
      report.leaveOut(line->keyword, line->number);
    else if (!material)
      report.error(line->number, fmt::format("\"{}\" outside a material", line->keyword),
                   "begin a material with \"newmtl NAME\"");
    else if (isColor)
      readColor(*line, report, *material);
    else
      readImageName(*line, path, report, *material);
  }
}

ModelMaterial& MaterialFiles::begin(const ModelLine& line, ModelReport& report) {
  const auto [found, isNew] = materials_.try_emplace(std::string(line.rest));
  if (line.rest.empty())
    report.error(line.number, "\"newmtl\" without a name", "give the material one");
  else if (!isNew)
    report.error(line.number, fmt::format("two materials are named \"{}\"", shortened(line.rest)),
                 "rename one of them");
  ModelMaterial& material = found->second.material;
  material.color = kWhite;
  return material;
}

std::optional<std::uint32_t> MaterialFiles::use(const ModelLine& line) {
  const auto found = materials_.find(line.rest);
  if (line.rest.empty() || found == materials_.end()) {
    reportUnknown(line);
    return std::nullopt;
  }
  Entry& entry = found->second;
  if (!entry.usedAs) {
    entry.usedAs = static_cast<std::uint32_t>(used_.size());
    used_.push_back(std::move(entry.material));
  }
  return entry.usedAs;
}

void MaterialFiles::reportUnknown(const ModelLine& line) {
  if (line.rest.empty())
    return report_.error(line.number, "\"usemtl\" without a name", "name a material, or remove it");
  if (!isComplete_) return;
  constexpr std::size_t kMaxBytes = 64;  // of a name that is suggested
  std::vector<std::string_view> known;
  for (const auto& [name, entry] : materials_)
    if (!name.empty() && name.size() <= kMaxBytes) known.emplace_back(name);
  report_.error(
      line.number, fmt::format("there is no material \"{}\"", shortened(line.rest)),
      suggest(line.rest, known, "name with \"mtllib\" a file that has it, or correct the name"));
}

bool MaterialFiles::hasErrors() const {
  return std::ranges::any_of(reports_, &ModelReport::hasErrors);
}

std::vector<ModelMistake> MaterialFiles::mistakes() const {
  std::vector<ModelMistake> all;
  for (const ModelReport& report : reports_) {
    std::vector<ModelMistake> mistakes = report.mistakes("newmtl, Kd and map_Kd");
    std::ranges::move(mistakes, std::back_inserter(all));
  }
  return all;
}

}  // namespace hearth
