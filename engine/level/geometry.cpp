#include "level/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "level/openings.h"
#include "level/scene.h"
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
double tallest(std::span<const Line> upper, std::span<const Line> lower) {
  const auto heightAt = [&](double fraction) {
    double top = kEndless;
    double bottom = -kEndless;
    for (const Line& line : upper) top = std::min(top, line.at(fraction));
    for (const Line& line : lower) bottom = std::max(bottom, line.at(fraction));
    return top - bottom;
  };
  double best = std::max(heightAt(0), heightAt(1));
  for (const std::span<const Line> lines : {upper, lower})
    for (const Line& a : lines)
      for (const Line& b : lines) {
        const double fraction = (a.at0 - b.at0) / ((a.at0 - b.at0) - (a.at1 - b.at1));
        if (fraction > 0 && fraction < 1) best = std::max(best, heightAt(fraction));
      }
  return best;
}

double tallest(std::initializer_list<Line> upper, std::initializer_list<Line> lower) {
  return tallest(std::span(upper.begin(), upper.size()), std::span(lower.begin(), lower.size()));
}

/// Within the flats, as walls are: rounding may take the end of a wedge past the flat that it
/// stands on or hangs from.
AirColumn airColumnAt(const Scene& scene, const Sector& sector, Vec2 p) {
  return {std::max(scene.airBottom(sector, p), scene.zFloor(sector)),
          std::min(scene.airTop(sector, p), scene.zCeiling(sector))};
}

/// Derives the pieces and light openings of one segment, bottom to top, in place.
class SegmentDeriver {
 public:
  SegmentDeriver(const Level& level, Geometry& geometry, SegmentId id,
                 std::vector<MissingTexture>* missing)
      : scene_(level, geometry),
        geometry_(geometry),
        segment_(level[id]),
        sector_(level[level[id].sector]),
        own_(geometry.segments[id.index()]),
        missing_(missing) {}

  void derive() {
    own_.pieceCount = 0;
    own_.lightOpeningCount = 0;
    const auto walls = scene_.level().surfacesOf(segment_);
    if (const Stack* stack = std::get_if<Stack>(&segment_.wall)) return deriveStack(*stack, walls);
    const Range range{scene_.zFloor(sector_), scene_.zCeiling(sector_), false, 0};
    if (const Portal* portal = std::get_if<Portal>(&segment_.wall))
      addPortal(*portal, walls[0], range);
    else
      addSolid(walls[0], range);
  }

 private:
  /// Heights of a wall or sub-wall.
  struct Range {
    double zBottom;
    double zTop;
    bool inStack;
    std::uint32_t subWall;
  };

  void deriveStack(const Stack& stack, std::span<const WallSurfaces> walls) {
    double zBottom = scene_.zFloor(sector_);
    for (std::size_t i = 0; i < stack.subWalls.size(); ++i) {
      const double zTop = stack.topOf(i, scene_.zFloor(sector_), scene_.zCeiling(sector_));
      const Range range{zBottom, zTop, true, static_cast<std::uint32_t>(i)};
      if (const Portal* portal = std::get_if<Portal>(&stack.subWalls[i].kind))
        addPortal(*portal, walls[i], range);
      else
        addSolid(walls[i], range);
      zBottom = zTop;
    }
  }

  void addSolid(const WallSurfaces& surfaces, const Range& range) {
    hide(surfaces);
    const SurfaceKind kind = range.inStack ? SurfaceKind::StackSolid : SurfaceKind::Solid;
    addSurface(kind, surfaces.solid, range.zBottom, range.zTop, range.zTop, range);
  }

  void addPortal(const Portal& portal, const WallSurfaces& surfaces, const Range& range) {
    const SectorGeometry& nextAt = scene_.geometryOf(scene_[portal.next]);
    const PortalHeights heights = portalHeights(
        range.zBottom, range.zTop, fitted(nextAt.zFloor, range), fitted(nextAt.zCeiling, range));
    hide(surfaces);
    addSurface(range.inStack ? SurfaceKind::StackLowerStep : SurfaceKind::LowerStep, surfaces.lower,
               heights.zBottom, heights.zLowerTop, nextAt.zFloor, range);
    if (!surfaces.twin) return;
    const std::optional<SurfaceId> maskedMiddle =
        surfaces.maskedMiddle
            ? showMaskedMiddle(*surfaces.maskedMiddle, heights.zLowerTop, heights.zUpperBottom)
            : std::nullopt;
    addOpening({portal.next, *surfaces.twin, {}, {}, maskedMiddle}, surfaces, heights.zLowerTop,
               heights.zUpperBottom, range);
    addLightOpening({0, 0, portal.next, *surfaces.twin, surfaces.firstMaskedMiddle, 0}, surfaces,
                    maskedMiddle, range);
    addSurface(range.inStack ? SurfaceKind::StackUpperStep : SurfaceKind::UpperStep, surfaces.upper,
               heights.zUpperBottom, heights.zTop, nextAt.zCeiling, range);
  }

  /// A height of the next sector, or the end of the range that differs from it by rounding alone:
  /// that of a sub-wall is a sum.
  static double fitted(double z, const Range& range) {
    for (const double end : {range.zBottom, range.zTop})
      if (std::abs(z - end) <= kHeightNoise) return end;
    return z;
  }

  Line nearBottom() const { return {own_.air0.zBottom, own_.air1.zBottom}; }
  Line nearTop() const { return {own_.air0.zTop, own_.air1.zTop}; }

  /// True where some of [zBottom, zTop] lies between the sector's own slopes.
  bool isInAir(double zBottom, double zTop) const {
    return tallest({flat(zTop), nearTop()}, {flat(zBottom), nearBottom()}) > 0;
  }

  void hide(const WallSurfaces& surfaces) {
    for (const auto& id : {surfaces.solid, surfaces.lower, surfaces.upper, surfaces.maskedMiddle,
                           surfaces.floorSidewall, surfaces.ceilingSidewall})
      if (id) geometry_.surfaces[id->index()] = {};
  }

  /// `kind` is that of the texture which is missing where there is no surface.
  void addSurface(SurfaceKind kind, std::optional<SurfaceId> id, double zBottom, double zTop,
                  double defaultZRef, const Range& range) {
    if (!isInAir(zBottom, zTop)) return;
    if (!id) return miss(kind, range);
    show(*id, zBottom, zTop, defaultZRef);
    addPiece({zBottom, zTop, *id});
  }

  void show(SurfaceId id, double zBottom, double zTop, std::optional<double> defaultZRef) {
    const Surface& surface = scene_[id];
    SurfaceGeometry& at = geometry_.surfaces[id.index()];
    at = {true, zBottom, zTop, surface.mapping.zRef};
    if (!at.zRef && !isSky(surface.kind)) at.zRef = defaultZRef;
  }

  void miss(SurfaceKind kind, const Range& range) {
    CHECK(missing_, "a step without a texture shows", segment_.id, range.subWall, name(kind));
    missing_->push_back({segment_.id, range.subWall, kind});
  }

  void addPiece(const WallPiece& piece) {
    geometry_.pieces[Geometry::kPiecesPerWall * segment_.firstWall + own_.pieceCount++] = piece;
  }

  /// Shows the part of a masked texture that lies in an opening of these heights; the image hangs
  /// down from its zref.
  std::optional<SurfaceId> showMaskedMiddle(SurfaceId id, double zBottom, double zTop) {
    const TextureMapping& mapping = scene_[id].mapping;
    const double zRef = mapping.zRef.value_or(zTop);
    zTop = std::min(zTop, zRef);
    zBottom = std::max(zBottom, zRef - mapping.repeat.y);
    if (!isInAir(zBottom, zTop)) return std::nullopt;
    show(id, zBottom, zTop, zRef);
    return id;
  }

  /// `opening` without its sidewalls.
  void addOpening(Opening opening, const WallSurfaces& surfaces, double zBottom, double zTop,
                  const Range& range) {
    if (zBottom >= zTop) return;
    const Sector& next = scene_[opening.next];
    const SegmentGeometry& far = geometry_.segments[opening.twin.index()];
    const Line farBottom{far.air1.zBottom, far.air0.zBottom};
    const Line farTop{far.air1.zTop, far.air0.zTop};
    const Line low = flat(zBottom);
    const Line high = flat(zTop);
    if (next.floorSlope &&
        tallest({high, nearTop(), farBottom}, {low, nearBottom()}) > kHeightNoise)
      opening.floorSidewall =
          showSidewall(SurfaceKind::FloorSidewall, surfaces.floorSidewall, *next.floorSlope,
                       scene_.zFloor(next), zBottom, zTop, range);
    if (next.ceilingSlope && tallest({high, nearTop()}, {low, nearBottom(), farTop}) > kHeightNoise)
      opening.ceilingSidewall =
          showSidewall(SurfaceKind::CeilingSidewall, surfaces.ceilingSidewall, *next.ceilingSlope,
                       scene_.zCeiling(next), zBottom, zTop, range);
    addPiece({zBottom, zTop, opening});
  }

  std::optional<SurfaceId> showSidewall(SurfaceKind kind, std::optional<SurfaceId> id,
                                        const Slope& slope, double zFlat, double zBottom,
                                        double zTop, const Range& range) {
    if (id)
      show(*id, zBottom, zTop, slope.isRelative ? std::nullopt : std::optional(zFlat));
    else
      miss(kind, range);
    return id;
  }

  /// Light passes from the higher floor to the lower ceiling, and between skies without end.
  void addLightOpening(LightOpening opening, const WallSurfaces& surfaces,
                       std::optional<SurfaceId> maskedMiddle, const Range& range) {
    const SectorGeometry& next = scene_.geometryOf(scene_[opening.next]);
    const auto isBeforeSky = [&](std::optional<SurfaceId> step) {
      return step && isSky(scene_[*step].kind);
    };
    opening.zBottom =
        isBeforeSky(surfaces.lower) ? -kEndless : std::max(range.zBottom, next.zFloor);
    opening.zTop = isBeforeSky(surfaces.upper) ? kEndless : std::min(range.zTop, next.zCeiling);
    if (opening.zBottom >= opening.zTop) return;
    if (maskedMiddle)
      geometry_.maskedMiddles[opening.firstMaskedMiddle + opening.maskedMiddleCount++] =
          *maskedMiddle;
    geometry_.lightOpenings[segment_.firstWall + own_.lightOpeningCount++] = opening;
  }

  Scene scene_;
  Geometry& geometry_;
  const Segment& segment_;
  const Sector& sector_;
  SegmentGeometry& own_;
  std::vector<MissingTexture>* missing_;  ///< none where textures are known to be there
};

/// Light through an opening meets what hangs in it on the other side, too. After all pieces.
void addMaskedMiddlesOfTwins(const Scene& scene, const Segment& segment, Geometry& geometry) {
  const std::span<LightOpening> openings{geometry.lightOpenings.data() + segment.firstWall,
                                         scene.geometryOf(segment).lightOpeningCount};
  for (LightOpening& light : openings)
    for (const WallPiece& piece : scene.piecesOf(scene[light.twin])) {
      const Opening* back = std::get_if<Opening>(&piece.content);
      if (back && back->maskedMiddle && back->twin == segment.id)
        geometry.maskedMiddles[light.firstMaskedMiddle + light.maskedMiddleCount++] =
            *back->maskedMiddle;
    }
}

/// What follows from a sector's flats in the sector itself, its walls apart.
void deriveAir(const Scene& scene, const Sector& sector, Geometry& geometry) {
  const auto [zFloor, zCeiling] = scene.geometryOf(sector);
  if (sector.floorSurface)
    geometry.surfaces[sector.floorSurface->index()] = {true, zFloor, zFloor, {}};
  if (sector.ceilingSurface)
    geometry.surfaces[sector.ceilingSurface->index()] = {true, zCeiling, zCeiling, {}};
  for (const Segment& segment : scene.segmentsOf(sector)) {
    SegmentGeometry& at = geometry.segments[segment.id.index()];
    at.air0 = airColumnAt(scene, sector, segment.p0);
    at.air1 = airColumnAt(scene, sector, segment.p1);
    at.airRises = at.air0 != at.air1;
  }
}

AirColumn heightsOf(const Level& level, const Mesh& mesh) {
  AirColumn heights{mesh.position.z, mesh.position.z};
  for (const MeshFace& face : level.facesOf(mesh))
    for (const Vec3 corner : face.corners)
      heights = {std::min(heights.zBottom, corner.z), std::max(heights.zTop, corner.z)};
  return heights;
}

/// All of those that have surfaces.
void showThings(const Level& level, Geometry& geometry) {
  for (const Sprite& sprite : level.sprites) {
    const bool lies = sprite.facing == Facing::Flat;
    const double zBottom = sprite.position.z + (lies ? 0 : sprite.offset.y);
    const double height = lies ? 0 : sprite.frames.front().front().size.y;
    geometry.surfaces[sprite.surface.index()] = {true, zBottom, zBottom + height, {}};
  }
  for (const Mesh& mesh : level.meshes) {
    const auto [zBottom, zTop] = heightsOf(level, mesh);
    geometry.surfaces[mesh.surface.index()] = {true, zBottom, zTop, {}};
  }
}

SurfaceKind kindOf(Facing facing) {
  if (facing == Facing::Angle) return SurfaceKind::FixedSprite;
  return facing == Facing::Flat ? SurfaceKind::FlatSprite : SurfaceKind::CameraSprite;
}

/// Whether a flat stays where it was authored.
bool isFixed(const Flat& flat, const std::optional<Slope>& slope) {
  return flat.isSky || flat.flatPortal || slope;
}

void setHeights(const Sector& sector, SectorGeometry heights, Geometry& geometry) {
  CHECK(heights.zFloor <= heights.zCeiling, sector.name, heights.zFloor, heights.zCeiling);
  CHECK(!isFixed(sector.floor, sector.floorSlope) || heights.zFloor == sector.floor.z, sector.name,
        heights.zFloor);
  CHECK(!isFixed(sector.ceiling, sector.ceilingSlope) || heights.zCeiling == sector.ceiling.z,
        sector.name, heights.zCeiling);
  geometry.sectors[sector.id.index()] = heights;
}

/// The walls of a sector, and those of others that lead into it.
template <typename Visit>
void forEachWallAt(const Level& level, const Sector& sector, Visit&& visit) {
  for (const Segment& segment : level.segmentsOf(sector)) visit(segment);
  for (const SegmentId entrance : level.entrancesOf(sector))
    if (level[entrance].sector != sector.id) visit(level[entrance]);
}

}  // namespace

Geometry deriveGeometry(const Level& level, std::vector<MissingTexture>& missing) {
  Geometry geometry;
  for (const Sector& sector : level.sectors)
    geometry.sectors.push_back({sector.floor.z, sector.ceiling.z});
  geometry.segments.resize(level.segments.size());
  geometry.surfaces.resize(level.surfaces.size());
  geometry.pieces.resize(Geometry::kPiecesPerWall * level.wallSurfaces.size());
  geometry.lightOpenings.resize(level.wallSurfaces.size());
  geometry.maskedMiddles.resize(level.maskedMiddlesInOpenings);
  const Scene scene(level, geometry);
  for (const Sector& sector : level.sectors) deriveAir(scene, sector, geometry);
  for (const Segment& segment : level.segments)
    SegmentDeriver(level, geometry, segment.id, &missing).derive();
  for (const Segment& segment : level.segments) addMaskedMiddlesOfTwins(scene, segment, geometry);
  showThings(level, geometry);
  return geometry;
}

void addThingSurfaces(Level& level, Geometry& geometry) {
  const auto add = [&](SurfaceKind kind, SectorId sector, const TextureMapping& mapping) {
    level.surfaces.push_back({kind, sector, std::nullopt, mapping});
    return SurfaceId(level.surfaces.size() - 1);
  };
  for (Sprite& sprite : level.sprites) {
    TextureMapping mapping;
    mapping.texture = sprite.frames.front().front().texture;
    sprite.surface = add(kindOf(sprite.facing), sprite.sector, mapping);
  }
  for (Mesh& mesh : level.meshes) {
    TextureMapping mapping;
    mapping.texture = level.facesOf(mesh).front().texture;
    mesh.surface = add(SurfaceKind::Mesh, mesh.sector, mapping);
  }
  geometry.surfaces.resize(level.surfaces.size());
  showThings(level, geometry);
}

void moveFlats(const Level& level, std::span<const MovedFlats> moved, Geometry& geometry,
               std::vector<MissingTexture>* missing) {
  const Scene scene(level, geometry);
  for (const auto& [id, heights] : moved) setHeights(level[id], heights, geometry);
  for (const auto& [id, heights] : moved) deriveAir(scene, level[id], geometry);
  // A wall between two of them is derived with each, the last time with both of its sides.
  for (const auto& [id, heights] : moved) {
    forEachWallAt(level, level[id], [&](const Segment& segment) {
      SegmentDeriver(level, geometry, segment.id, missing).derive();
    });
    forEachWallAt(level, level[id], [&](const Segment& segment) {
      addMaskedMiddlesOfTwins(scene, segment, geometry);
    });
  }
}

void moveFlats(const Level& level, SectorId sector, SectorGeometry heights, Geometry& geometry) {
  const MovedFlats moved{sector, heights};
  moveFlats(level, {&moved, 1}, geometry);
}

}  // namespace hearth
