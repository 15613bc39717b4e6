#include "load/source.h"

namespace hearth {

const WallDescription& LevelSource::wall(SegmentId segment) const {
  return describedLoop(level, outlines, edge(segment)).wall(edge(segment).wallIndex);
}

Place LevelSource::vertexPlace(const Edge& edge, std::uint32_t vertex) const {
  const OutlineLoop& loop = outlines.sectors[edge.sector].loops[edge.loop];
  return describedLoop(level, outlines, edge).vertexPlaces[vertex - loop.firstVertex];
}

}  // namespace hearth
