#include "peers/peers.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hearth {

namespace {

/// A row with all that was measured of it so far.
class RowInWork {
 public:
  RowInWork(const PeerRow& row, PeerInputs& inputs) : result_{&row, {}, {}, {}} {
    auto prepared = row.prepare(inputs);
    if (prepared)
      measure_ = *std::move(prepared);
    else
      result_.missing = prepared.error();
  }

  void measureOnce() {
    if (!result_.missing.empty()) return;
    const auto figures = measure_();
    if (!figures) {
      result_.missing = figures.error();
      return;
    }
    values_.resize(figures->size());
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i].push_back((*figures)[i]);
  }

  PeerResult result() const {
    PeerResult result = result_;
    if (!result.missing.empty()) return result;
    result.figure = rangeOf(values_.front());
    for (const std::vector<double>& part : std::span(values_).subspan(1))
      result.parts.push_back(rangeOf(part));
    return result;
  }

 private:
  PeerResult result_;
  Measure measure_;
  std::vector<std::vector<double>> values_;  ///< of the row's figure, then of each part
};

}  // namespace

double shortfall(const Target& target, double measured) {
  const double above = measured / target.value - 1;
  return std::max(0.0, target.wanted == Wanted::AtMost ? above : -above);
}

Range rangeOf(std::vector<double> values) {
  std::ranges::sort(values);
  return {values[(values.size() - 1) / 2], values.front(), values.back()};
}

std::optional<std::size_t> inTheWay(const PeerResult& result) {
  const PeerRow& row = *result.row;
  if (shortfall(row.target, result.figure.median) == 0 || !row.firstCost) return std::nullopt;
  const auto costs = std::span(result.parts).subspan(*row.firstCost);
  const auto largest = std::ranges::max_element(costs, {}, &Range::median);
  return *row.firstCost + static_cast<std::size_t>(largest - costs.begin());
}

std::vector<PeerResult> measurePeers(std::span<const PeerRow> rows, PeerInputs& inputs, int repeats,
                                     const std::function<void(std::string_view)>& tell) {
  std::vector<RowInWork> inWork;
  for (const PeerRow& row : rows) {
    tell(fmt::format("preparing {}", row.name));
    inWork.emplace_back(row, inputs);
  }
  for (int i = 1; i <= repeats; ++i) {
    tell(fmt::format("measuring, {} of {}", i, repeats));
    for (RowInWork& row : inWork) row.measureOnce();
  }
  std::vector<PeerResult> results;
  for (const RowInWork& row : inWork) results.push_back(row.result());
  return results;
}

}  // namespace hearth
