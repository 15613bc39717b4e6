#include "level/link_surfaces.h"

#include <algorithm>
#include <limits>

#include "level/twins.h"
#include "math/check.h"

namespace hearth {

namespace {

/// From about so many walls on, a grid over them saves more time in bakes than it takes; in frames
/// from about 2,000 on, and before it takes a twentieth more.
constexpr std::size_t kFewestWallsOfGrid = 512;

/// Adds the surfaces of one segment, from bottom to top.
class SurfaceBuilder {
 public:
  SurfaceBuilder(Level& level, const TwinIndex& twins, SegmentId id,
                 std::vector<MissingTwin>& missing)
      : level_(level),
        twins_(twins),
        segment_(level[id]),
        sector_(level[level[id].sector]),
        missing_(missing) {}

  void build() {
    segment_.firstWall = static_cast<std::uint32_t>(level_.wallSurfaces.size());
    if (const Stack* stack = std::get_if<Stack>(&segment_.wall))
      buildStack(*stack);
    else if (const Solid* solid = std::get_if<Solid>(&segment_.wall))
      addSolid(*solid, {});
    else
      addPortal(std::get<Portal>(segment_.wall), {});
    segment_.wallCount =
        static_cast<std::uint32_t>(level_.wallSurfaces.size()) - segment_.firstWall;
  }

 private:
  /// Where in its segment a wall is.
  struct Position {
    std::uint32_t subWall = 0;
    bool inStack = false;
    bool atFloor = true;
    bool atCeiling = true;
  };

  void buildStack(const Stack& stack) {
    for (std::size_t i = 0; i < stack.subWalls.size(); ++i) {
      const bool isLast = i + 1 == stack.subWalls.size();
      const Position position{static_cast<std::uint32_t>(i), true, i == 0, isLast};
      if (const Solid* solid = std::get_if<Solid>(&stack.subWalls[i].kind))
        addSolid(*solid, position);
      else
        addPortal(std::get<Portal>(stack.subWalls[i].kind), position);
    }
  }

  void addSolid(const Solid& solid, Position position) {
    WallSurfaces surfaces;
    surfaces.solid =
        newSurface(position.inStack ? SurfaceKind::StackSolid : SurfaceKind::Solid, solid.texture);
    level_.wallSurfaces.push_back(surfaces);
  }

  void addPortal(const Portal& portal, Position position) {
    const Sector& next = level_[portal.next];
    WallSurfaces surfaces;
    if (position.atFloor && sector_.floor.isSky && next.floor.isSky)
      surfaces.lower = newSurface(SurfaceKind::SkyLowerStep, sector_.floor.texture);
    else
      surfaces.lower = newSurface(
          position.inStack ? SurfaceKind::StackLowerStep : SurfaceKind::LowerStep, portal.lower);

    surfaces.twin = twins_.find(segment_, portal.next);
    if (!surfaces.twin) missing_.push_back({segment_.id, position.subWall});
    surfaces.maskedMiddle = newSurface(SurfaceKind::MaskedMiddle, portal.maskedMiddle);
    if (next.floorSlope)
      surfaces.floorSidewall = newSurface(SurfaceKind::FloorSidewall, next.floorSlope->sidewall);
    if (next.ceilingSlope)
      surfaces.ceilingSidewall =
          newSurface(SurfaceKind::CeilingSidewall, next.ceilingSlope->sidewall);

    if (position.atCeiling && sector_.ceiling.isSky && next.ceiling.isSky)
      surfaces.upper = newSurface(SurfaceKind::SkyUpperStep, sector_.ceiling.texture);
    else
      surfaces.upper = newSurface(
          position.inStack ? SurfaceKind::StackUpperStep : SurfaceKind::UpperStep, portal.upper);
    level_.wallSurfaces.push_back(surfaces);
  }

  /// Returns none if there is no texture. Then the surface must not show at any height.
  std::optional<SurfaceId> newSurface(SurfaceKind kind,
                                      const std::optional<TextureMapping>& mapping) {
    if (!mapping) return std::nullopt;
    level_.surfaces.push_back({kind, segment_.sector, segment_.id, *mapping});
    return SurfaceId(level_.surfaces.size() - 1);
  }

  Level& level_;
  const TwinIndex& twins_;
  Segment& segment_;
  const Sector& sector_;
  std::vector<MissingTwin>& missing_;
};

void measureBox(Level& level, Sector& sector) {
  sector.box = {};
  for (const Segment& segment : level.segmentsOf(sector)) sector.box.add(segment.p0);
}

std::optional<SurfaceId> addFlat(Level& level, const Sector& sector, const Flat& flat, bool isFloor,
                                 bool hasSlope) {
  if (flat.flatPortal) return std::nullopt;
  SurfaceKind kind = isFloor ? SurfaceKind::Floor : SurfaceKind::Ceiling;
  if (hasSlope) kind = isFloor ? SurfaceKind::SlopeFloor : SurfaceKind::SlopeCeiling;
  if (flat.isSky) kind = isFloor ? SurfaceKind::SkyFloor : SurfaceKind::SkyCeiling;
  CHECK(flat.texture, sector.name, name(kind));
  level.surfaces.push_back({kind, sector.id, std::nullopt, *flat.texture});
  return SurfaceId(level.surfaces.size() - 1);
}

void addFlats(Level& level) {
  for (std::size_t i = 0; i < level.sectors.size(); ++i) {
    Sector& sector = level.sectors[i];
    sector.id = SectorId(i);
    measureBox(level, sector);
    sector.floorSurface = addFlat(level, sector, sector.floor, true, sector.floorSlope.has_value());
    sector.ceilingSurface =
        addFlat(level, sector, sector.ceiling, false, sector.ceilingSlope.has_value());
  }
}

/// The sectors that a segment leads to, each once.
std::vector<SectorId> nextSectors(const Level& level, const Segment& segment) {
  std::vector<SectorId> next;
  for (const WallSurfaces& surfaces : level.surfacesOf(segment))
    if (surfaces.twin) next.push_back(level[*surfaces.twin].sector);
  std::ranges::sort(next);
  next.erase(std::unique(next.begin(), next.end()), next.end());
  return next;
}

void addEntrances(Level& level) {
  for (const Segment& segment : level.segments)
    for (const SectorId next : nextSectors(level, segment)) ++level[next].entranceCount;
  std::uint32_t first = 0;
  for (Sector& sector : level.sectors) {
    sector.firstEntrance = first;
    first += sector.entranceCount;
    sector.entranceCount = 0;
  }
  level.entrances.resize(first);
  for (const Segment& segment : level.segments)
    for (const SectorId next : nextSectors(level, segment)) {
      Sector& sector = level[next];
      level.entrances[sector.firstEntrance + sector.entranceCount++] = segment.id;
    }
}

/// Numbers the masked middle textures that can hang in the opening of each wall, seen from either
/// side.
void numberMaskedMiddles(Level& level) {
  const auto countIn = [&](SegmentId id) {
    return static_cast<std::uint32_t>(std::ranges::count_if(
        level.surfacesOf(level[id]),
        [](const WallSurfaces& surfaces) { return surfaces.maskedMiddle.has_value(); }));
  };
  for (WallSurfaces& surfaces : level.wallSurfaces) {
    surfaces.firstMaskedMiddle = level.maskedMiddlesInOpenings;
    if (surfaces.maskedMiddle) ++level.maskedMiddlesInOpenings;
    if (surfaces.twin) level.maskedMiddlesInOpenings += countIn(*surfaces.twin);
  }
}

}  // namespace

std::vector<MissingTwin> linkSurfaces(Level& level) {
  std::vector<MissingTwin> missing;
  for (std::size_t i = 0; i < level.segments.size(); ++i) {
    Segment& segment = level.segments[i];
    segment.id = SegmentId(i);
    segment.length = length(segment.p1 - segment.p0);
  }
  addFlats(level);
  const TwinIndex twins(level);
  for (std::size_t i = 0; i < level.segments.size(); ++i)
    SurfaceBuilder(level, twins, SegmentId(i), missing).build();
  addEntrances(level);
  numberMaskedMiddles(level);
  addWallGrids(level, kFewestWallsOfGrid);
  return missing;
}

void addWallGrids(Level& level, std::size_t fewestWalls) {
  level.wallGrids.clear();
  CellId next(0);
  for (Sector& sector : level.sectors) {
    sector.wallGrid.reset();
    if (sector.segmentCount < fewestWalls) continue;
    sector.wallGrid = static_cast<std::uint32_t>(level.wallGrids.size());
    const WallGrid& grid = level.wallGrids.emplace_back(level.segmentsOf(sector), sector.box, next);
    next = CellId(next.index() + grid.cellCount());
  }
}

}  // namespace hearth
