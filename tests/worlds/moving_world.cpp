#include "worlds/moving_world.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "import/doom/import_map.h"
#include "import/doom/line_types.h"
#include "import/doom/map.h"
#include "import/doom/pieces.h"
#include "level/locate.h"
#include "lint/sector_reach.h"
#include "load/load.h"

namespace hearth::worlds {

namespace {

using doom::LineFate;
using doom::LineKind;

constexpr double kBefore = 0.05;  ///< metres from a line to where it is used or crossed

/// By LineKind; the last one is that of types that are none of Doom's.
constexpr std::array kKinds{"doors", "lifts", "floors",    "ceilings", "stairs",    "crushers",
                            "stops", "light", "teleports", "exits",    "scrolling", "others"};

std::size_t indexOf(const LineFate& fate) {
  return fate.kind ? static_cast<std::size_t>(*fate.kind) : kKinds.size() - 1;
}

/// Every line that does something is told of once, and every mover has lines.
void checkAccount(const doom::Map& map, const Level& level, MovingWorld& world) {
  std::vector<std::uint32_t> told;
  for (const LineFate& fate : world.lines) told.push_back(fate.line);
  std::vector<std::uint32_t> specials;
  for (std::uint32_t i = 0; i < map.lines.size(); ++i)
    if (map.lines[i].special != 0) specials.push_back(i);
  if (told != specials) world.errors.emplace_back("lines are not told of once each");
  for (std::size_t i = 0; i < level.movers.size(); ++i)
    if (!level.hasSwitch(i))
      world.errors.push_back(fmt::format("nothing starts {}", level.movers[i].name));
}

/// The places from which a line of a map is used or crossed.
std::vector<Vec2> placesBefore(const doom::Map& map, const doom::Line& line,
                               const doom::LineType& type) {
  const auto placeAt = [&](std::uint32_t vertex) {
    return doom::placeOf(map.vertices[vertex].x, map.vertices[vertex].y);
  };
  const Vec2 along = placeAt(line.to) - placeAt(line.from);
  const Vec2 middle = placeAt(line.from) + 0.5 * along;
  const Vec2 before = (kBefore / length(along)) * turned90(along);
  if (type.activation == doom::Activation::Walk) return {middle + before, middle - before};
  return {middle + before};
}

bool isReached(const Level& level, const Reach& reach, const doom::LineType& type,
               const std::vector<Vec2>& places) {
  for (std::size_t i = 0; i < level.sectors.size(); ++i) {
    const bool counts = type.activation == doom::Activation::Walk
                            ? reach.comesTo(SectorId(i))
                            : reach.mayUseWallsOf(SectorId(i));
    if (counts &&
        std::ranges::any_of(places, [&](Vec2 p) { return contains(level, level.sectors[i], p); }))
      return true;
  }
  return false;
}

std::optional<bool> isExitReached(const doom::Map& map, const Level& level) {
  if (!level.player) return std::nullopt;
  const Passages passages(level, level.player->stepHeight, level.player->height);
  const Reach reach(level, passages);
  std::optional<bool> isAnyReached;
  for (const doom::Line& line : map.lines) {
    const doom::LineType* type = doom::findLineType(line.special);
    if (!type || type->kind != LineKind::Exit) continue;
    isAnyReached = isAnyReached.value_or(false) ||
                   isReached(level, reach, *type, placesBefore(map, line, *type));
  }
  return isAnyReached;
}

}  // namespace

MovingWorld importMoving(const Archive& archive, const std::string& map,
                         const std::filesystem::path& folder) {
  MovingWorld world;
  world.map = map;
  const doom::LightTable lights = doom::parseLightTable(doom::ownLightTable()).value();
  const auto imported =
      doom::importMap({archive.wad(), archive.pictures(), lights}, map, {.folder = folder / map});
  if (imported) {
    const LoadResult result = loadLevel(imported->level);
    for (const Diagnostic& diagnostic : result.diagnostics)
      if (diagnostic.isError) world.errors.push_back(format(diagnostic));
    world.movers = imported->movers;
    world.lines = imported->specials;
    const doom::Map read = doom::readMap(archive.wad(), map).value();
    if (result.loaded) {
      checkAccount(read, result.loaded->level, world);
      world.isExitReached = isExitReached(read, result.loaded->level);
    }
  } else {
    world.errors.push_back(imported.error());
  }
  std::filesystem::remove_all(folder / map);
  return world;
}

std::string fateTables(const std::vector<MovingWorld>& worlds) {
  std::array<std::size_t, kKinds.size()> lines{};
  std::array<std::size_t, kKinds.size()> imported{};
  std::map<std::string, std::array<std::size_t, kKinds.size()>> reasons;
  for (const MovingWorld& world : worlds)
    for (const LineFate& fate : world.lines) {
      ++lines[indexOf(fate)];
      ++(fate.isImported() ? imported : reasons[fate.reason])[indexOf(fate)];
    }
  std::string text = "| lines | all | start movers | left out |\n| --- | --- | --- | --- |\n";
  for (std::size_t i = 0; i < kKinds.size(); ++i)
    text += fmt::format("| {} | {} | {} | {} |\n", kKinds[i], lines[i], imported[i],
                        lines[i] - imported[i]);
  text += "\n| left out because | lines |\n| --- | --- |\n";
  for (const auto& [reason, counts] : reasons) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < kKinds.size(); ++i)
      if (counts[i] > 0) parts.push_back(fmt::format("{} {}", counts[i], kKinds[i]));
    text += fmt::format("| {} | {} |\n", reason, fmt::join(parts, ", "));
  }
  return text;
}

}  // namespace hearth::worlds
