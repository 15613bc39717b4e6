#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "level/level.h"
#include "math/box_tree.h"

namespace hearth {

/// Finds the sprites that may be in a sector without a look at those of all others, whichever way
/// they turn and at whatever heights flats stand.
class SpriteIndex {
 public:
  /// Of no sprites.
  SpriteIndex() : tree_({}) {}
  explicit SpriteIndex(const Level& level);

  bool isEmpty() const { return atHome_.empty(); }

  /// Indices of the sprites whose position is in the sector, rising. Not of an empty index.
  std::span<const std::uint32_t> atHomeIn(SectorId sector) const {
    const std::size_t i = sector.index();
    return std::span(atHome_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }

  /// Calls `visit(index)` for sprites near the sector that may reach out of the one that they are
  /// at home in, in no particular order.
  template <typename Visit>
  void visitRoaming(const Sector& sector, Visit&& visit) const {
    tree_.query(sector.box, [&](std::uint32_t i) { visit(roaming_[i]); });
  }

 private:
  std::vector<std::uint32_t> atHome_;   ///< by sector
  std::vector<std::uint32_t> begin_;    ///< by SectorId, and the end
  std::vector<std::uint32_t> roaming_;  ///< by box of the tree
  BoxTree tree_;
};

}  // namespace hearth
