#include "light/vertex_fan.h"

#include <algorithm>
#include <variant>

namespace hearth {

VertexFan::VertexFan(const Level& level) : level_(level) {
  spokes_.reserve(2 * level.segments.size());
  for (std::size_t i = 0; i < level.segments.size(); ++i) {
    spokes_.push_back({level.segments[i].p0, SegmentId(i), true});
    spokes_.push_back({level.segments[i].p1, SegmentId(i), false});
  }
  std::stable_sort(spokes_.begin(), spokes_.end(),
                   [](const Spoke& a, const Spoke& b) { return lessXY(a.vertex, b.vertex); });
}

std::span<const VertexFan::Spoke> VertexFan::at(Vec2 vertex) const {
  const auto first =
      std::lower_bound(spokes_.begin(), spokes_.end(), vertex,
                       [](const Spoke& spoke, Vec2 v) { return lessXY(spoke.vertex, v); });
  auto last = first;
  while (last != spokes_.end() && last->vertex == vertex) ++last;
  return {first, last};
}

std::vector<SegmentId> VertexFan::acrossFlatPortals(SegmentId id) const {
  const Segment& segment = level_[id];
  const Sector& sector = level_[segment.sector];
  std::vector<SegmentId> found;
  if (!sector.floor.interface && !sector.ceiling.interface) return found;
  for (const Spoke& spoke : at(segment.p0)) {
    const Segment& other = level_[spoke.segment];
    if (!spoke.startsHere || other.p1 != segment.p1) continue;
    const Sector& beyond = level_[other.sector];
    const bool below = sector.floor.interface && beyond.ceiling.interface == sector.floor.interface;
    const bool above =
        sector.ceiling.interface && beyond.floor.interface == sector.ceiling.interface;
    if (below || above) found.push_back(spoke.segment);
  }
  return found;
}

bool VertexFan::joined(Vec2 vertex, SectorId a, SectorId b, double zBottom, double zTop) const {
  std::vector<SectorId> reached = {a};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (reached[i] == b) return true;
    for (const Spoke& spoke : at(vertex)) {
      const Segment& segment = level_[spoke.segment];
      if (segment.sector != reached[i]) continue;
      for (const WallPiece& piece : segment.pieces) {
        const Opening* opening = std::get_if<Opening>(&piece.content);
        const bool meets = std::max(piece.zBottom, zBottom) < std::min(piece.zTop, zTop);
        if (opening && meets &&
            std::find(reached.begin(), reached.end(), opening->next) == reached.end())
          reached.push_back(opening->next);
      }
    }
  }
  return false;
}

std::vector<std::pair<double, double>> VertexFan::joinedHeights(Vec2 vertex, SectorId a, SectorId b,
                                                                double zBottom, double zTop) const {
  // Between two successive ends of pieces, all heights are alike.
  std::vector<double> ends = {zBottom, zTop};
  for (const Spoke& spoke : at(vertex))
    for (const WallPiece& piece : level_[spoke.segment].pieces)
      for (const double z : {piece.zBottom, piece.zTop})
        if (zBottom < z && z < zTop) ends.push_back(z);
  std::ranges::sort(ends);
  std::vector<std::pair<double, double>> found;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (!joined(vertex, a, b, ends[i - 1], ends[i])) continue;
    if (!found.empty() && found.back().second == ends[i - 1])
      found.back().second = ends[i];
    else
      found.emplace_back(ends[i - 1], ends[i]);
  }
  return found;
}

}  // namespace hearth
