#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <tl/expected.hpp>

#include "hearth/command.h"
#include "hearth/import/convert.h"
#include "hearth/import/ground_plan.h"
#include "hearth/import/light_table.h"
#include "hearth/import/lights.h"
#include "hearth/import/map.h"
#include "hearth/import/materials.h"
#include "hearth/import/pictures.h"
#include "hearth/import/wad.h"
#include "hearth/layout.h"
#include "hearth/session.h"
#include "hearth/shell_text.h"
#include "image/read_file.h"
#include "image/replace_file.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;
using doom::Finding;

/// Of the light that a map gives its sectors: as much as lets that of lamps show.
constexpr double kAmbient = 0.75;

/// What became of one map.
struct Imported {
  std::string map;
  fs::path level;
  /// Of the map, and of the level.
  std::size_t mapSectors = 0;
  std::size_t sectors = 0;
  std::size_t lines = 0;
  std::size_t walls = 0;
  std::size_t lights = 0;
  std::size_t textures = 0;
  doom::Findings findings;
};

/// All that an import takes, but the map.
struct Source {
  const doom::Wad& wad;
  const doom::Pictures& pictures;
  const doom::LightTable& lights;
};

tl::expected<doom::LightTable, std::string> lightTableFrom(const OptionValues& values) {
  const auto file = values.text(Option::LightTable);
  if (!file) return doom::parseLightTable(doom::ownLightTable());
  const auto text = readFile(*file, limitsFrom(values).fileBytes);
  if (!text) return tl::unexpected(fmt::format("{}: {}", *file, text.error().what));
  auto table = doom::parseLightTable(*text);
  if (!table) return tl::unexpected(fmt::format("{}: {}", *file, table.error()));
  return table;
}

/// The level's file without its `.json`.
fs::path stemFor(const fs::path& folder, std::string map) {
  std::ranges::transform(map, map.begin(), [](unsigned char c) { return std::tolower(c); });
  return folder / map;
}

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

/// The level comes last, so that it is there only where all is that it needs.
tl::expected<void, std::string> write(const fs::path& stem, const doom::Materials& materials,
                                      const Json& lights, const Json& level) {
  return materials.write(stem.parent_path() / "textures")
      .and_then([&] { return writeNew(fs::path(stem) += ".lights.json", lights); })
      .and_then([&] { return writeNew(fs::path(stem) += ".json", level); });
}

tl::expected<Imported, std::string> importMap(const Source& source, const std::string& name,
                                              const OptionValues& values) {
  const auto map = doom::readMap(source.wad, name);
  if (!map) return tl::unexpected(map.error());
  const fs::path stem = stemFor(*values.text(Option::Output), name);
  Imported imported;
  imported.map = name;
  imported.level = fs::path(stem) += ".json";
  const auto doors =
      values.text(Option::Doors) == "closed" ? doom::Doors::Closed : doom::Doors::Open;
  const doom::GroundPlan plan(*map, doors, imported.findings);
  if (plan.regions().empty())
    return tl::unexpected(name + ": its lines enclose nothing: there is no level in it");
  doom::Materials materials(source.pictures, name, imported.findings);
  const Json level = doom::levelJson(plan, values.number(Option::Ambient).value_or(kAmbient),
                                     materials, imported.findings);
  const Json lights = doom::lightsJson(plan, source.lights);
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

std::size_t countOf(const doom::Findings& findings, doom::Outcome outcome) {
  return static_cast<std::size_t>(std::ranges::count(findings, outcome, &Finding::outcome));
}

std::string_view nameOf(doom::Part part) {
  constexpr std::array<std::string_view, 4> kNames{"line", "sector", "thing", "texture"};
  return kNames[static_cast<std::size_t>(part)];
}

std::string_view nameOf(doom::Outcome outcome) {
  return outcome == doom::Outcome::Repaired ? "repaired" : "dropped";
}

void print(const Imported& imported) {
  fmt::print(
      "{}: {} sectors of {}, {} walls of {} lines, {} lights, {} textures; {} repaired, {} "
      "dropped\n",
      imported.level.string(), imported.sectors, imported.mapSectors, imported.walls,
      imported.lines, imported.lights, imported.textures,
      countOf(imported.findings, doom::Outcome::Repaired),
      countOf(imported.findings, doom::Outcome::Dropped));
  for (const Finding& finding : imported.findings)
    fmt::print("  {}{}: {}: {}\n", nameOf(finding.part),
               finding.part == doom::Part::Texture ? "" : fmt::format(" {}", finding.number),
               nameOf(finding.outcome), finding.what);
}

Json jsonOf(const Imported& imported) {
  Json findings = Json::array();
  for (const Finding& finding : imported.findings) {
    Json json{{"outcome", nameOf(finding.outcome)}, {"part", nameOf(finding.part)}};
    if (finding.part != doom::Part::Texture) json["number"] = finding.number;
    json["what"] = finding.what;
    findings.push_back(std::move(json));
  }
  return {{"map", imported.map},
          {"level", imported.level.string()},
          {"of", {{"sectors", imported.mapSectors}, {"lines", imported.lines}}},
          {"sectors", imported.sectors},
          {"walls", imported.walls},
          {"lights", imported.lights},
          {"textures", imported.textures},
          {"findings", std::move(findings)}};
}

ExitStatus run(const OptionValues& values) {
  const std::string& file = values.levels.front();
  const auto wad = doom::Wad::open(file, limitsFrom(values).fileBytes);
  if (!wad) return fail(wad.error());
  const std::vector<std::string> maps(values.levels.begin() + 1, values.levels.end());
  if (maps.empty())
    return fail(
        fmt::format("{}: name a map of it: {}", file, fmt::join(doom::mapNames(*wad), ", ")));
  const auto pictures = doom::Pictures::read(*wad);
  if (!pictures) return fail(fmt::format("{}: {}", file, pictures.error()));
  const auto lights = lightTableFrom(values);
  if (!lights) return fail(lights.error());
  Json all = Json::array();
  for (const std::string& name : maps) {
    const auto imported = importMap({*wad, *pictures, *lights}, name, values);
    if (!imported) return fail(fmt::format("{}: {}", file, imported.error()));
    if (values.has(Option::Json))
      all.push_back(jsonOf(*imported));
    else
      print(*imported);
  }
  if (values.has(Option::Json)) fmt::print("{}\n", all.dump(2));
  return ExitStatus::Done;
}

}  // namespace

Command importCommand() {
  return {"import",
          "turns maps of a WAD of Doom into levels with their textures",
          {Option::Output, Option::Doors, Option::Ambient, Option::LightTable, Option::Json,
           Option::MaxFileBytes},
          {Option::Output},
          run,
          LevelFiles::Several,
          "The first argument is the WAD, the others are the names of its maps.",
          "FILE.wad MAP"};
}

}  // namespace hearth
