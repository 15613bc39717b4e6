#include "truth/wall_hit.h"

#include <algorithm>

#include "math/check.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "math/wrapped.h"

namespace hearth {

namespace {

/// The wall or sub-wall that the ray meets.
struct WallPart {
  SubWallKind kind;
  std::uint32_t index;
  bool inStack;
  bool atFloor;
  bool atCeiling;
  double zTop;
};

WallPart partAt(const Segment& segment, const Sector& sector, double z) {
  if (const Solid* solid = std::get_if<Solid>(&segment.wall))
    return {*solid, 0, false, true, true, sector.ceiling.z};
  if (const Portal* portal = std::get_if<Portal>(&segment.wall))
    return {*portal, 0, false, true, true, sector.ceiling.z};
  const Stack& stack = std::get<Stack>(segment.wall);
  const auto topOf = [&](std::size_t i) {
    return stack.topOf(i, sector.floor.z, sector.ceiling.z);
  };
  std::size_t i = 0;
  while (i + 1 < stack.subWalls.size() && z >= topOf(i)) ++i;
  const bool isLast = i + 1 == stack.subWalls.size();
  return {stack.subWalls[i].kind, static_cast<std::uint32_t>(i), true, i == 0, isLast, topOf(i)};
}

SegmentId findTwin(const Level& level, SectorId next, const Segment& segment) {
  for (const Segment& candidate : level.segmentsOf(level[next]))
    if (candidate.p0 == segment.p1 && candidate.p1 == segment.p0)
      return SegmentId(static_cast<std::size_t>(&candidate - level.segments.data()));
  checkFailed(__FILE__, __LINE__, "a portal has a twin", level[next].name);
}

/// One ray at one segment.
class Meeting {
 public:
  Meeting(const Level& level, const Ray& ray, SegmentId id, double t)
      : level_(level),
        ray_(ray),
        id_(id),
        segment_(level[id]),
        sector_(level[segment_.sector]),
        t_(t),
        point_(ray.at(t)),
        part_() {
    // Rounding may take the ray out of the air that it is in; only light is ever truly out of it.
    const double bottom = sector_.authoredBottom(point_.xy());
    const double top = sector_.authoredTop(point_.xy());
    if (!(isLight() && sector_.floor.isSky)) point_.z = std::max(point_.z, bottom);
    if (!(isLight() && sector_.ceiling.isSky)) point_.z = std::min(point_.z, top);
    part_ = partAt(segment_, sector_, point_.z);
  }

  std::variant<TruthHit, PortalCrossing> result() const {
    if (const Portal* portal = std::get_if<Portal>(&part_.kind)) {
      if (ray_.litMaskedMiddle == id_ && portal->maskedMiddle)
        return maskedMiddleAt(id_, part_, *portal->maskedMiddle, 0);
      return throughPortal(*portal);
    }
    return hit(part_.inStack ? SurfaceKind::StackSolid : SurfaceKind::Solid,
               std::get<Solid>(part_.kind).texture, part_.zTop);
  }

 private:
  bool isLight() const { return ray_.kind == RayKind::Light; }

  std::variant<TruthHit, PortalCrossing> throughPortal(const Portal& portal) const {
    const Sector& next = level_[portal.next];
    const double z = point_.z;
    const bool isClosed = next.floor.z >= next.ceiling.z;
    const bool isBelow = z < std::max(sector_.floor.z, next.floor.z);
    const bool isAbove = z > std::min(sector_.ceiling.z, next.ceiling.z);
    const bool isSkyBelow = part_.atFloor && sector_.floor.isSky && next.floor.isSky;
    const bool isSkyAbove = part_.atCeiling && sector_.ceiling.isSky && next.ceiling.isSky;
    // To light the opening between sky floors has no bottom. It still ends at the lower ceiling.
    if (isBelow && !(isSkyBelow && isLight())) {
      if (const auto step = isSkyBelow ? skyStep(false) : lowerStep(portal, next)) return *step;
    } else if (isAbove || (isClosed && !isBelow)) {
      if (const auto step = isSkyAbove ? skyStep(true) : upperStep(portal, next)) return *step;
    }
    const SegmentId twin = findTwin(level_, portal.next, segment_);
    if (const auto wedge = sidewall(next, level_[twin])) return *wedge;
    if (!isBelow && !isAbove)
      if (const auto hanging = hangingIn(twin, next)) return *hanging;
    return PortalCrossing{portal.next, twin};
  }

  std::optional<TruthHit> lowerStep(const Portal& portal, const Sector& next) const {
    return step(part_.inStack ? SurfaceKind::StackLowerStep : SurfaceKind::LowerStep, portal.lower,
                next.floor.z);
  }

  std::optional<TruthHit> upperStep(const Portal& portal, const Sector& next) const {
    return step(part_.inStack ? SurfaceKind::StackUpperStep : SurfaceKind::UpperStep, portal.upper,
                next.ceiling.z);
  }

  /// Where a step or sidewall shows it has a texture: a look at one without is the rounding of
  /// slopes. Light may meet it beyond a sky, where nobody looks.
  std::optional<TruthHit> step(SurfaceKind kind, const std::optional<TextureMapping>& texture,
                               double zRef) const {
    if (!texture && !isLight()) return std::nullopt;
    return hit(kind, texture, zRef);
  }

  std::optional<TruthHit> skyStep(bool isUpper) const {
    if (isLight()) return std::nullopt;
    const Flat& sky = isUpper ? sector_.ceiling : sector_.floor;
    TruthHit found =
        hit(isUpper ? SurfaceKind::SkyUpperStep : SurfaceKind::SkyLowerStep, sky.texture, sky.z);
    found.imageMetres = skyImageMetres(ray_.direction, *sky.texture, !isUpper);
    return found;
  }

  /// The next sector's wedge, where it stands in the opening by more than rounding.
  std::optional<TruthHit> sidewall(const Sector& next, const Segment& twin) const {
    const Vec2 p = point_.xy();
    if (next.floorSlope && point_.z < next.authoredBottom(p) - kHeightNoise)
      return sidewall(SurfaceKind::FloorSidewall, *next.floorSlope, next.floor.z, twin);
    if (next.ceilingSlope && point_.z > next.authoredTop(p) + kHeightNoise)
      return sidewall(SurfaceKind::CeilingSidewall, *next.ceilingSlope, next.ceiling.z, twin);
    return std::nullopt;
  }

  std::optional<TruthHit> sidewall(SurfaceKind kind, const Slope& slope, double zFlat,
                                   const Segment& twin) const {
    std::optional<TruthHit> found =
        step(kind, slope.sidewall, slope.isRelative ? slope.zAt(point_.xy()) : zFlat);
    // It belongs to the wedge: s starts at the left end of the wedge's own wall.
    if (found) found->imageMetres.x += twin.sAfter - segment_.sBefore;
    return found;
  }

  /// What hangs in the opening. That on the other side stops light, too, and is not lit by it.
  std::optional<TruthHit> hangingIn(SegmentId twin, const Sector& next) const {
    if (const auto seen = maskedMiddle(id_, part_, next.ceiling.z)) return seen;
    if (ray_.kind == RayKind::Look) return std::nullopt;
    const Segment& far = level_[twin];
    const WallPart part = partAt(far, level_[far.sector], point_.z);
    const Portal* back = std::get_if<Portal>(&part.kind);
    if (!back || back->next != segment_.sector) return std::nullopt;
    return maskedMiddle(twin, part, sector_.ceiling.z);
  }

  /// The masked texture in the opening of a part of `side`, behind which is a ceiling; none at a
  /// hole.
  std::optional<TruthHit> maskedMiddle(SegmentId side, const WallPart& part, double zBehind) const {
    const auto& texture = std::get<Portal>(part.kind).maskedMiddle;
    if (!texture) return std::nullopt;
    const TruthHit found = maskedMiddleAt(side, part, *texture, zBehind);
    const double down = found.imageMetres.y;
    if (down < 0 || down > texture->repeat.y || isHole(found)) return std::nullopt;
    return found;
  }

  TruthHit maskedMiddleAt(SegmentId side, const WallPart& part, const TextureMapping& texture,
                          double zBehind) const {
    return hitOn(side, SurfaceKind::MaskedMiddle, part.index, texture,
                 std::min(part.zTop, zBehind));
  }

  bool isHole(const TruthHit& found) const {
    const TextureMapping& mapping = *found.texture;
    if (mapping.texture.index() >= level_.holes.size()) return false;
    const TexelHoles& holes = level_.holes[mapping.texture.index()];
    const auto texel = [](double metres, double repeat, int size, double offset) {
      return wrapped(size * metres / repeat - offset, size);
    };
    if (holes.bits().empty()) return false;
    const int x =
        texel(found.imageMetres.x, mapping.repeat.x, holes.width(), mapping.offsetTexels.x);
    const int y =
        texel(found.imageMetres.y, mapping.repeat.y, holes.height(), mapping.offsetTexels.y);
    return holes.isHole(x, y);
  }

  TruthHit hit(SurfaceKind kind, const std::optional<TextureMapping>& texture, double zRef) const {
    return hitOn(id_, kind, part_.index, texture, zRef);
  }

  TruthHit hitOn(SegmentId id, SurfaceKind kind, std::uint32_t subWall,
                 const std::optional<TextureMapping>& texture, double zRef) const {
    const Segment& segment = level_[id];
    const Vec2 along = segment.p1 - segment.p0;
    const double wallLength = length(along);
    const Vec2 normal = (1 / wallLength) * turned90(along);
    TruthHit found;
    static_cast<SurfacePoint&>(found) = {kind, segment.sector, id, point_, {normal.x, normal.y, 0}};
    found.t = t_;
    found.subWall = subWall;
    found.texture = texture;
    if (texture) {
      const double s = dot(point_.xy() - segment.p0, along) / wallLength;
      found.imageMetres = {texture->along + segment.sBefore + s,
                           texture->zRef.value_or(zRef) - point_.z};
    }
    return found;
  }

  const Level& level_;
  const Ray& ray_;
  SegmentId id_;
  const Segment& segment_;
  const Sector& sector_;
  double t_;
  Vec3 point_;
  WallPart part_;
};

}  // namespace

std::variant<TruthHit, PortalCrossing> meetWall(const Level& level, const Ray& ray,
                                                SegmentId segment, double t) {
  return Meeting(level, ray, segment, t).result();
}

Vec2 skyImageMetres(Vec3 direction, const TextureMapping& sky, bool isBelow) {
  const double elevation = direction.z / length(direction.xy());
  const double turns = compassDegrees(direction.xy()) / 360;
  return {turns, sky.repeat.y - (isBelow ? -elevation : elevation)};
}

}  // namespace hearth
