#include "light/grid/vertex_fan.h"

#include <algorithm>
#include <variant>

#include "level/openings.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Whether a segment from `vertex` to `end` leaves the wall's plane to its front by more than an
/// author cannot mean.
bool standsBefore(const Segment& wall, Vec2 vertex, Vec2 end) {
  return cross(wall.p1 - wall.p0, end - vertex) >
         kAuthorNoiseOfEdge * wall.length * length(end - vertex);
}

}  // namespace

VertexFan::VertexFan(const Scene& scene) : scene_(scene) {
  spokes_.reserve(2 * scene.level().segments.size());
  for (const Segment& segment : scene.level().segments) {
    spokes_.push_back({segment.p0, segment.id, true});
    spokes_.push_back({segment.p1, segment.id, false});
  }
  std::stable_sort(spokes_.begin(), spokes_.end(),
                   [](const Spoke& a, const Spoke& b) { return lessXY(a.vertex, b.vertex); });
  fans_.resize(spokes_.size());
  for (std::uint32_t begin = 0; begin < spokes_.size();) {
    std::uint32_t end = begin;
    while (end < spokes_.size() && spokes_[end].vertex == spokes_[begin].vertex) ++end;
    for (std::uint32_t i = begin; i < end; ++i)
      fans_[2 * spokes_[i].segment.index() + (spokes_[i].startsHere ? 0 : 1)] = {begin, end};
    begin = end;
  }
}

std::vector<SegmentId> VertexFan::acrossFlatPortals(SegmentId id) const {
  const Segment& segment = scene_[id];
  const Sector& sector = scene_[segment.sector];
  std::vector<SegmentId> found;
  if (!sector.floor.flatPortal && !sector.ceiling.flatPortal) return found;
  for (const Spoke& spoke : atStartOf(id)) {
    const Segment& other = scene_[spoke.segment];
    if (!spoke.startsHere || other.p1 != segment.p1) continue;
    const Sector& beyond = scene_[other.sector];
    const bool below =
        sector.floor.flatPortal && beyond.ceiling.flatPortal == sector.floor.flatPortal;
    const bool above =
        sector.ceiling.flatPortal && beyond.floor.flatPortal == sector.ceiling.flatPortal;
    if (below || above) found.push_back(spoke.segment);
  }
  return found;
}

std::vector<VertexFan::Heights> VertexFan::waysRound(const Segment& wall, Vec2 vertex, SectorId to,
                                                     Heights within) const {
  if (wall.sector == to) return {within};
  const bool isAfter = wall.p1 == vertex;
  const auto turnsOn = [&](Vec2 from, Vec2 towards) {
    const int turn = orientation(vertex, from, towards);
    return (isAfter ? turn < 0 : turn > 0) && standsBefore(wall, vertex, towards);
  };
  std::vector<Heights> openings;
  std::vector<Air> reached = {{wall.sector, within, isAfter ? wall.p0 : wall.p1}};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Air here = reached[i];
    if (here.sector == to) openings.push_back(here.heights);
    for (const Spoke& spoke : isAfter ? atEndOf(wall.id) : atStartOf(wall.id)) {
      if (scene_[spoke.segment].sector != here.sector) continue;
      if (!turnsOn(here.from, farEnd(spoke))) continue;
      for (const Air& air : beyond(spoke, here.heights))
        if (std::ranges::none_of(reached, [&](const Air& known) { return known.holds(air); }))
          reached.push_back(air);
    }
  }
  return openings;
}

Vec2 VertexFan::farEnd(const Spoke& spoke) const {
  const Segment& segment = scene_[spoke.segment];
  return spoke.startsHere ? segment.p1 : segment.p0;
}

std::vector<VertexFan::Air> VertexFan::beyond(const Spoke& spoke, Heights near) const {
  const Segment& segment = scene_[spoke.segment];
  const double fraction = spoke.startsHere ? 0 : 1;
  std::vector<Air> found;
  for (const WallPiece& piece : scene_.piecesOf(segment)) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    if (!opening) continue;
    const OpeningSpan span = openingSpan(piece, scene_.airAt(segment, fraction),
                                         scene_.airAt(scene_[opening->twin], 1 - fraction));
    const Heights open = {std::max(near.zBottom, span.zBottom), std::min(near.zTop, span.zTop)};
    if (open.zTop - open.zBottom > kHeightNoise)
      found.push_back({opening->next, open, farEnd(spoke)});
  }
  return found;
}

}  // namespace hearth
