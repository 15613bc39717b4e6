#include "light/baking/lightmap_builder.h"

#include <utility>

#include "math/check.h"

namespace hearth {

void LightmapBuilder::add(const TexelSums& sums) {
  if (sums.isDark()) return;
  if (!map_) map_ = Lightmap::dark(texels_.rect(), sums.channels());
  CHECK(sums.channels() == map_->channels, sums.channels(), map_->channels);
  const TexelRect& tile = sums.rect();
  for (int j = tile.j0; j < tile.j0 + tile.height; ++j)
    texels_.forEachRunIn(tile, j, [&](int first, int last) {
      sums.round(first, j, last - first + 1, samples_, *map_);
    });
}

std::optional<Lightmap> LightmapBuilder::finished(const EmptyTexels& empty) && {
  if (!map_) return std::nullopt;
  empty.fill(*map_);
  const TexelRect& rect = map_->rect;
  for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
    texels_.forEachUnused(j, [&](int i, int used) { map_->copyTexel(used, j, i, j); });
  return simplified(*std::move(map_));
}

}  // namespace hearth
