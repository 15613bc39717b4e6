#include "measure/light_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace hearth {

namespace {

int levelAt(const std::optional<Lightmap>& map, int i, int j, int channel) {
  if (!map) return 0;
  return map->at(i, j, map->channels == 1 ? 0 : channel);
}

}  // namespace

LightDifference differenceOf(const BakedLight& a, const BakedLight& b) {
  LightDifference difference;
  double squares = 0;
  for (std::size_t surface = 0; surface < a.surfaces.size(); ++surface) {
    const std::optional<Lightmap>& one = a.lightmaps[surface];
    const std::optional<Lightmap>& other = b.lightmaps[surface];
    if (!a.surfaces[surface] || (!one && !other)) continue;
    const LitSurface& lit = *a.surfaces[surface];
    const auto runs = lit.usedRuns(lit.texels.j0, lit.texels.height);
    for (int row = 0; row < lit.texels.height; ++row)
      for (const auto& [first, last] : runs.row(row))
        for (int i = first; i <= last; ++i) {
          int most = 0;
          for (int channel = 0; channel < 3; ++channel) {
            const int j = lit.texels.j0 + row;
            const int off = std::abs(levelAt(one, i, j, channel) - levelAt(other, i, j, channel));
            most = std::max(most, off);
            squares += double{1} * off * off;
          }
          ++difference.texels;
          difference.visible += most > LightDifference::kVisible ? 1 : 0;
          difference.most = std::max(difference.most, most);
        }
  }
  if (difference.texels > 0)
    difference.rms = std::sqrt(squares / (3 * static_cast<double>(difference.texels)));
  return difference;
}

}  // namespace hearth
