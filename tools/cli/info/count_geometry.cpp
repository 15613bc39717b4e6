#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "cli/info/format_features.h"
#include "level/locate.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// An authored wall, of which linking may have made several segments.
using WallKey = std::tuple<SectorId, std::uint32_t, std::uint32_t>;

WallKey keyOf(const Segment& segment) { return {segment.sector, segment.loop, segment.wallIndex}; }

/// Whether an opening of the segment has none that leads back.
bool isOneWay(const Scene& scene, const Segment& segment) {
  return std::ranges::any_of(scene.piecesOf(segment), [&](const WallPiece& piece) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    return opening &&
           std::ranges::none_of(scene.piecesOf(scene[opening->twin]), [&](const WallPiece& back) {
             const Opening* leading = std::get_if<Opening>(&back.content);
             return leading && leading->next == segment.sector;
           });
  });
}

void countWalls(const Scene& scene, FeatureCounts& counts) {
  std::set<WallKey> oneWay;
  std::set<WallKey> split;
  for (const Segment& segment : scene.level().segments) {
    if (isOneWay(scene, segment)) oneWay.insert(keyOf(segment));
    if (segment.sBefore > 0 && !std::holds_alternative<Solid>(segment.wall))
      split.insert(keyOf(segment));
  }
  counts.add(FormatFeature::OneWayPortal, std::ssize(oneWay));
  counts.add(FormatFeature::PortalSplitDifferently, std::ssize(split));
}

void countSurfaces(const Scene& scene, FeatureCounts& counts) {
  for (const SurfaceId surface : scene.shownSurfaces()) switch (scene[surface].kind) {
      case SurfaceKind::LowerStep:
      case SurfaceKind::StackLowerStep:
        counts.add(FormatFeature::StepUp);
        break;
      case SurfaceKind::UpperStep:
      case SurfaceKind::StackUpperStep:
        counts.add(FormatFeature::StepDown);
        break;
      case SurfaceKind::SkyUpperStep:
        counts.add(FormatFeature::SkyCeilingStep);
        break;
      case SurfaceKind::SkyLowerStep:
        counts.add(FormatFeature::SkyFloorStep);
        break;
      default:
        break;
    }
}

bool touch(const Segment& a, const Segment& b) {
  const auto near = [](Vec2 p, const Segment& s) {
    return length(nearestOnSegment(s.p0, s.p1, p) - p) <= kAuthorNoise;
  };
  return near(a.p0, b) || near(b.p0, a);
}

bool touchesBorder(const Level& level, const Sector& sector, std::uint32_t loop) {
  const auto segments = level.segmentsOf(sector);
  return std::ranges::any_of(segments, [&](const Segment& inner) {
    return inner.loop == loop && std::ranges::any_of(segments, [&](const Segment& border) {
             return border.loop == 0 && touch(inner, border);
           });
  });
}

void countSector(const Level& level, const Sector& sector, FeatureCounts& counts) {
  const auto addIf = [&](bool holds, FormatFeature feature) {
    if (holds) counts.add(feature);
  };
  counts.add(FormatFeature::InnerLoop, std::ssize(sector.loops) - 1);
  for (std::uint32_t loop = 1; loop < sector.loops.size(); ++loop)
    addIf(touchesBorder(level, sector, loop), FormatFeature::InnerLoopAtBorder);
  addIf(sector.floor.z == sector.ceiling.z, FormatFeature::ClosedDoor);
  addIf(sector.ceiling.isSky, FormatFeature::SkyCeiling);
  addIf(sector.floor.isSky, FormatFeature::SkyFloor);
  addIf(sector.floorSlope.has_value(), FormatFeature::SlopeFloor);
  addIf(sector.ceilingSlope.has_value(), FormatFeature::SlopeCeiling);
}

/// Whether both sectors have air at `p`, more than an author's noise of it.
bool bothHaveAirAt(const Level& level, const Sector& a, const Sector& b, Vec2 p) {
  const double bottom = std::max(a.authoredBottom(p), b.authoredBottom(p));
  const double top = std::min(a.authoredTop(p), b.authoredTop(p));
  return top - bottom > kAuthorNoise && contains(level, a, p) && contains(level, b, p);
}

/// Whether the air of two sectors overlaps, judged just inside the middles of both's walls, and
/// where walls cross.
bool overlap(const Level& level, const Sector& a, const Sector& b) {
  const auto midwayIn = [&](const Sector& sector) {
    return std::ranges::any_of(level.segmentsOf(sector), [&](const Segment& segment) {
      const Vec2 along = segment.p1 - segment.p0;
      const Vec2 inward =
          (2 * kAuthorNoise / std::max(length(along), kAuthorNoise)) * turned90(along);
      return bothHaveAirAt(level, a, b, lerp(segment.p0, segment.p1, 0.5) + inward);
    });
  };
  if (midwayIn(a) || midwayIn(b)) return true;
  for (const Segment& s : level.segmentsOf(a))
    for (const Segment& t : level.segmentsOf(b)) {
      const bool cross = orientation(s.p0, s.p1, t.p0) * orientation(s.p0, s.p1, t.p1) < 0 &&
                         orientation(t.p0, t.p1, s.p0) * orientation(t.p0, t.p1, s.p1) < 0;
      if (!cross) continue;
      const double side0 = hearth::cross(s.p1 - s.p0, t.p0 - s.p0);
      const double side1 = hearth::cross(s.p1 - s.p0, t.p1 - s.p0);
      const Vec2 p = lerp(t.p0, t.p1, side0 / (side0 - side1));
      const double bottom = std::max(a.authoredBottom(p), b.authoredBottom(p));
      if (std::min(a.authoredTop(p), b.authoredTop(p)) - bottom > kAuthorNoise) return true;
    }
  return false;
}

/// Pairs of sectors, found by a sweep along x.
void countOverlaps(const Level& level, FeatureCounts& counts) {
  std::vector<std::size_t> order(level.sectors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t i) { return level.sectors[i].box.min.x; };
  std::ranges::sort(order, [&](auto a, auto b) { return left(a) < left(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Sector& a = level.sectors[order[i]];
    for (std::size_t k = i + 1; k < order.size() && left(order[k]) < a.box.max.x; ++k) {
      const Sector& b = level.sectors[order[k]];
      const bool apart = a.box.max.y <= b.box.min.y || b.box.max.y <= a.box.min.y ||
                         a.ceiling.z <= b.floor.z || b.ceiling.z <= a.floor.z;
      if (!apart && overlap(level, a, b)) counts.add(FormatFeature::OverlappingSectors);
    }
  }
}

void countSprite(const Sprite& sprite, FeatureCounts& counts) {
  constexpr std::array kByFacing{FormatFeature::CameraSprite, FormatFeature::FixedSprite,
                                 FormatFeature::FlatSprite};
  counts.add(kByFacing[static_cast<std::size_t>(sprite.facing)]);
  const auto addIf = [&](bool holds, FormatFeature feature) {
    if (holds) counts.add(feature);
  };
  addIf(sprite.body.has_value(), FormatFeature::SolidSprite);
  addIf(sprite.isBright, FormatFeature::BrightSprite);
  const bool hasSides = std::ranges::any_of(
      sprite.frames, [](const std::vector<SpriteView>& views) { return views.size() > 1; });
  addIf(hasSides, FormatFeature::SpriteOfManySides);
  addIf(sprite.frames.size() > 1, FormatFeature::AnimatedSprite);
}

}  // namespace

void countGeometry(const Scene& scene, FeatureCounts& counts) {
  const Level& level = scene.level();
  countWalls(scene, counts);
  countSurfaces(scene, counts);
  for (const Sector& sector : level.sectors) countSector(level, sector, counts);
  countOverlaps(level, counts);
  for (const FlatPortal& flatPortal : level.flatPortals)
    if (flatPortal.upper.size() > 1 || flatPortal.lower.size() > 1)
      counts.add(FormatFeature::FlatPortalOfManySectors);
  for (const Sprite& sprite : level.sprites) countSprite(sprite, counts);
  for (const Mesh& mesh : level.meshes) {
    counts.add(FormatFeature::Mesh);
    if (mesh.isTwoSided) counts.add(FormatFeature::TwoSidedMesh);
  }
  for (const LightSource& light : level.lights) {
    if (!light.hasPlace()) continue;
    const Sector& sector = level[light.sector];
    if (light.position.z > sector.ceiling.z) counts.add(FormatFeature::LightAboveSky);
    if (light.position.z < sector.floor.z) counts.add(FormatFeature::LightBelowSky);
  }
}

}  // namespace hearth
