#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "level/ids.h"

namespace hearth {

/// A set of ids of one kind.
template <typename Id>
class IdSet {
 public:
  void add(Id id) { ids_.insert(id.value); }
  void add(const IdSet& others) { ids_.insert(others.ids_.begin(), others.ids_.end()); }

  /// In rising order.
  std::vector<Id> sorted() const {
    std::vector<Id> ids;
    for (const std::uint32_t value : ids_) ids.push_back(Id(value));
    std::ranges::sort(ids);
    return ids;
  }

 private:
  std::unordered_set<std::uint32_t> ids_;
};

using SectorSet = IdSet<SectorId>;
using SurfaceSet = IdSet<SurfaceId>;

}  // namespace hearth
