#include "level/link_surfaces.h"

#include <algorithm>
#include <limits>

#include "level/twins.h"
#include "math/check.h"

namespace hearth {

namespace {

/// Adds the parts of one segment, and their surfaces from bottom to top.
class PartBuilder {
 public:
  PartBuilder(Level& level, const TwinIndex& twins, SegmentId id, std::vector<MissingTwin>& missing)
      : level_(level),
        twins_(twins),
        segment_(level[id]),
        sector_(level[level[id].sector]),
        missing_(missing) {}

  void build() {
    segment_.firstPart = static_cast<std::uint32_t>(level_.parts.size());
    if (const Stack* stack = std::get_if<Stack>(&segment_.kind))
      buildStack(*stack);
    else if (const Solid* solid = std::get_if<Solid>(&segment_.kind))
      addSolid(*solid, {});
    else
      addPortal(std::get<Portal>(segment_.kind), {});
    segment_.partCount = static_cast<std::uint32_t>(level_.parts.size()) - segment_.firstPart;
  }

 private:
  /// Where in its segment a part is.
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
    WallPart part;
    part.solid =
        newSurface(position.inStack ? SurfaceKind::StackSolid : SurfaceKind::Solid, solid.texture);
    level_.parts.push_back(part);
  }

  void addPortal(const Portal& portal, Position position) {
    const Sector& next = level_[portal.next];
    WallPart part;
    if (position.atFloor && sector_.floor.isSky && next.floor.isSky)
      part.lower = newSurface(SurfaceKind::SkyLowerStep, sector_.floor.texture);
    else
      part.lower = newSurface(
          position.inStack ? SurfaceKind::StackLowerStep : SurfaceKind::LowerStep, portal.lower);

    part.twin = twins_.find(segment_, portal.next);
    if (!part.twin) missing_.push_back({segment_.id, position.subWall});
    part.maskedMiddle = newSurface(SurfaceKind::MaskedMiddle, portal.maskedMiddle);
    if (next.floorSlope)
      part.floorSidewall = newSurface(SurfaceKind::FloorSidewall, next.floorSlope->sidewall);
    if (next.ceilingSlope)
      part.ceilingSidewall = newSurface(SurfaceKind::CeilingSidewall, next.ceilingSlope->sidewall);

    if (position.atCeiling && sector_.ceiling.isSky && next.ceiling.isSky)
      part.upper = newSurface(SurfaceKind::SkyUpperStep, sector_.ceiling.texture);
    else
      part.upper = newSurface(
          position.inStack ? SurfaceKind::StackUpperStep : SurfaceKind::UpperStep, portal.upper);
    level_.parts.push_back(part);
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
  constexpr double kFarthest = std::numeric_limits<double>::infinity();
  sector.boxMin = {kFarthest, kFarthest};
  sector.boxMax = {-kFarthest, -kFarthest};
  for (const Segment& segment : level.segmentsOf(sector)) {
    sector.boxMin = {std::min(sector.boxMin.x, segment.p0.x),
                     std::min(sector.boxMin.y, segment.p0.y)};
    sector.boxMax = {std::max(sector.boxMax.x, segment.p0.x),
                     std::max(sector.boxMax.y, segment.p0.y)};
  }
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
  for (const WallPart& part : level.partsOf(segment))
    if (part.twin) next.push_back(level[*part.twin].sector);
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

/// Numbers the masked middle textures that can hang in each part's opening, seen from either side.
void numberMaskedMiddles(Level& level) {
  const auto countIn = [&](SegmentId id) {
    return static_cast<std::uint32_t>(
        std::ranges::count_if(level.partsOf(level[id]),
                              [](const WallPart& part) { return part.maskedMiddle.has_value(); }));
  };
  for (WallPart& part : level.parts) {
    part.firstMaskedMiddle = level.maskedMiddlesInOpenings;
    if (part.maskedMiddle) ++level.maskedMiddlesInOpenings;
    if (part.twin) level.maskedMiddlesInOpenings += countIn(*part.twin);
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
    PartBuilder(level, twins, SegmentId(i), missing).build();
  addEntrances(level);
  numberMaskedMiddles(level);
  return missing;
}

}  // namespace hearth
