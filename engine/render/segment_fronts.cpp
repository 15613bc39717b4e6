#include "render/segment_fronts.h"

#include <algorithm>
#include <variant>

namespace hearth {

namespace {

bool hasLevelAir(const Scene& scene, const Segment& segment) {
  const auto isLevel = [&](const WallPiece& piece) {
    const Opening* const opening = std::get_if<Opening>(&piece.content);
    return !opening || !scene.geometryOf(scene[opening->twin]).airRises;
  };
  return !scene.geometryOf(segment).airRises &&
         std::ranges::all_of(scene.piecesOf(segment), isLevel);
}

}  // namespace

void findFronts(const Scene& scene, const Projection& projection, SectorId id, int width,
                ColumnRange columns, SegmentFronts& fronts) {
  fronts.begin(id);
  for (const Segment& segment : scene.segmentsOf(scene[id])) {
    const ColumnRange covered = columnsOf(projection, segment, width);
    if (haveCommon(covered, columns))
      fronts.add(
          {segment.id, hasLevelAir(scene, segment), covered, SegmentMeetings(projection, segment)});
  }
}

}  // namespace hearth
