#include "level/finish.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "level/openings.h"
#include "level/twins.h"
#include "math/check.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// A height that changes evenly along a segment, from p0 to p1.
struct Line {
  double at0;
  double at1;
  double at(double fraction) const { return std::lerp(at0, at1, fraction); }
};

Line flat(double z) { return {z, z}; }

/// The greatest height, anywhere along a segment, of what lies below all of `upper` and above all
/// of `lower`. That height is concave along the segment, so it is greatest at an end or where two
/// lines cross.
double tallest(const std::vector<Line>& upper, const std::vector<Line>& lower) {
  const auto heightAt = [&](double fraction) {
    double top = kEndless;
    double bottom = -kEndless;
    for (const Line& line : upper) top = std::min(top, line.at(fraction));
    for (const Line& line : lower) bottom = std::max(bottom, line.at(fraction));
    return top - bottom;
  };
  double best = std::max(heightAt(0), heightAt(1));
  for (const std::vector<Line>* lines : {&upper, &lower})
    for (const Line& a : *lines)
      for (const Line& b : *lines) {
        const double fraction = (a.at0 - b.at0) / ((a.at0 - b.at0) - (a.at1 - b.at1));
        if (fraction > 0 && fraction < 1) best = std::max(best, heightAt(fraction));
      }
  return best;
}

/// Adds the pieces of one segment, bottom to top.
class PieceBuilder {
 public:
  PieceBuilder(Level& level, const TwinIndex& twins, SegmentId id, std::vector<LevelFault>& faults)
      : level_(level),
        twins_(twins),
        id_(id),
        segment_(level[id]),
        sector_(level[level[id].sector]),
        faults_(faults) {}

  void build() {
    if (const Stack* stack = std::get_if<Stack>(&segment_.kind)) return buildStack(*stack);
    const Range range{sector_.floor.z, sector_.ceiling.z, true, true, false, 0};
    if (const Solid* solid = std::get_if<Solid>(&segment_.kind)) addSolid(*solid, range);
    if (const Portal* portal = std::get_if<Portal>(&segment_.kind)) addPortal(*portal, range);
  }

 private:
  /// Heights of a wall or sub-wall, and which of the sector's flats it reaches.
  struct Range {
    double zBottom;
    double zTop;
    bool atFloor;
    bool atCeiling;
    bool inStack;
    std::uint32_t subWall;
  };

  void buildStack(const Stack& stack) {
    double zBottom = sector_.floor.z;
    for (std::size_t i = 0; i < stack.subWalls.size(); ++i) {
      const SubWall& subWall = stack.subWalls[i];
      const bool last = i + 1 == stack.subWalls.size();
      const Range range{zBottom, subWall.zTop, i == 0, last, true, static_cast<std::uint32_t>(i)};
      if (const Solid* solid = std::get_if<Solid>(&subWall.kind)) addSolid(*solid, range);
      if (const Portal* portal = std::get_if<Portal>(&subWall.kind)) addPortal(*portal, range);
      zBottom = subWall.zTop;
    }
  }

  void addSolid(const Solid& solid, const Range& range) {
    const SurfaceKind kind = range.inStack ? SurfaceKind::StackSolid : SurfaceKind::Solid;
    addSurface(kind, solid.texture, range.zBottom, range.zTop, range.zTop, range);
  }

  void addPortal(const Portal& portal, const Range& range) {
    const Sector& next = level_[portal.next];
    const PortalHeights heights = portalHeights(
        range.zBottom, range.zTop, fitted(next.floor.z, range), fitted(next.ceiling.z, range));
    const bool bothSkyFloors = range.atFloor && sector_.floor.isSky && next.floor.isSky;
    const bool bothSkyCeilings = range.atCeiling && sector_.ceiling.isSky && next.ceiling.isSky;

    if (bothSkyFloors)
      addSurface(SurfaceKind::SkyLowerStep, sector_.floor.texture, heights.zBottom,
                 heights.zLowerTop, next.floor.z, range);
    else
      addSurface(range.inStack ? SurfaceKind::StackLowerStep : SurfaceKind::LowerStep, portal.lower,
                 heights.zBottom, heights.zLowerTop, next.floor.z, range);

    const std::optional<SegmentId> twin = twins_.find(segment_, portal.next);
    if (!twin) {
      faults_.push_back(MissingTwin{id_, range.subWall});
      return;
    }
    const std::optional<SurfaceId> maskedMiddle =
        portal.maskedMiddle
            ? addMaskedMiddle(*portal.maskedMiddle, heights.zLowerTop, heights.zUpperBottom)
            : std::nullopt;
    addOpening({portal.next, *twin, {}, {}, maskedMiddle}, heights.zLowerTop, heights.zUpperBottom,
               range);
    addLightOpening(portal.next, *twin, range, bothSkyFloors, bothSkyCeilings, maskedMiddle);

    if (bothSkyCeilings)
      addSurface(SurfaceKind::SkyUpperStep, sector_.ceiling.texture, heights.zUpperBottom,
                 heights.zTop, next.ceiling.z, range);
    else
      addSurface(range.inStack ? SurfaceKind::StackUpperStep : SurfaceKind::UpperStep, portal.upper,
                 heights.zUpperBottom, heights.zTop, next.ceiling.z, range);
  }

  /// A height of the next sector, or the end of the range that differs from it by rounding alone:
  /// that of a sub-wall is a sum.
  static double fitted(double z, const Range& range) {
    for (const double end : {range.zBottom, range.zTop})
      if (std::abs(z - end) <= kHeightNoise) return end;
    return z;
  }

  Line nearBottom() const { return {segment_.air0.zBottom, segment_.air1.zBottom}; }
  Line nearTop() const { return {segment_.air0.zTop, segment_.air1.zTop}; }

  /// True where some of [zBottom, zTop] lies between the sector's own slopes.
  bool isInAir(double zBottom, double zTop) const {
    return tallest({flat(zTop), nearTop()}, {flat(zBottom), nearBottom()}) > 0;
  }

  void addSurface(SurfaceKind kind, const std::optional<TextureMapping>& mapping, double zBottom,
                  double zTop, double defaultZRef, const Range& range) {
    if (!isInAir(zBottom, zTop)) return;
    if (!mapping) {
      faults_.push_back(MissingTexture{id_, range.subWall, kind});
      return;
    }
    segment_.pieces.push_back({zBottom, zTop, newSurface(kind, *mapping, zBottom, zTop)});
    Surface& surface = level_.surfaces.back();
    if (!surface.mapping.zRef && !isSky(kind)) surface.mapping.zRef = defaultZRef;
  }

  SurfaceId newSurface(SurfaceKind kind, const TextureMapping& mapping, double zBottom,
                       double zTop) {
    level_.surfaces.push_back({kind, segment_.sector, id_, mapping, zBottom, zTop});
    return SurfaceId(level_.surfaces.size() - 1);
  }

  /// What of an image shows that hangs in an opening of these heights, from its zref on down.
  std::optional<SurfaceId> addMaskedMiddle(const TextureMapping& mapping, double zBottom,
                                           double zTop) {
    const double zRef = mapping.zRef.value_or(zTop);
    zTop = std::min(zTop, zRef);
    zBottom = std::max(zBottom, zRef - mapping.repeat.y);
    if (!isInAir(zBottom, zTop)) return std::nullopt;
    const SurfaceId id = newSurface(SurfaceKind::MaskedMiddle, mapping, zBottom, zTop);
    level_.surfaces.back().mapping.zRef = zRef;
    return id;
  }

  /// `opening` without its sidewalls.
  void addOpening(Opening opening, double zBottom, double zTop, const Range& range) {
    if (zBottom >= zTop) return;
    const Sector& next = level_[opening.next];
    const Segment& far = level_[opening.twin];
    const Line farBottom{far.air1.zBottom, far.air0.zBottom};
    const Line farTop{far.air1.zTop, far.air0.zTop};
    const Line low = flat(zBottom);
    const Line high = flat(zTop);
    if (next.floorSlope &&
        tallest({high, nearTop(), farBottom}, {low, nearBottom()}) > kHeightNoise)
      opening.floorSidewall = addSidewall(SurfaceKind::FloorSidewall, *next.floorSlope,
                                          next.floor.z, zBottom, zTop, range);
    if (next.ceilingSlope && tallest({high, nearTop()}, {low, nearBottom(), farTop}) > kHeightNoise)
      opening.ceilingSidewall = addSidewall(SurfaceKind::CeilingSidewall, *next.ceilingSlope,
                                            next.ceiling.z, zBottom, zTop, range);
    segment_.pieces.push_back({zBottom, zTop, opening});
  }

  std::optional<SurfaceId> addSidewall(SurfaceKind kind, const Slope& slope, double zFlat,
                                       double zBottom, double zTop, const Range& range) {
    if (!slope.sidewall) {
      faults_.push_back(MissingTexture{id_, range.subWall, kind});
      return std::nullopt;
    }
    const SurfaceId id = newSurface(kind, *slope.sidewall, zBottom, zTop);
    Surface& surface = level_.surfaces.back();
    if (!surface.mapping.zRef && !slope.isRelative) surface.mapping.zRef = zFlat;
    return id;
  }

  /// Light passes from the higher floor to the lower ceiling, and between skies without end.
  void addLightOpening(SectorId nextId, SegmentId twin, const Range& range, bool bothSkyFloors,
                       bool bothSkyCeilings, std::optional<SurfaceId> maskedMiddle) {
    const Sector& next = level_[nextId];
    const double zTop = bothSkyCeilings ? kEndless : std::min(range.zTop, next.ceiling.z);
    const double zBottom = bothSkyFloors ? -kEndless : std::max(range.zBottom, next.floor.z);
    if (zBottom >= zTop) return;
    segment_.lightOpenings.push_back({zBottom, zTop, nextId, twin, {}});
    if (maskedMiddle) segment_.lightOpenings.back().maskedMiddles.push_back(*maskedMiddle);
  }

  Level& level_;
  const TwinIndex& twins_;
  SegmentId id_;
  Segment& segment_;
  const Sector& sector_;
  std::vector<LevelFault>& faults_;
};

/// Within the flats, as walls are: rounding may take the end of a wedge past the flat that it
/// stands on or hangs from.
AirColumn airColumnAt(const Sector& sector, Vec2 p) {
  return {std::max(sector.airBottom(p), sector.floor.z),
          std::min(sector.airTop(p), sector.ceiling.z)};
}

void measureSegments(Level& level) {
  for (Segment& segment : level.segments) {
    const Sector& sector = level[segment.sector];
    segment.length = length(segment.p1 - segment.p0);
    segment.air0 = airColumnAt(sector, segment.p0);
    segment.air1 = airColumnAt(sector, segment.p1);
    segment.airRises = segment.air0 != segment.air1;
  }
}

void measureBox(Level& level, Sector& sector) {
  sector.boxMin = {kEndless, kEndless};
  sector.boxMax = {-kEndless, -kEndless};
  for (const Segment& segment : level.segmentsOf(sector)) {
    sector.boxMin = {std::min(sector.boxMin.x, segment.p0.x),
                     std::min(sector.boxMin.y, segment.p0.y)};
    sector.boxMax = {std::max(sector.boxMax.x, segment.p0.x),
                     std::max(sector.boxMax.y, segment.p0.y)};
  }
}

/// Light through an opening meets what hangs in it on the other side, too.
void addMaskedMiddlesOfTwins(Level& level) {
  for (std::size_t i = 0; i < level.segments.size(); ++i)
    for (LightOpening& light : level.segments[i].lightOpenings)
      for (const WallPiece& piece : level[light.twin].pieces) {
        const Opening* back = std::get_if<Opening>(&piece.content);
        if (back && back->maskedMiddle && back->twin == SegmentId(i))
          light.maskedMiddles.push_back(*back->maskedMiddle);
      }
}

std::optional<SurfaceId> addFlat(Level& level, SectorId sector, const Flat& flat, bool isFloor,
                                 bool hasSlope) {
  if (flat.flatPortal) return std::nullopt;
  SurfaceKind kind = isFloor ? SurfaceKind::Floor : SurfaceKind::Ceiling;
  if (hasSlope) kind = isFloor ? SurfaceKind::SlopeFloor : SurfaceKind::SlopeCeiling;
  if (flat.isSky) kind = isFloor ? SurfaceKind::SkyFloor : SurfaceKind::SkyCeiling;
  CHECK(flat.texture, level[sector].name, name(kind));
  level.surfaces.push_back({kind, sector, std::nullopt, *flat.texture, flat.z, flat.z});
  return SurfaceId(level.surfaces.size() - 1);
}

}  // namespace

std::vector<LevelFault> finishLevel(Level& level) {
  std::vector<LevelFault> faults;
  measureSegments(level);
  for (std::size_t i = 0; i < level.sectors.size(); ++i) {
    Sector& sector = level.sectors[i];
    measureBox(level, sector);
    sector.floorSurface =
        addFlat(level, SectorId(i), sector.floor, true, sector.floorSlope.has_value());
    sector.ceilingSurface =
        addFlat(level, SectorId(i), sector.ceiling, false, sector.ceilingSlope.has_value());
  }
  const TwinIndex twins(level);
  for (std::size_t i = 0; i < level.segments.size(); ++i)
    PieceBuilder(level, twins, SegmentId(i), faults).build();
  addMaskedMiddlesOfTwins(level);
  return faults;
}

}  // namespace hearth
