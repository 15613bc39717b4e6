#include "light/grid/grids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "light/grid/open_stretches.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr Vec3 kUp = {0, 0, 1};

Vec3 flatVector(Vec2 v) { return {v.x, v.y, 0}; }

/// Gathers the walls that continue `seed`, whose line is the run's.
class WallRun {
 public:
  WallRun(const Level& level, const VertexFan& fan, std::vector<bool>& taken, SegmentId seed)
      : level_(level), fan_(fan), taken_(taken), seed_(level[seed]) {
    taken_[seed.index()] = true;
    members_ = {seed};
    for (std::size_t i = 0; i < members_.size(); ++i) {
      extend(members_[i], level_[members_[i]].p0, false);
      extend(members_[i], level_[members_[i]].p1, true);
      for (const SegmentId beyond : fan.acrossFlatPortals(members_[i])) take(beyond);
    }
  }

  const std::vector<SegmentId>& members() const { return members_; }

  TexelGrid grid(double texel) const {
    Vec2 first = seed_.p0;
    for (const SegmentId id : members_)
      for (const Vec2 p : {level_[id].p0, level_[id].p1})
        if (lessXY(p, first)) first = p;
    const Vec2 direction = (1 / seed_.length) * (seed_.p1 - seed_.p0);
    return {{first.x, first.y, 0}, flatVector(direction), kUp, texel};
  }

 private:
  void extend(SegmentId from, Vec2 vertex, bool forwards) {
    for (const VertexFan::Spoke& spoke : forwards ? fan_.atEndOf(from) : fan_.atStartOf(from)) {
      if (spoke.startsHere != forwards || taken_[spoke.segment.index()]) continue;
      if (continues(level_[from], level_[spoke.segment], vertex)) take(spoke.segment);
    }
  }

  void take(SegmentId id) {
    if (taken_[id.index()]) return;
    taken_[id.index()] = true;
    members_.push_back(id);
  }

  bool continues(const Segment& from, const Segment& to, Vec2 vertex) const {
    const Vec2 direction = seed_.p1 - seed_.p0;
    if (dot(direction, to.p1 - to.p0) <= 0) return false;
    const double tolerance = noiseOf(std::min(from.length, to.length));
    for (const Vec2 p : {to.p0, to.p1})
      if (std::abs(cross(direction, p - seed_.p0)) > tolerance * seed_.length) return false;
    constexpr double kAny = std::numeric_limits<double>::max();
    return !fan_.waysRound(from, vertex, to.sector, {-kAny, kAny}).empty() ||
           !fan_.waysRound(to, vertex, from.sector, {-kAny, kAny}).empty();
  }

  const Level& level_;
  const VertexFan& fan_;
  std::vector<bool>& taken_;
  const Segment& seed_;
  std::vector<SegmentId> members_;
};

/// Longest first, so that a run's line is that of its longest wall.
std::vector<SegmentId> byFallingLength(const Level& level) {
  std::vector<SegmentId> order(level.segments.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = SegmentId(i);
  std::stable_sort(order.begin(), order.end(), [&](SegmentId a, SegmentId b) {
    if (level[a].length != level[b].length) return level[a].length > level[b].length;
    return lessXY(level[a].p0, level[b].p0);
  });
  return order;
}

const std::optional<Slope>& slopeOf(const Sector& sector, bool floor) {
  return floor ? sector.floorSlope : sector.ceilingSlope;
}

Vec2 firstBorderVertex(const Level& level, const Sector& sector) {
  const Loop& border = sector.loops.front();
  Vec2 first = level[border.first].p0;
  for (std::size_t i = 0; i < border.count; ++i) {
    const Vec2 p = level.segments[border.first.index() + i].p0;
    if (lessXY(p, first)) first = p;
  }
  return first;
}

TexelGrid slopeGrid(const Sector& sector, const Slope& slope, Vec2 anchor, double texel) {
  const Vec3 origin = {anchor.x, anchor.y, slope.zAt(anchor)};
  const double steepness = length(slope.gradient);
  const double rise = steepness * length(sector.box.max - sector.box.min);
  if (rise < kHeightNoise) return {origin, {1, 0, 0}, {0, 1, 0}, texel};
  const Vec2 uphill = (1 / steepness) * slope.gradient;
  const double run = 1 / std::sqrt(1 + steepness * steepness);
  return {origin, flatVector(turned90(uphill)),
          Vec3{uphill.x * run, uphill.y * run, steepness * run}, texel};
}

/// An edge at which a sector opens to another, or the other to it, with nothing between their
/// floors (ceilings).
struct Joint {
  SectorId to;
  SegmentId along;
};

/// By SectorId. A one-way portal joins its two sectors like any other.
std::vector<std::vector<Joint>> jointsOf(const Scene& scene, bool floor) {
  std::vector<std::vector<Joint>> joints(scene.level().sectors.size());
  for (const Segment& segment : scene.level().segments) {
    for (const OpenStretch& open : openAtFoot(scene, segment, floor)) {
      joints[segment.sector.index()].push_back({open.next, segment.id});
      joints[open.next.index()].push_back({segment.sector, segment.id});
    }
  }
  return joints;
}

/// The sectors whose slopes continue that of `seed`.
std::vector<SectorId> slopeRun(const Scene& scene, const std::vector<std::vector<Joint>>& joints,
                               SectorId seed, bool floor, std::vector<bool>& taken) {
  std::vector<SectorId> members = {seed};
  taken[seed.index()] = true;
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (const Joint& joint : joints[members[i].index()]) {
      if (taken[joint.to.index()] || !slopeOf(scene[joint.to], floor)) continue;
      if (!continueInOnePlane(scene, scene[seed], scene[joint.to], floor, scene[joint.along]))
        continue;
      taken[joint.to.index()] = true;
      members.push_back(joint.to);
    }
  }
  return members;
}

}  // namespace

std::vector<TexelGrid> wallGrids(const Level& level, const VertexFan& fan, double texel) {
  std::vector<TexelGrid> grids(level.segments.size());
  std::vector<bool> taken(level.segments.size(), false);
  for (const SegmentId seed : byFallingLength(level)) {
    if (taken[seed.index()]) continue;
    const WallRun run(level, fan, taken, seed);
    const TexelGrid grid = run.grid(texel);
    for (const SegmentId member : run.members()) grids[member.index()] = grid;
  }
  return grids;
}

TexelGrid flatGrid(double z, double texel) { return {{0, 0, z}, {1, 0, 0}, {0, 1, 0}, texel}; }

std::vector<TexelGrid> slopeGrids(const Scene& scene, bool floor, double texel) {
  const Level& level = scene.level();
  std::vector<SectorId> order;
  for (std::size_t i = 0; i < level.sectors.size(); ++i)
    if (slopeOf(level.sectors[i], floor)) order.push_back(SectorId(i));
  const auto anchorOf = [&](SectorId id) { return firstBorderVertex(level, level[id]); };
  std::stable_sort(order.begin(), order.end(),
                   [&](SectorId a, SectorId b) { return lessXY(anchorOf(a), anchorOf(b)); });

  std::vector<TexelGrid> grids(level.sectors.size());
  if (order.empty()) return grids;
  std::vector<bool> taken(level.sectors.size(), false);
  const std::vector<std::vector<Joint>> joints = jointsOf(scene, floor);
  for (const SectorId seed : order) {
    if (taken[seed.index()]) continue;
    // In this order the first sector of a run holds the run's first vertex.
    const TexelGrid grid =
        slopeGrid(level[seed], *slopeOf(level[seed], floor), anchorOf(seed), texel);
    for (const SectorId member : slopeRun(scene, joints, seed, floor, taken))
      grids[member.index()] = grid;
  }
  return grids;
}

bool continueInOnePlane(const Scene& scene, const Sector& a, const Sector& b, bool floor,
                        const Segment& along) {
  const double tolerance = noiseOf(along.length);
  const auto isLevelAt = [&](Vec2 p) {
    const double step = floor ? scene.airBottom(b, p) - scene.airBottom(a, p)
                              : scene.airTop(b, p) - scene.airTop(a, p);
    return std::abs(step) <= tolerance;
  };
  const auto gradientOf = [&](const Sector& sector) {
    const std::optional<Slope>& slope = slopeOf(sector, floor);
    return slope ? slope->gradient : Vec2{0, 0};
  };
  return isLevelAt(along.p0) && isLevelAt(along.p1) &&
         length(gradientOf(a) - gradientOf(b)) <= kAuthorNoiseOfEdge;
}

}  // namespace hearth
