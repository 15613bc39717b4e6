#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hearth {

/// What is found of the sectors in view, or of the cells of wall grids, once for each in a frame.
/// Takes memory for these alone, and keeps it from frame to frame.
template <typename Key, typename T>
class ById {
 public:
  /// Forgets all.
  void clear() {
    items_.clear();
    found_.clear();
    std::ranges::fill(table_, kFree);
  }

  /// All that has been added.
  std::size_t size() const { return items_.size(); }

  bool has(Key id) const { return indexOf(id) != kFree; }

  /// Begins another one, to which `add` adds.
  void begin(Key id) {
    const auto end = static_cast<std::uint32_t>(items_.size());
    found_.push_back({id, end, end});
    if (2 * found_.size() <= table_.size()) {
      enter(static_cast<std::uint32_t>(found_.size() - 1));
      return;
    }
    table_.assign(2 * table_.size(), kFree);
    for (std::uint32_t i = 0; i < found_.size(); ++i) enter(i);
  }
  void add(const T& item) {
    items_.push_back(item);
    ++found_.back().end;
  }

  /// How many were begun before one that was begun.
  std::size_t placeOf(Key id) const { return indexOf(id); }

  /// What has been added to one that was begun. Valid until more is added.
  std::span<const T> of(Key id) const {
    const Found& found = found_[indexOf(id)];
    return std::span(items_).subspan(found.begin, found.end - found.begin);
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t{0};

  struct Found {
    Key id;
    std::uint32_t begin;  ///< its items are [begin, end)
    std::uint32_t end;
  };

  /// Where the search for one begins: Fibonacci hashing (Knuth, "The Art of Computer
  /// Programming", 6.4).
  std::size_t firstPlace(Key id) const {
    return std::uint64_t{id.value} * 0x9E3779B97F4A7C15U >> (64 - std::countr_zero(table_.size()));
  }

  /// An index into found_, or kFree.
  std::uint32_t indexOf(Key id) const {
    std::size_t place = firstPlace(id);
    while (table_[place] != kFree && found_[table_[place]].id != id)
      place = (place + 1) & (table_.size() - 1);
    return table_[place];
  }

  void enter(std::uint32_t index) {
    std::size_t place = firstPlace(found_[index].id);
    while (table_[place] != kFree) place = (place + 1) & (table_.size() - 1);
    table_[place] = index;
  }

  std::vector<T> items_;
  std::vector<Found> found_;
  /// A hash table of indices into found_, a power of two in size and at most half full.
  std::vector<std::uint32_t> table_ = std::vector<std::uint32_t>(64, kFree);
};

}  // namespace hearth
