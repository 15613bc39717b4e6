#include "render/segment_fronts.h"

#include <algorithm>
#include <bit>
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

/// Where the search for a sector begins in a table of so many places: Fibonacci hashing (Knuth,
/// "The Art of Computer Programming", 6.4).
std::size_t firstPlace(SectorId sector, std::size_t places) {
  return std::uint64_t{sector.value} * 0x9E3779B97F4A7C15U >> (64 - std::countr_zero(places));
}

}  // namespace

void SegmentFronts::clear() {
  fronts_.clear();
  sectors_.clear();
  std::ranges::fill(table_, kFree);
}

void SegmentFronts::find(const Scene& scene, const Projection& projection, SectorId id, int width,
                         ColumnRange columns) {
  const auto begin = static_cast<std::uint32_t>(fronts_.size());
  for (const Segment& segment : scene.segmentsOf(scene[id])) {
    const ColumnRange covered = columnsOf(projection, segment, width);
    if (std::max(covered.begin, columns.begin) < std::min(covered.end, columns.end))
      fronts_.push_back(
          {segment.id, hasLevelAir(scene, segment), covered, SegmentMeetings(projection, segment)});
  }
  add({id, begin, static_cast<std::uint32_t>(fronts_.size())});
}

std::uint32_t SegmentFronts::indexOf(SectorId sector) const {
  std::size_t place = firstPlace(sector, table_.size());
  while (table_[place] != kFree && sectors_[table_[place]].sector != sector)
    place = (place + 1) & (table_.size() - 1);
  return table_[place];
}

void SegmentFronts::add(const Found& found) {
  sectors_.push_back(found);
  if (2 * sectors_.size() <= table_.size()) {
    enter(static_cast<std::uint32_t>(sectors_.size() - 1));
    return;
  }
  table_.assign(2 * table_.size(), kFree);
  for (std::uint32_t i = 0; i < sectors_.size(); ++i) enter(i);
}

void SegmentFronts::enter(std::uint32_t index) {
  std::size_t place = firstPlace(sectors_[index].sector, table_.size());
  while (table_[place] != kFree) place = (place + 1) & (table_.size() - 1);
  table_[place] = index;
}

}  // namespace hearth
