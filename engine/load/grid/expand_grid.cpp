#include "load/grid/expand_grid.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "load/grid/grid_loops.h"
#include "load/read/read.h"
#include "load/suggest.h"

namespace hearth {

namespace {

/// Along a wall, see GridWall.
Vec2 directionOf(GridSide side) {
  switch (side) {
    case GridSide::North:
      return {1, 0};
    case GridSide::East:
      return {0, 1};
    case GridSide::South:
      return {-1, 0};
    case GridSide::West:
      return {0, -1};
  }
  return {};
}

/// The side of the cell beyond a wall that is seen: an index of GridSolidDescription::sides.
std::size_t sideSeen(const GridWall& wall) { return (static_cast<std::size_t>(wall.side) + 2) % 4; }

/// Writes out one sector after the other.
class GridWriter {
 public:
  GridWriter(Report& report, const GridDescription& grid, std::size_t maxVertices)
      : report_(report), grid_(grid), found_(findGridSectors(grid, maxVertices)) {}

  std::size_t sectors() const { return found_.sectors.size(); }

  std::size_t vertices() const { return found_.vertices; }

  SectorDescription sector(std::size_t index) {
    const GridSector& found = found_.sectors[index];
    const GridAirDescription& air = airOf(found);
    SectorDescription sector;
    sector.name = nameOf(found);
    sector.place = grid_.places[found.firstCell];
    sector.isOfGrid = true;
    sector.light = air.light;
    sector.floor = air.floor;
    sector.ceiling = air.ceiling;
    for (const GridLoop& loop : found.loops) sector.loops.push_back(loopOf(loop, found));
    sector.loops.front().name = "border";
    return sector;
  }

 private:
  const LegendEntryDescription* entryOf(std::uint32_t cell) const {
    const bool isBlank = cell == kBeyondGrid || grid_.cells[cell] == GridDescription::kBlank;
    return isBlank ? nullptr : &grid_.legend[grid_.cells[cell]];
  }
  const GridAirDescription& airOf(const GridSector& sector) const {
    return std::get<GridAirDescription>(entryOf(sector.firstCell)->kind);
  }
  std::string nameOf(const GridSector& sector) const {
    return fmt::format("{}{},{}", entryOf(sector.firstCell)->character,
                       sector.firstCell % grid_.columns, sector.firstCell / grid_.columns);
  }
  Vec2 vertexOf(const GridWall& wall) const {
    return {grid_.origin.x + grid_.cell * wall.column, grid_.origin.y + grid_.cell * wall.row};
  }

  LoopDescription loopOf(const GridLoop& walls, const GridSector& sector) {
    LoopDescription loop;
    loop.name = fmt::format("hole {},{}", walls.front().column, walls.front().row);
    loop.place = grid_.places[walls.front().cell];
    for (const GridWall& wall : walls) {
      loop.vertices.push_back(vertexOf(wall));
      loop.vertexPlaces.push_back(grid_.places[wall.cell]);
      loop.walls.push_back(wallOf(wall, sector));
    }
    return loop;
  }

  WallDescription wallOf(const GridWall& wall, const GridSector& sector) {
    const LegendEntryDescription* const beyond = entryOf(wall.neighbour);
    if (!beyond) return blankOf(wall, sector);
    if (const auto* solid = std::get_if<GridSolidDescription>(&beyond->kind))
      return solidOf(*solid, wall);
    if (const auto* next = std::get_if<GridNextDescription>(&beyond->kind))
      return {beyond->place, *next};
    if (const auto* air = std::get_if<GridAirDescription>(&beyond->kind))
      return {beyond->place, portalTo(*air, wall.neighbour, sector)};
    return {beyond->place, Unreadable{}};
  }

  /// The image runs on from cell to cell, and from wall to wall.
  WallDescription solidOf(const GridSolidDescription& solid, const GridWall& wall) const {
    TextureDescription texture = solid.sides[sideSeen(wall)].value_or(solid.wall);
    texture.along += dot(vertexOf(wall) - grid_.origin, directionOf(wall.side));
    return {texture.name.place, SolidDescription{texture}};
  }

  /// A step that shows from here is that of the neighbour, whose floor is higher (or whose ceiling
  /// is lower).
  PortalDescription portalTo(const GridAirDescription& air, std::uint32_t cell,
                             const GridSector& from) const {
    const GridSector& next = found_.sectors[found_.sectorOf[cell]];
    const GridAirDescription& here = airOf(from);
    PortalDescription portal;
    portal.next = {nameOf(next), grid_.places[cell]};
    if (air.floor.z > here.floor.z) portal.lower = air.lower;
    if (air.ceiling.z < here.ceiling.z) portal.upper = air.upper;
    return portal;
  }

  /// A blank has no texture. Beside a sector without height nothing of it shows.
  WallDescription blankOf(const GridWall& wall, const GridSector& sector) {
    const GridAirDescription& here = airOf(sector);
    const Place place = grid_.places[wall.neighbour == kBeyondGrid ? wall.cell : wall.neighbour];
    if (!here.floor.isReadable || !here.ceiling.isReadable) return {place, Unreadable{}};
    if (here.ceiling.z == here.floor.z) {
      TextureDescription unseen;
      unseen.name = {"#000000", place};
      return {place, SolidDescription{unseen}};
    }
    report_.error(
        place,
        fmt::format("a blank shows from sector \"{}\", and blanks have no texture", nameOf(sector)),
        wall.neighbour == kBeyondGrid ? "surround the grid with cells of an entry with \"wall\""
                                      : "write the character of an entry with \"wall\" instead");
    return {place, Unreadable{}};
  }

  Report& report_;
  const GridDescription& grid_;
  GridSectors found_;
};

/// Sectors that are written out, by name.
class WrittenSectors {
 public:
  explicit WrittenSectors(const LevelDescription& level) {
    for (const SectorDescription& sector : level.sectors)
      names_.push_back(places_.emplace(sector.name, sector.place).first->first);
  }

  const Place* find(const std::string& name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? nullptr : &found->second;
  }
  std::string suggestion(const std::string& name) const {
    return suggest(name, names_, "name one of \"sectors\"");
  }

 private:
  std::unordered_map<std::string, Place> places_;
  std::vector<std::string_view> names_;
};

/// Reports unknown sectors once, not at each wall that leads to one.
void refuseUnknownSectors(Report& report, const WrittenSectors& written, GridDescription& grid) {
  for (LegendEntryDescription& entry : grid.legend) {
    const auto* portal = std::get_if<GridNextDescription>(&entry.kind);
    if (!portal || written.find(portal->next.name)) continue;
    report.error(portal->next.place,
                 fmt::format("\"sectors\" has no sector \"{}\"", portal->next.name),
                 written.suggestion(portal->next.name));
    entry.kind = Unreadable{};
  }
}

std::size_t countVertices(const LevelDescription& level) {
  std::size_t count = 0;
  for (const SectorDescription& sector : level.sectors)
    for (const LoopDescription& loop : sector.loops) count += loop.vertices.size();
  return count;
}

}  // namespace

void expandGrid(Report& report, std::size_t maxVertices, LevelDescription& level) {
  GridDescription& grid = *level.grid;
  const WrittenSectors written(level);
  refuseUnknownSectors(report, written, grid);
  const std::size_t left = maxVertices - countVertices(level);
  GridWriter writer(report, grid, left);
  if (writer.sectors() == 0)
    return report.error(grid.place, "a grid without air",
                        "give a cell of an entry without \"wall\", or remove the grid");
  if (writer.vertices() > left) return reportTooManyVertices(report, grid.place, maxVertices);
  for (std::size_t i = 0; i < writer.sectors(); ++i) {
    level.sectors.push_back(writer.sector(i));
    if (const Place* equal = written.find(level.sectors.back().name))
      report.error(*equal,
                   fmt::format("the grid has a sector \"{}\", too", level.sectors.back().name),
                   "rename this one");
  }
}

}  // namespace hearth
