#include "render/segment_front.h"

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

std::optional<SegmentFront> frontOf(const Scene& scene, const Projection& projection,
                                    const Segment& segment, int width, ColumnRange columns) {
  const ColumnRange covered = columnsOf(projection, segment, width);
  if (!haveCommon(covered, columns)) return std::nullopt;
  return SegmentFront{segment.id, hasLevelAir(scene, segment), covered,
                      SegmentMeetings(projection, segment)};
}

}  // namespace hearth
