#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/lanes.h"

namespace hearth {

/// The faces of meshes that are the nearest in the pixels of a strip: a depth buffer of 1 / depth,
/// and of faces.
class NearestFaces {
 public:
  /// A face, by a number of its own; 0 is none.
  using Number = std::uint64_t;

  struct alignas(64) Row {
    LaneDoubles nearness{};  ///< 1 / depth, per metre
    std::array<Number, Strip::kColumns> faces{};
  };

  void resize(int rows) { rows_.resize(static_cast<std::size_t>(rows)); }
  void clear() { begin_ = end_ = 0; }

  // Rows in which there may be faces:
  int begin() const { return begin_; }
  int end() const { return end_; }

  Row& operator[](int row) { return rows_[static_cast<std::size_t>(row)]; }
  const Row& operator[](int row) const { return rows_[static_cast<std::size_t>(row)]; }

  /// Makes rows [begin, end), at least one, some of those.
  void reach(int begin, int end) {
    if (begin_ >= end_) begin_ = end_ = begin;
    empty(begin, begin_);
    empty(end_, end);
    begin_ = std::min(begin_, begin);
    end_ = std::max(end_, end);
  }

 private:
  void empty(int begin, int end) {
    for (int row = begin; row < end; ++row) (*this)[row] = {};
  }

  std::vector<Row> rows_;
  int begin_ = 0;
  int end_ = 0;
};

}  // namespace hearth
