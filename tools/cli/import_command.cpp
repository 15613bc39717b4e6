#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tl/expected.hpp>

#include "cli/command.h"
#include "files/read_file.h"
#include "import/doom/import_map.h"
#include "import/doom/map.h"
#include "inputs/inputs.h"

namespace hearth {

namespace {

using Json = nlohmann::ordered_json;
using doom::Finding;
using doom::Imported;

constexpr std::string_view kAdviceOnMapsAlone =
    "; where it has maps alone, give the game's WAD with --iwad";

tl::expected<doom::LightTable, std::string> lightTableFrom(const OptionValues& values) {
  const auto file = values.text(Option::LightTable);
  if (!file) return doom::parseLightTable(doom::ownLightTable());
  const auto text = readFile(*file, limitsFrom(values).fileBytes);
  if (!text) return tl::unexpected(fmt::format("{}: {}", *file, text.error().what));
  auto table = doom::parseLightTable(*text);
  if (!table) return tl::unexpected(fmt::format("{}: {}", *file, table.error()));
  return table;
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

std::size_t countStarters(const Imported& imported) {
  return static_cast<std::size_t>(
      std::ranges::count_if(imported.specials, &doom::LineFate::isImported));
}

/// Of lines that start nothing, by the reason.
std::map<std::string, std::size_t> countLeftOut(const Imported& imported) {
  std::map<std::string, std::size_t> counts;
  for (const doom::LineFate& fate : imported.specials)
    if (!fate.isImported()) ++counts[fate.reason];
  return counts;
}

void print(const Imported& imported) {
  fmt::print(
      "{}: {} sectors of {}, {} walls of {} lines, {} sprites of {} things, {} lights, {} "
      "textures, {} emitters, {} movers that {} lines start; {} repaired, {} dropped\n",
      imported.level.string(), imported.sectors, imported.mapSectors, imported.walls,
      imported.lines, imported.sprites, imported.mapThings, imported.lights, imported.textures,
      imported.emitters, imported.movers, countStarters(imported),
      countOf(imported.findings, doom::Outcome::Repaired),
      countOf(imported.findings, doom::Outcome::Dropped));
  for (const auto& [reason, count] : countLeftOut(imported))
    fmt::print("  {} line{} left out: {}\n", count, count == 1 ? "" : "s", reason);
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
  Json leftOut = Json::object();
  for (const auto& [reason, count] : countLeftOut(imported)) leftOut[reason] = count;
  return {{"map", imported.map},
          {"level", imported.level.string()},
          {"of",
           {{"sectors", imported.mapSectors},
            {"lines", imported.lines},
            {"things", imported.mapThings}}},
          {"sectors", imported.sectors},
          {"walls", imported.walls},
          {"sprites", imported.sprites},
          {"lights", imported.lights},
          {"textures", imported.textures},
          {"emitters", imported.emitters},
          {"movers", imported.movers},
          {"starters", countStarters(imported)},
          {"leftOut", std::move(leftOut)},
          {"findings", std::move(findings)}};
}

/// How large a map is, or why it cannot be imported.
Json entryOf(const doom::Wad& wad, const std::string& name) {
  const auto map = doom::readMap(wad, name);
  if (!map) return {{"map", name}, {"error", map.error()}};
  return {{"map", name},
          {"sectors", map->sectors.size()},
          {"lines", map->lines.size()},
          {"things", map->things.size()}};
}

std::string textOf(const Json& entry) {
  if (entry.contains("error")) return entry["error"].get<std::string>();
  return fmt::format("{}: {} sectors, {} lines, {} things", entry["map"].get<std::string>(),
                     entry["sectors"].get<std::size_t>(), entry["lines"].get<std::size_t>(),
                     entry["things"].get<std::size_t>());
}

/// Prints which maps there are. Of several of one name the last one counts.
ExitStatus list(const std::string& file, const doom::Wad& wad, bool isJson) {
  Json entries = Json::array();
  std::set<std::string> listed;
  for (const std::string& name : doom::mapNames(wad))
    if (listed.insert(name).second) entries.push_back(entryOf(wad, name));
  if (entries.empty()) return fail(fmt::format("{}: {}", file, doom::kNoMaps));
  if (isJson)
    fmt::print("{}\n", entries.dump(2));
  else
    for (const Json& entry : entries) fmt::print("{}\n", textOf(entry));
  return ExitStatus::Done;
}

doom::ImportSettings settingsFrom(const OptionValues& values) {
  doom::ImportSettings settings;
  settings.folder = *values.text(Option::Output);
  const auto doors = values.text(Option::Doors);
  if (doors == "open") settings.doors = doom::Doors::Open;
  if (doors == "closed") settings.doors = doom::Doors::Closed;
  if (values.has(Option::AreaLights)) settings.lightFrom = doom::LightFrom::Areas;
  settings.ambient = values.number(Option::Ambient).value_or(settings.ambient);
  if (const auto skill = values.number(Option::Skill))
    settings.things.game.skill = static_cast<int>(*skill);
  settings.things.game.isMultiplayer = values.has(Option::Multiplayer);
  settings.things.hasMonsters = values.has(Option::Monsters);
  return settings;
}

/// The WAD with the maps, over that of the game if one is given.
tl::expected<doom::Wad, std::string> openWads(const OptionValues& values) {
  const std::uint64_t maxBytes = limitsFrom(values).fileBytes;
  auto wad = doom::Wad::open(values.levels.front(), maxBytes);
  const auto iwad = values.text(Option::Iwad);
  if (!wad || !iwad) return wad;
  auto base = doom::Wad::open(*iwad, maxBytes);
  if (!base) return base;
  wad->layOver(*std::move(base));
  return wad;
}

ExitStatus runImport(const OptionValues& values) {
  const std::string& file = values.levels.front();
  const auto wad = openWads(values);
  if (!wad) return fail(wad.error());
  const std::vector<std::string> maps(values.levels.begin() + 1, values.levels.end());
  if (maps.empty()) return list(file, *wad, values.has(Option::Json));
  if (!values.has(Option::Output))
    return fail("-o is required with the name of a map: the folder where the level goes");
  const auto pictures = doom::Pictures::read(*wad);
  if (!pictures)
    return fail(fmt::format("{}: {}{}", file, pictures.error(),
                            values.has(Option::Iwad) ? "" : kAdviceOnMapsAlone));
  const auto lights = lightTableFrom(values);
  if (!lights) return fail(lights.error());
  const doom::ImportSettings settings = settingsFrom(values);
  Json all = Json::array();
  for (const std::string& name : maps) {
    const auto imported = doom::importMap({*wad, *pictures, *lights}, name, settings);
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
  return {
      "import",
      "turns maps of a WAD of Doom into levels with their textures",
      {Option::Output, Option::Iwad, Option::Doors, Option::Ambient, Option::AreaLights,
       Option::LightTable, Option::Skill, Option::Multiplayer, Option::Monsters, Option::Json,
       Option::MaxFileBytes},
      {},
      runImport,
      LevelFiles::Several,
      "The first argument is the WAD, the others are the names of its maps, which need -o. Without "
      "a name the maps of the WAD are listed.",
      "FILE.wad [MAP]"};
}

}  // namespace hearth
