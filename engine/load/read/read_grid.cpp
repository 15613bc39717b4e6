#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "load/json/fields.h"
#include "load/read/read.h"

namespace hearth {

namespace {

constexpr std::array<std::string_view, 4> kGridKeys{"cell", "origin", "rows", "legend"};
constexpr std::array<std::string_view, 2> kGridSolidKeys{"wall", "walls"};
constexpr std::array<std::string_view, 5> kGridAirKeys{"floor", "ceiling", "light", "upper",
                                                       "lower"};
constexpr std::array<std::string_view, 3> kGridNextKeys{"next", "upper", "lower"};

constexpr MisplacedKeys kOfGridAir{kGridAirKeys,
                                   "remove it or \"wall\": with \"wall\" its cells are solid"};
constexpr MisplacedKeys kOfOtherCells{
    kGridAirKeys, "remove it or \"next\": with \"next\" its cells are of another sector"};

// --- The legend ----------------------------------------------------------------------------------

std::optional<GridSolidDescription> readSolid(Report& report, JsonValue entry) {
  const Fields fields(report, entry, kGridSolidKeys, kOfGridAir);
  GridSolidDescription solid;
  const auto value = fields.require("wall", "give the texture of sides that \"walls\" leaves out");
  const auto wall = value ? readTexture(report, *value, TextureUse::OnWall) : std::nullopt;
  bool isGood = wall.has_value();
  if (wall) solid.wall = *wall;
  if (const auto walls = fields.find("walls")) {
    const Fields sides(report, *walls, kGridSideKeys);
    for (std::size_t side = 0; side < kGridSideKeys.size(); ++side)
      isGood &= readOptionalTexture(report, sides, kGridSideKeys[side], solid.sides[side]);
  }
  return isGood ? std::optional(std::move(solid)) : std::nullopt;
}

/// A flat of all sectors of an entry: what is wrong with it is reported once.
FlatDescription readGridFlat(Report& report, const Fields& entry, std::string_view key,
                             double defaultZ) {
  FlatDescription flat = readFlat(report, entry, key, defaultZ);
  if (flat.isReadable && !flat.texture && !flat.next) {
    report.error(flat.place, fmt::format("the {} has no texture", key), "give it a \"texture\"");
    flat.isReadable = false;
  }
  return flat;
}

std::optional<GridAirDescription> readAir(Report& report, JsonValue value) {
  const Fields fields(report, value, kGridAirKeys);
  if (!fields.isObject()) return std::nullopt;
  GridAirDescription air;
  air.floor = readGridFlat(report, fields, "floor", kFloorZ);
  air.ceiling = readGridFlat(report, fields, "ceiling", kCeilingZ);
  fields.read("light", {0, 1}, air.light);
  bool isGood = readOptionalTexture(report, fields, "upper", air.upper);
  isGood &= readOptionalTexture(report, fields, "lower", air.lower);
  if (air.floor.isReadable && air.ceiling.isReadable && air.ceiling.z < air.floor.z) {
    report.error(
        air.ceiling.zPlace,
        fmt::format("the ceiling is at {}, below the floor at {}", air.ceiling.z, air.floor.z),
        "raise the ceiling or lower the floor");
    air.ceiling.isReadable = false;
  }
  return isGood ? std::optional(std::move(air)) : std::nullopt;
}

std::optional<GridNextDescription> readNext(Report& report, JsonValue value) {
  const Fields fields(report, value, kGridNextKeys, kOfOtherCells);
  GridNextDescription portal;
  bool isGood = readOptionalTexture(report, fields, "upper", portal.upper);
  isGood &= readOptionalTexture(report, fields, "lower", portal.lower);
  const std::optional<NameReference> next = readReference(report, *fields.find("next"));
  if (!isGood || !next) return std::nullopt;
  portal.next = *next;
  return portal;
}

bool hasKey(JsonValue object, std::string_view key) {
  return std::ranges::any_of(object.members(),
                             [&](const auto& member) { return member.key.text() == key; });
}

/// Whether it tells what its cells are; reported if not.
bool saysWhatCellsAre(Report& report, JsonValue entry) {
  for (const std::string_view key : {"wall", "walls", "next", "floor", "ceiling"})
    if (hasKey(entry, key)) return true;
  report.error(entry.place(), "an entry that does not say what its cells are",
               "give \"wall\" for solid cells, \"floor\" and \"ceiling\" for air, or \"next\"");
  return false;
}

LegendEntryDescription readEntry(Report& report, const JsonValue::Member& member) {
  const JsonValue value = member.value;
  LegendEntryDescription entry{std::string(member.key.text()), value.place(), {}};
  const auto take = [&](auto kind) {
    if (kind) entry.kind = *std::move(kind);
  };
  if (value.isObject() && !saysWhatCellsAre(report, value)) return entry;
  if (value.isObject() && (hasKey(value, "wall") || hasKey(value, "walls")))
    take(readSolid(report, value));
  else if (value.isObject() && hasKey(value, "next"))
    take(readNext(report, value));
  else
    take(readAir(report, value));
  return entry;
}

/// Whether a key can stand in rows; reported if not.
bool isCharacter(Report& report, JsonValue key) {
  const std::size_t characters = key.characterCount();
  if (characters != 1)
    report.error(
        key.place(),
        fmt::format("\"{}\" has {} characters, and a cell has one", key.text(), characters),
        "give each entry of the legend a single character as its key");
  else if (key.text() == " ")
    report.error(key.place(), "an entry for blanks, which are always solid, without a texture",
                 "choose another character, and write it instead of the blanks");
  else
    return true;
  return false;
}

/// Whether all of its keys are characters.
bool readLegend(Report& report, JsonValue value, GridDescription& grid) {
  if (!value.isObject()) {
    reportWrongType(report, value, "an object of entries, each under its character");
    return false;
  }
  bool isGood = true;
  for (const JsonValue::Member& member : value.members()) {
    isGood &= isCharacter(report, member.key);
    grid.legend.push_back(readEntry(report, member));
  }
  return isGood;
}

// --- The rows ------------------------------------------------------------------------------------

/// Looks characters up in the legend. Reports those that it does not have, each where it is first.
class LegendIndex {
 public:
  LegendIndex(Report& report, const GridDescription& grid) : report_(report) {
    for (std::uint32_t i = 0; i < grid.legend.size(); ++i)
      entries_.emplace(grid.legend[i].character, i);
    entries_.emplace(" ", GridDescription::kBlank);
  }

  bool hasUnknown() const { return hasUnknown_; }

  std::uint32_t entryOf(std::string_view character, Place place) {
    const auto [entry, isNew] = entries_.emplace(character, GridDescription::kBlank);
    if (isNew) {
      hasUnknown_ = true;
      report_.error(place, fmt::format("the legend has no entry \"{}\"", character),
                    character == "$" ? "choose another character: a key that begins with \"$\" is "
                                       "a comment"
                                     : "add one, or correct the character");
    }
    return entry->second;
  }

 private:
  Report& report_;
  std::unordered_map<std::string_view, std::uint32_t> entries_;
  bool hasUnknown_ = false;
};

/// Whether the rows are texts of one length, and no more cells than allowed; reported if not.
bool measureRows(Report& report, JsonValue value, std::size_t maxCells, GridDescription& grid) {
  if (!value.isArray() || value.size() == 0) {
    if (value.isArray())
      report.error(value.place(), "a grid without rows", "give at least one");
    else
      reportWrongType(report, value, "an array of strings, each a row of cells");
    return false;
  }
  std::size_t cells = 0;
  for (const JsonValue row : value.elements()) {
    if (!row.isString()) {
      reportWrongType(report, row, "a string of cells");
      return false;
    }
    const std::size_t columns = row.characterCount();
    cells += columns;
    if (cells > maxCells) {
      report.error(row.place(), fmt::format("more than {} cells", maxCells),
                   "raise the limit with --max-grid-cells");
      return false;
    }
    if (grid.rows == 0) grid.columns = static_cast<std::uint32_t>(columns);
    if (columns != grid.columns) {
      report.error(
          row.place(),
          fmt::format("row {} has {} cells, where row 0 has {}", grid.rows, columns, grid.columns),
          "give all rows the same length; a blank is a solid cell");
      return false;
    }
    ++grid.rows;
  }
  return true;
}

/// Whether the legend has all their characters; reported if not.
bool readRows(Report& report, JsonValue value, GridDescription& grid) {
  LegendIndex legend(report, grid);
  for (const JsonValue row : value.elements()) {
    const std::vector<Place> places = row.characterPlaces();
    const std::vector<std::string_view> characters = row.characters();
    for (std::size_t column = 0; column < grid.columns; ++column)
      grid.cells.push_back(legend.entryOf(characters[column], places[column]));
    grid.places.insert(grid.places.end(), places.begin(), places.end());
  }
  return !legend.hasUnknown();
}

/// Whether the corners of all cells lie in the world; reported if not.
bool isInWorld(Report& report, const GridDescription& grid) {
  const Vec2 end = grid.origin + grid.cell * Vec2{1.0 * grid.columns, 1.0 * grid.rows};
  if (std::max(end.x, end.y) <= kWorldLimit) return true;
  report.error(grid.place,
               fmt::format("the grid reaches to ({}, {}), beyond {}", end.x, end.y, kWorldLimit),
               "lower \"cell\" or \"origin\"");
  return false;
}

}  // namespace

std::optional<GridDescription> readGrid(Report& report, JsonValue value, const LoadLimits& limits) {
  constexpr NumberRange kCell{1e-6, kWorldLimit};
  const Fields fields(report, value, kGridKeys);
  GridDescription grid;
  grid.place = value.place();
  bool isGood = fields.read("cell", kCell, grid.cell);
  isGood &= fields.read("origin", kCoordinate, grid.origin);
  const auto rows = fields.require("rows", "give the rows of cells, each a string");
  const auto legend = fields.require("legend", "say what each character of the rows stands for");
  isGood &= legend && readLegend(report, *legend, grid);
  if (!isGood || !rows || !measureRows(report, *rows, limits.gridCells, grid) ||
      !readRows(report, *rows, grid) || !isInWorld(report, grid))
    return std::nullopt;
  return grid;
}

}  // namespace hearth
