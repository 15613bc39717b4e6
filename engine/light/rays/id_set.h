#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/ids.h"

namespace hearth {

/// A set of ids of one kind: a bit for each up to the greatest, for slices add to it all the time.
template <typename Id>
class IdSet {
 public:
  void add(Id id) {
    const std::size_t word = id.value / kBits;
    if (word >= words_.size()) words_.resize(word + 1);
    words_[word] |= Word{1} << id.value % kBits;
  }
  void add(const IdSet& others) {
    if (others.words_.size() > words_.size()) words_.resize(others.words_.size());
    for (std::size_t word = 0; word < others.words_.size(); ++word)
      words_[word] |= others.words_[word];
  }

  /// In rising order.
  std::vector<Id> sorted() const {
    std::vector<Id> ids;
    for (std::size_t word = 0; word < words_.size(); ++word)
      for (Word left = words_[word]; left != 0; left &= left - 1)
        ids.push_back(Id(static_cast<std::uint32_t>(word * kBits) +
                         static_cast<std::uint32_t>(std::countr_zero(left))));
    return ids;
  }

 private:
  using Word = std::uint64_t;
  static constexpr std::uint32_t kBits = 64;

  std::vector<Word> words_;
};

using SectorSet = IdSet<SectorId>;
using SurfaceSet = IdSet<SurfaceId>;

}  // namespace hearth
