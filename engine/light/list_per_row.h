#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace hearth {

/// A list of values for each of some rows, which are counted from 0.
template <typename T>
class ListPerRow {
 public:
  ListPerRow() = default;
  /// From values with their rows, which stay in this order within a row.
  ListPerRow(int rows, std::span<const std::pair<int, T>> values)
      : values_(values.size()), ends_(static_cast<std::size_t>(rows)) {
    for (const auto& [row, value] : values) ++ends_[static_cast<std::size_t>(row)];
    std::size_t before = 0;
    for (std::size_t& end : ends_) before += std::exchange(end, before);
    for (const auto& [row, value] : values) values_[ends_[static_cast<std::size_t>(row)]++] = value;
  }

  std::span<T> row(int index) { return std::span(values_).subspan(begin(index), size(index)); }
  std::span<const T> row(int index) const {
    return std::span(values_).subspan(begin(index), size(index));
  }

  /// Adds a value to the last row.
  void add(T value) {
    values_.push_back(value);
    ++ends_.back();
  }
  /// Begins another row.
  void addRow() { ends_.push_back(values_.size()); }

 private:
  std::size_t begin(int index) const {
    return index == 0 ? 0 : ends_[static_cast<std::size_t>(index) - 1];
  }
  std::size_t size(int index) const {
    return ends_[static_cast<std::size_t>(index)] - begin(index);
  }

  std::vector<T> values_;
  std::vector<std::size_t> ends_;  ///< of each row, in `values_`
};

}  // namespace hearth
