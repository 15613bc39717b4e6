#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

/// How measurements are compared with targets; peer_rows.h has those that are made.
namespace hearth {

class PeerInputs;

enum class Wanted { AtMost, AtLeast };

struct Target {
  Wanted wanted;
  double value;
};

/// By which fraction of the target a figure misses it; 0 where it is met.
double shortfall(const Target& target, double measured);

struct Range {
  double median = 0;
  double min = 0;
  double max = 0;
};

/// Of at least one value.
Range rangeOf(std::vector<double> values);

/// What a row shows, and then the figures that stand below it, in the order of PeerRow::parts.
using Figures = std::vector<double>;

/// Measures once. The error is one sentence.
using Measure = std::function<tl::expected<Figures, std::string>()>;

/// One thing that is measured.
struct PeerRow {
  std::string_view name;  ///< stable: scripts read it
  std::string_view what;
  std::string_view unit;  ///< empty of ratios
  Target target;
  /// What the figure is made of, and what shows where the time goes; with their units.
  std::array<std::string_view, 7> parts;
  /// From this part on, all are what the figure comes from, in one unit: the largest stands in the
  /// way of the target. None where nothing was taken apart.
  std::optional<std::size_t> firstCost;
  /// Does once what is not measured. The error says what is missing, and what brings it.
  tl::expected<Measure, std::string> (*prepare)(PeerInputs& inputs);
};

/// What came out; nothing but `missing` where that is not empty.
struct PeerResult {
  const PeerRow* row = nullptr;
  std::string missing;
  Range figure;
  std::vector<Range> parts;
};

/// The index of the part that stands in the way of a target that was missed, if that was measured.
std::optional<std::size_t> inTheWay(const PeerResult& result);

/// Measures all rows once, then all again, so often, so that what else the machine does strikes all
/// alike. `tell` hears what is being done.
std::vector<PeerResult> measurePeers(std::span<const PeerRow> rows, PeerInputs& inputs, int repeats,
                                     const std::function<void(std::string_view)>& tell);

}  // namespace hearth
