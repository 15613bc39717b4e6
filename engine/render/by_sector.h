#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/ids.h"

namespace hearth {

/// What is found of the sectors in view, once for each in a frame. Takes memory for these sectors
/// alone, and keeps it from frame to frame.
template <typename T>
class BySector {
 public:
  /// Forgets all sectors.
  void clear() {
    items_.clear();
    sectors_.clear();
    std::ranges::fill(table_, kFree);
  }

  /// All that has been added.
  std::size_t size() const { return items_.size(); }

  bool has(SectorId sector) const { return indexOf(sector) != kFree; }

  /// Begins another sector, to which `add` adds.
  void begin(SectorId sector) {
    const auto end = static_cast<std::uint32_t>(items_.size());
    sectors_.push_back({sector, end, end});
    if (2 * sectors_.size() <= table_.size()) {
      enter(static_cast<std::uint32_t>(sectors_.size() - 1));
      return;
    }
    table_.assign(2 * table_.size(), kFree);
    for (std::uint32_t i = 0; i < sectors_.size(); ++i) enter(i);
  }
  void add(const T& item) {
    items_.push_back(item);
    ++sectors_.back().end;
  }

  /// How many sectors were begun before one that was begun.
  std::size_t placeOf(SectorId sector) const { return indexOf(sector); }

  /// What has been added to a sector that was begun. Valid until more is added.
  std::span<const T> of(SectorId sector) const {
    const Found& found = sectors_[indexOf(sector)];
    return std::span(items_).subspan(found.begin, found.end - found.begin);
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t{0};

  struct Found {
    SectorId sector;
    std::uint32_t begin;  ///< its items are [begin, end)
    std::uint32_t end;
  };

  /// Where the search for a sector begins: Fibonacci hashing (Knuth, "The Art of Computer
  /// Programming", 6.4).
  std::size_t firstPlace(SectorId sector) const {
    return std::uint64_t{sector.value} * 0x9E3779B97F4A7C15U >>
           (64 - std::countr_zero(table_.size()));
  }

  /// An index into sectors_, or kFree.
  std::uint32_t indexOf(SectorId sector) const {
    std::size_t place = firstPlace(sector);
    while (table_[place] != kFree && sectors_[table_[place]].sector != sector)
      place = (place + 1) & (table_.size() - 1);
    return table_[place];
  }

  void enter(std::uint32_t index) {
    std::size_t place = firstPlace(sectors_[index].sector);
    while (table_[place] != kFree) place = (place + 1) & (table_.size() - 1);
    table_[place] = index;
  }

  std::vector<T> items_;
  std::vector<Found> sectors_;
  /// A hash table of indices into sectors_, a power of two in size and at most half full.
  std::vector<std::uint32_t> table_ = std::vector<std::uint32_t>(64, kFree);
};

}  // namespace hearth
