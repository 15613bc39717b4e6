#include "cli/info/engine_features.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <variant>

namespace hearth {

namespace {

struct WallCounts {
  std::int64_t all = 0;
  std::int64_t stacks = 0;
};

/// Counts authored walls; linking may have split one into several segments.
WallCounts countWalls(const Level& level) {
  std::set<std::tuple<SectorId, std::uint32_t, std::uint32_t>> seen;
  WallCounts counts;
  for (const Segment& segment : level.segments) {
    if (!seen.insert({segment.sector, segment.loop, segment.wallIndex}).second) continue;
    ++counts.all;
    counts.stacks += std::holds_alternative<Stack>(segment.wall) ? 1 : 0;
  }
  return counts;
}

}  // namespace

std::vector<EngineFeatureUse> engineFeatureUses(const LoadedLevel& loaded,
                                                const LightReport& light) {
  const Level& level = loaded.level;
  const auto count = [](const auto& range, auto&& isUsed) {
    return static_cast<std::int64_t>(std::ranges::count_if(range, isUsed));
  };
  const auto surfacesOf = [&](SurfaceKind kind) {
    return light.kinds[static_cast<std::size_t>(kind)].surfaces();
  };
  const auto sectorsWith = [&](auto&& isUsed) { return count(level.sectors, isUsed); };
  const std::int64_t sectors = std::ssize(level.sectors);
  const WallCounts walls = countWalls(level);
  return {
      {"sectors with a slope",
       sectorsWith([](const Sector& s) { return s.floorSlope || s.ceilingSlope; }), sectors,
       "are level: no heights to work out along their walls"},
      {"sectors with a sky",
       sectorsWith([](const Sector& s) { return s.floor.isSky || s.ceiling.isSky; }), sectors,
       "have no sky to turn with the view"},
      {"sectors with a flat portal",
       sectorsWith([](const Sector& s) { return s.floor.flatPortal || s.ceiling.flatPortal; }),
       sectors, "are seen through walls alone"},
      {"sectors with a grid over their walls",
       sectorsWith([](const Sector& s) { return s.wallGrid.has_value(); }), sectors,
       "have few walls: a look at all of them is as quick"},
      {"walls that are stacks", walls.stacks, walls.all,
       "are one piece from floor to ceiling: none to look for in their columns"},
      {"surfaces that are sidewalls",
       surfacesOf(SurfaceKind::FloorSidewall) + surfacesOf(SurfaceKind::CeilingSidewall),
       light.all.surfaces(), "are of walls and planes: no slope shows its side there"},
      {"surfaces that are middle textures", surfacesOf(SurfaceKind::MaskedMiddle),
       light.all.surfaces(), "are opaque: nothing behind them is drawn"},
      {"images that a surface wears", static_cast<std::int64_t>(loaded.decodedImages),
       count(level.textures, [](const std::string& name) { return !name.starts_with('#'); }),
       "show nowhere, and are not read"},
      {"surfaces with a lightmap", light.all.white + light.all.colored, light.all.surfaces(),
       "take no light (the table says why), and no bytes"},
      {"lightmaps of three channels", light.all.colored, light.all.white + light.all.colored,
       "take white light alone, in one channel"},
      {"lightmaps of more than one value", light.all.white + light.all.colored - light.all.even,
       light.all.white + light.all.colored, "are the same all over, and one texel"},
      {"lights with a colour", light.coloredLights, std::ssize(level.lights),
       "are white, and one number"},
      {"lights with a radius", light.spheres.lights, std::ssize(level.lights),
       "are points: a ray to a sample at most"},
      {"lights with a spot",
       count(level.lights, [](const LightSource& source) { return source.spot.has_value(); }),
       std::ssize(level.lights), "shine all around: no cone to test"},
      {"lights that are suns", light.suns.lights, std::ssize(level.lights),
       "have a place: no ray is followed to the sky"},
      {"light of the sky", light.skies.lights, std::ssize(level.lights),
       "come from one direction: nothing is gathered"},
      {"lights that are surfaces", light.emitters.lights, std::ssize(level.lights),
       "are no surfaces: no texture is asked whether it shines"},
  };
}

}  // namespace hearth
