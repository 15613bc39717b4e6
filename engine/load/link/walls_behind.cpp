#include "load/link/walls_behind.h"

#include <algorithm>
#include <span>

#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Metres. Vertices that are farther off were hardly meant for the point; half of a short wall.
constexpr double kNear = 0.25;

bool isOn(Vec2 p, Vec2 from, Vec2 to, double noise) {
  return length(nearestOnSegment(from, to, p) - p) <= noise;
}

/// The vertex of a sector that is nearest to a point on none of its walls.
std::optional<MissedPoint> nearestVertex(const Outlines& outlines, const OutlineSector& sector,
                                         Vec2 p, double noise) {
  std::optional<MissedPoint> nearest;
  for (const Edge& edge : std::span(outlines.edges).subspan(sector.firstEdge, sector.edgeCount)) {
    if (isOn(p, outlines.from(edge), outlines.to(edge), noise)) return std::nullopt;
    const Vec2 vertex = outlines.from(edge);
    const double distance = length(vertex - p);
    if (!nearest || distance < nearest->distance) nearest = {p, vertex, distance};
  }
  return nearest;
}

}  // namespace

std::vector<SectorId> WallsBehind::sectors(SectorId sector, Vec2 from, Vec2 to) {
  const Outlines& outlines = linking_.outlines;
  if (!edges_) {
    std::vector<Box> boxes;
    for (const Edge& edge : outlines.edges) boxes.push_back(outlines.box(edge));
    edges_.emplace(std::move(boxes));
  }
  std::vector<SectorId> found;
  edges_->query(grown(boxOf(from, to), kAuthorNoise), [&](std::uint32_t i) {
    const SectorId other(outlines.edges[i].sector);
    if (other != sector && runsBackAlong(outlines.edges[i], from, to) &&
        overlapInHeight(sector, other))
      found.push_back(other);
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// The shorter of both lies on the longer one.
bool WallsBehind::runsBackAlong(const Edge& edge, Vec2 from, Vec2 to) const {
  const Vec2 a = linking_.outlines.from(edge);
  const Vec2 b = linking_.outlines.to(edge);
  if (dot(b - a, to - from) >= 0) return false;
  const double noise = noiseOf(std::min(length(b - a), length(to - from)));
  return (isOn(a, from, to, noise) && isOn(b, from, to, noise)) ||
         (isOn(from, a, b, noise) && isOn(to, a, b, noise));
}

bool WallsBehind::overlapInHeight(SectorId a, SectorId b) const {
  const Sector& one = linking_.level[a];
  const Sector& other = linking_.level[b];
  return one.floor.z < other.ceiling.z && other.floor.z < one.ceiling.z;
}

std::optional<MissedPoint> missedPoint(const Outlines& outlines, SectorId sector, Vec2 from,
                                       Vec2 to) {
  const double wall = length(to - from);
  for (const Vec2 end : {from, to}) {
    const std::optional<MissedPoint> missed =
        nearestVertex(outlines, outlines.sectors[sector.index()], end, noiseOf(wall));
    if (missed && missed->distance <= std::min(kNear, wall / 2)) return missed;
  }
  return std::nullopt;
}

}  // namespace hearth
