#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "level/twins.h"
#include "load/link/link.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

struct Range {
  double zBottom;
  double zTop;
};

/// The heights at which a segment opens to `next`, bottom to top; ranges that meet are
/// one.
std::vector<Range> openRanges(const Scene& scene, const Segment& segment, SectorId next) {
  const double noise = noiseOf(segment.length);
  std::vector<Range> ranges;
  for (const WallPiece& piece : scene.piecesOf(segment)) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    if (!opening || opening->next != next) continue;
    if (!ranges.empty() && piece.zBottom - ranges.back().zTop <= noise)
      ranges.back().zTop = piece.zTop;
    else
      ranges.push_back({piece.zBottom, piece.zTop});
  }
  std::erase_if(ranges, [noise](Range range) { return range.zTop - range.zBottom <= noise; });
  return ranges;
}

bool areAlike(const std::vector<Range>& a, const std::vector<Range>& b, double noise) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [noise](Range x, Range y) {
    return std::abs(x.zBottom - y.zBottom) <= noise && std::abs(x.zTop - y.zTop) <= noise;
  });
}

/// What the segments of one authored wall say about one sector that it leads to.
struct Passage {
  SegmentId segment;  ///< the first one
  bool leadsBack = false;
  bool opensAlike = true;
};

void examine(const Linking& linking, const TwinIndex& twins, SegmentId id, SectorId target,
             Passage& passage) {
  const Segment& segment = linking.level[id];
  const std::optional<SegmentId> twin = twins.find(segment, target);
  if (!twin) return;
  const std::vector<SectorId> back = targetsOf(linking.level[*twin].wall);
  // About a wall that could not be linked nothing is said.
  const bool isUnknown = !linking.walls[linking.edgeOf[twin->index()]].has_value();
  const bool leadsBack = isUnknown || std::binary_search(back.begin(), back.end(), segment.sector);
  passage.leadsBack |= leadsBack;
  if (leadsBack && !isUnknown && id < *twin)
    passage.opensAlike &= areAlike(
        openRanges(linking.scene(), segment, target),
        openRanges(linking.scene(), linking.level[*twin], segment.sector), noiseOf(segment.length));
}

void warnOfOneWay(Linking& linking, const TwinIndex& twins, SegmentId id, SectorId target) {
  const Segment& segment = linking.level[id];
  const SegmentId twin = twins.find(segment, target).value();  // linking has made sure
  const Edge& behind = linking.outlines.edges[linking.edgeOf[twin.index()]];
  const bool isOfGrid = linking.description.sectors[behind.sector].isOfGrid;
  const std::string& from = linking.level[segment.sector].name;
  linking.report.warning(
      linking.describedWall(id).place,
      fmt::format(
          "a one-way portal to sector \"{}\": wall {} of its loop \"{}\", {}, does not lead back",
          linking.level[target].name, behind.wallIndex, linking.describedLoop(behind).name,
          linking.describedLoop(behind).ends(behind.wallIndex)),
      isOfGrid ? fmt::format(
                     "write an entry with \"next\": \"{}\" into the cell behind it if that is to "
                     "lead back",
                     from)
               : fmt::format("give that wall \"next\": \"{}\" if it is to lead back", from),
      "one-way-portal");
}

}  // namespace

void validatePortals(Linking& linking) {
  const TwinIndex twins(linking.level);
  std::map<std::pair<std::uint32_t, SectorId>, Passage> passages;  // by edge and target
  for (std::size_t i = 0; i < linking.level.segments.size(); ++i) {
    const SegmentId id(i);
    for (const SectorId target : targetsOf(linking.level[id].wall)) {
      const auto key = std::pair(linking.edgeOf[i], target);
      examine(linking, twins, id, target, passages.try_emplace(key, Passage{id}).first->second);
    }
  }
  for (const auto& [key, passage] : passages) {
    const std::string& target = linking.level[key.second].name;
    const Place place = linking.describedWall(passage.segment).place;
    if (!passage.leadsBack)
      warnOfOneWay(linking, twins, passage.segment, key.second);
    else if (!passage.opensAlike)
      linking.report.warning(
          place,
          fmt::format("this wall and the one of sector \"{}\" behind it open different heights",
                      target),
          "each side draws its own wall; make them alike if that is not what you want",
          "uneven-portal");
  }
}

}  // namespace hearth
