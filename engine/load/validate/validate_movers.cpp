#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>

#include "load/link/link.h"

namespace hearth {

namespace {

/// Whether a step shows depends on the flats of two sectors, so on no more than four movers. Each
/// of their heights changes evenly with its mover's share, so a step that shows anywhere between
/// the ends shows at ends of these movers, too.
class StepValidator {
 public:
  explicit StepValidator(Linking& linking) : linking_(linking) {
    moversOf_.resize(linking.level.sectors.size());
    for (std::size_t i = 0; i < linking.level.movers.size(); ++i)
      for (const SectorId sector : linking.level.movers[i].sectors)
        moversOf_[sector.index()].push_back(i);
  }

  void validate() {
    std::set<std::pair<SectorId, SectorId>> pairs;
    for (const Segment& segment : linking_.level.segments)
      for (const SectorId next : targetsOf(segment.wall))
        pairs.insert(std::minmax(segment.sector, next));
    for (const auto& [a, b] : pairs) validatePair(a, b);
  }

 private:
  void validatePair(SectorId a, SectorId b) {
    std::vector<std::size_t> movers = moversOf_[a.index()];
    movers.insert(movers.end(), moversOf_[b.index()].begin(), moversOf_[b.index()].end());
    std::sort(movers.begin(), movers.end());
    movers.erase(std::unique(movers.begin(), movers.end()), movers.end());
    for (std::size_t ends = 1; ends < std::size_t{1} << movers.size(); ++ends) {
      std::vector<std::size_t> moved;
      for (std::size_t i = 0; i < movers.size(); ++i)
        if ((ends >> i & 1U) != 0) moved.push_back(movers[i]);
      validateBetween(a, b, moved);
    }
    move(a, b, {});
  }

  /// The steps between two sectors while these movers are at `to`.
  void validateBetween(SectorId a, SectorId b, std::span<const std::size_t> moved) {
    std::vector<MissingTexture> missing = move(a, b, moved);
    std::erase_if(missing, [&](const MissingTexture& each) {
      const Segment& segment = linking_.level[each.segment];
      const auto next = targetOf(segment.wall, each.subWall);
      const bool isBetween = next && std::minmax(segment.sector, *next) == std::minmax(a, b);
      return !isBetween || !told_.insert({each.segment, each.subWall, each.kind}).second;
    });
    if (missing.empty()) return;
    Report found;
    reportMissingTextures(linking_, missing, found);
    linking_.report.addErrors(found, wordsFor(linking_.description.movers, moved));
  }

  std::vector<MissingTexture> move(SectorId a, SectorId b, std::span<const std::size_t> moved) {
    const std::array flats{MovedFlats{a, heightsOf(a, moved)}, MovedFlats{b, heightsOf(b, moved)}};
    std::vector<MissingTexture> missing;
    moveFlats(linking_.level, flats, linking_.geometry, &missing);
    return missing;
  }

  SectorGeometry heightsOf(SectorId id, std::span<const std::size_t> moved) const {
    const Sector& sector = linking_.level[id];
    SectorGeometry heights{sector.floor.z, sector.ceiling.z};
    for (const std::size_t index : moversOf_[id.index()])
      if (std::ranges::find(moved, index) != moved.end()) {
        const Mover& mover = linking_.level.movers[index];
        (mover.part == FlatPart::Floor ? heights.zFloor : heights.zCeiling) = mover.to;
      }
    return heights;
  }

  Linking& linking_;
  std::vector<std::vector<std::size_t>> moversOf_;  ///< by sector
  std::set<std::tuple<SegmentId, std::uint32_t, SurfaceKind>> told_;
};

}  // namespace

std::string wordsFor(std::span<const MoverDescription> movers, std::span<const std::size_t> moved) {
  constexpr std::size_t kMostNames = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(moved.size(), kMostNames); ++i)
    names += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", movers[moved[i]].name);
  if (moved.size() > kMostNames) names += fmt::format(" and {} more", moved.size() - kMostNames);
  return fmt::format("with {} {} at \"to\": ", moved.size() == 1 ? "mover" : "movers", names);
}

void validateSteps(Linking& linking) {
  if (!linking.level.movers.empty()) StepValidator(linking).validate();
}

}  // namespace hearth
