#include "light/baked_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "light/clipped_light.h"
#include "light/texel_sums.h"
#include "math/planted_bug.h"

namespace hearth {

namespace {

/// Texels are baked in tiles of so many a side, so that the samples at hand take little memory.
constexpr int kTile = 64;

/// Samples of a tile of texels, side x side to each.
SampleBlocks samplesOf(const SurfaceLight& surface, const TexelRect& tile, int side) {
  const double reach = planted(PlantedBug::SamplesOutsideTexel) ? 2 : 1;
  const auto along = [&](int texel0, int k) {
    const int texel = texel0 + k / side;
    return texel + (0.5 + reach * ((k % side + 0.5) / side - 0.5));
  };
  const int columns = tile.width * side;
  const int rows = tile.height * side;
  std::vector<SamplePoint> samples;
  samples.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      samples.push_back(surface.place({along(tile.i0, i), along(tile.j0, j)}));
  return surface.inBlocks(std::move(samples), columns, rows);
}

void addTile(const TexelRect& tile, int side, SurfaceLight& surface, TexelSums& sums) {
  const SampleBlocks blocks = samplesOf(surface, tile, side);
  for (const std::size_t light : surface.facing()) {
    if (!surface.reaches(light, blocks)) continue;
    const std::vector<double>& seen = surface.seenShares(light, blocks);
    for (int j = 0; j < tile.height * side; ++j)
      for (int i = 0; i < tile.width * side; ++i) {
        const std::size_t index = blocks.index(i, j);
        const SamplePoint& at = blocks.samples()[index];
        if (seen[index] == 0) continue;
        if (planted(PlantedBug::BorderTexelsBlack) && at.point != at.target) continue;
        sums.add(tile.i0 + i / side, tile.j0 + j / side, surface.light(light),
                 seen[index] * surface.fullLevel(light, at));
      }
  }
}

/// side x side samples to each texel.
void addSampledLight(int side, SurfaceLight& surface, TexelSums& sums, BakeProgress& progress) {
  const TexelRect rect = surface.texels();
  const auto tiles = [](int texels) { return std::int64_t{(texels + kTile - 1) / kTile}; };
  SurfaceProgress done(progress, rect.count(), tiles(rect.width) * tiles(rect.height));
  for (int j = 0; j < rect.height; j += kTile)
    for (int i = 0; i < rect.width; i += kTile, done.step())
      addTile({rect.i0 + i, rect.j0 + j, std::min(kTile, rect.width - i),
               std::min(kTile, rect.height - j)},
              side, surface, sums);
}

}  // namespace

std::optional<Lightmap> bakeSurface(SurfaceLight& surface, const BakeSettings& settings,
                                    BakeProgress& progress) {
  if (surface.facing().empty()) {
    progress.add(surface.texels().count());
    return std::nullopt;
  }
  TexelSums sums(surface.texels(), surface.channels());
  if (settings.samples)
    addSampledLight(static_cast<int>(std::lround(std::sqrt(*settings.samples))), surface, sums,
                    progress);
  else
    addClippedLight(surface, sums, progress);
  return sums.toLightmap(settings.samples.value_or(1), settings.bits);
}

}  // namespace hearth
