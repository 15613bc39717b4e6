// Frames of levels of which most is never seen, however large they are.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>

#include "peers/evenly.h"
#include "peers/grown_level.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

/// Rooms on a grid of squares; the one at (0, 0) is looked at from its middle. A level holds those
/// of [-left, columns - left) x [-top, rows - top).
struct Extent {
  int columns;
  int rows;
  int left;
  int top;

  bool holds(int x, int y) const {
    return x >= -left && x < columns - left && y >= -top && y < rows - top;
  }
};

/// What stands on the grid, the same in levels of all sizes.
struct Layout {
  /// Whether a room has neither height nor air: beyond these nothing is seen.
  bool (*isShut)(int x, int y);
  /// Whether a room leads to the next one to the right, and to the next one below.
  bool (*leadsRight)(int x, int y);
  bool (*leadsDown)(int x, int y);
  Extent small;  ///< of 100 rooms
  Extent large;  ///< of 100,000
};

constexpr int kSeenInRow = 4;   ///< rooms to the right of the first that are seen
constexpr int kSeenOnGrid = 2;  ///< and to all sides of it

constexpr Layout kStrip{
    .isShut = [](int x, int) { return x == kSeenInRow + 1; },
    .leadsRight = [](int, int) { return true; },
    .leadsDown = [](int, int) { return false; },
    .small = {100, 1, 0, 0},
    .large = {100'000, 1, 0, 0},
};

constexpr Layout kGrid{
    .isShut = [](int x, int y) { return std::max(std::abs(x), std::abs(y)) == kSeenOnGrid + 1; },
    .leadsRight = [](int x, int y) { return evenly(x, y, 1) < 0.7; },
    .leadsDown = [](int x, int y) { return evenly(x, y, 2) < 0.7; },
    .small = {10, 10, 5, 5},
    .large = {400, 250, 200, 125},
};

std::string nameOf(int x, int y) { return fmt::format("{},{}", x, y); }

/// A wall to a neighbour that may not be there.
std::string wallText(const Extent& extent, bool leads, int x, int y) {
  if (!leads || !extent.holds(x, y)) return R"({"texture":"#808080"})";
  return fmt::format(R"({{"next":"{}","texture":"#404040"}})", nameOf(x, y));
}

std::string roomText(const Layout& layout, const Extent& extent, int x, int y) {
  const bool isShut = layout.isShut(x, y);
  const double floor = isShut ? 0 : 0.5 * evenly(x, y, 3);
  const double ceiling = isShut ? 0 : 3 + evenly(x, y, 4);
  const int left = 8 * x - 4;
  const int top = 8 * y - 4;
  return fmt::format(
      R"("{}":{{"floor":{{"z":{:.3f},"texture":"#606060"}},"ceiling":{{"z":{:.3f},"texture":"#a0a0a0"}},)"
      R"("loops":{{"border":{{"v":[{},{},{},{},{},{},{},{}],"walls":[{},{},{},{}]}}}}}})",
      nameOf(x, y), floor, ceiling, left, top, left + 8, top, left + 8, top + 8, left, top + 8,
      wallText(extent, layout.leadsDown(x, y - 1), x, y - 1),
      wallText(extent, layout.leadsRight(x, y), x + 1, y),
      wallText(extent, layout.leadsDown(x, y), x, y + 1),
      wallText(extent, layout.leadsRight(x - 1, y), x - 1, y));
}

void writeLevel(const std::filesystem::path& file, const Layout& layout, const Extent& extent) {
  std::ofstream out(file);
  out << R"({"light":0.6,"sectors":{)";
  for (int y = -extent.top; y < extent.rows - extent.top; ++y)
    for (int x = -extent.left; x < extent.columns - extent.left; ++x)
      out << (x == -extent.left && y == -extent.top ? "" : ",\n") << roomText(layout, extent, x, y);
  out << "}}\n";
}

tl::expected<std::shared_ptr<GrownLevel>, std::string> grownLevel(const std::filesystem::path& file,
                                                                  const Layout& layout,
                                                                  const Extent& extent) {
  writeLevel(file, layout, extent);
  return GrownLevel::of(file, {0, 0, 1.6});
}

Prepared prepareGrowth(PeerInputs& inputs, const Layout& layout) {
  const std::filesystem::path file = inputs.folder() / "grown.json";
  const auto small = grownLevel(file, layout, layout.small);
  if (!small) return tl::unexpected(small.error());
  return grownLevel(file, layout, layout.large).map([&](const auto& large) -> Measure {
    return [small = *small, large, &inputs]() -> tl::expected<Figures, std::string> {
      const FrameBench ofSmall = small->measure(inputs.clock());
      const FrameBench ofLarge = large->measure(inputs.clock());
      if (ofSmall.counters != ofLarge.counters)
        return tl::unexpected<std::string>("the two levels do not show the same");
      const double one = ofSmall.milliseconds.median;
      const double other = ofLarge.milliseconds.median;
      return Figures{other / one, one, other};
    };
  });
}

}  // namespace

Prepared prepareStripGrowth(PeerInputs& inputs) { return prepareGrowth(inputs, kStrip); }
Prepared prepareGridGrowth(PeerInputs& inputs) { return prepareGrowth(inputs, kGrid); }

}  // namespace hearth
