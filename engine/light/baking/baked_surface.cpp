#include "light/baking/baked_surface.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "light/baking/clipped_light.h"
#include "light/baking/patch_light.h"
#include "light/baking/texel_sums.h"

namespace hearth {

namespace {

/// Of a tile of a surface: its samples, and which lights to ask.
struct Tile {
  TexelRect rect;
  int side;  ///< side x side samples to each texel
  std::span<const std::size_t> lights;
};

/// The levels of samples to their texels.
void addLevels(const Tile& tile, const LightSource& light, const std::vector<double>& levels,
               TexelSums& sums) {
  const auto& [rect, side, lights] = tile;
  const auto columns = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(side);
  for (int j = 0; j < rect.height * side; ++j) {
    const auto row = std::span(levels).subspan(static_cast<std::size_t>(j) * columns, columns);
    const int texelRow = rect.j0 + j / side;
    if (side == 1)
      sums.addRow(rect.i0, texelRow, light, row);
    else
      for (int i = 0; i < rect.width * side; ++i)
        sums.add(rect.i0 + i / side, texelRow, light, row[static_cast<std::size_t>(i)]);
  }
}

/// The samples of a texel, by their indices among those of a tile.
std::vector<std::size_t> samplesOfTexel(const Tile& tile, int i, int j) {
  std::vector<std::size_t> samples;
  const int columns = tile.rect.width * tile.side;
  for (int row = j * tile.side; row < (j + 1) * tile.side; ++row)
    for (int column = i * tile.side; column < (i + 1) * tile.side; ++column)
      samples.push_back(static_cast<std::size_t>(row * columns + column));
  return samples;
}

/// How often each sample of a tile counts, so that the others stand for those that are left out.
std::vector<double> weightsOf(const Tile& tile, const LeftOut& left) {
  std::vector<double> weights(static_cast<std::size_t>(tile.rect.count() * tile.side * tile.side));
  for (int j = 0; j < tile.rect.height; ++j)
    for (int i = 0; i < tile.rect.width; ++i) {
      const std::vector<std::size_t> samples = samplesOfTexel(tile, i, j);
      const auto kept = static_cast<double>(
          std::ranges::count_if(samples, [&](std::size_t sample) { return !left.is(sample); }));
      for (const std::size_t sample : samples)
        weights[sample] = left.is(sample) ? 0 : static_cast<double>(samples.size()) / kept;
    }
  return weights;
}

template <typename Lit>
void addTile(const Tile& tile, Lit& surface, const SumsOf& sumsOf) {
  const typename Lit::Blocks blocks = samplesOf(surface, tile.rect, tile.side);
  const LeftOut left(surface, blocks.samples());
  const std::vector<double> weights = left.isNone() ? std::vector<double>{} : weightsOf(tile, left);
  std::vector<double> weighted;
  for (const std::size_t light : tile.lights) {
    if (!surface.reaches(light, blocks)) continue;
    TexelSums& sums = sumsOf(light);
    if (std::ranges::none_of(surface.seenFractions(light, blocks),
                             [](double seen) { return seen > 0; }))
      continue;
    const std::vector<double>& levels = surface.brightness(light, blocks);
    if (left.isNone()) {
      addLevels(tile, surface.light(light), levels, sums);
      continue;
    }
    weighted = levels;
    for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i] *= weights[i];
    addLevels(tile, surface.light(light), weighted, sums);
  }
}

template <typename Lit>
void addSampledLight(const TexelRect& rect, int side, std::span<const std::size_t> lights,
                     Lit& surface, const SumsOf& sumsOf, BakeProgress& progress,
                     const std::stop_token& stop) {
  const std::vector<TexelRect> tiles = tilesOf(rect);
  SurfaceProgress done(progress, rect.count(), std::ssize(tiles));
  for (const TexelRect& tile : tiles) {
    if (stop.stop_requested()) return;
    addTile({tile, side, lights}, surface, sumsOf);
    done.step();
  }
}

int samplesAlong(const BakeSettings& settings) {
  return static_cast<int>(std::lround(std::sqrt(*settings.samples)));
}

/// `rect` is what must be baked, see texelsToBake.
template <typename Lit>
void addLightsIn(const TexelRect& rect, Lit& surface, std::span<const std::size_t> lights,
                 const BakeSettings& settings, const SumsOf& sumsOf, BakeProgress& progress,
                 const std::stop_token& stop) {
  if (settings.samples)
    addSampledLight(rect, samplesAlong(settings), lights, surface, sumsOf, progress, stop);
  else
    addClippedLight(surface, lights, sumsOf, progress, stop);
}

}  // namespace

std::vector<TexelRect> tilesOf(const TexelRect& texels) {
  constexpr int kTile = 64;  // texels a side
  std::vector<TexelRect> tiles;
  for (int j = 0; j < texels.height; j += kTile)
    for (int i = 0; i < texels.width; i += kTile)
      tiles.push_back({texels.i0 + i, texels.j0 + j, std::min(kTile, texels.width - i),
                       std::min(kTile, texels.height - j)});
  return tiles;
}

template <typename Lit>
typename Lit::Blocks samplesOf(const Lit& surface, const TexelRect& tile, int side) {
  const auto along = [&](int texel0, int k) {
    const int texel = texel0 + k / side;
    return texel + (k % side + 0.5) / side;
  };
  const int columns = tile.width * side;
  const int rows = tile.height * side;
  std::vector<double> inRow;
  for (int i = 0; i < columns; ++i) inRow.push_back(along(tile.i0, i));
  std::vector<SamplePoint> samples;
  samples.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int j = 0; j < rows; ++j) surface.placeRow(inRow, along(tile.j0, j), samples);
  return surface.inBlocks(std::move(samples), columns, rows);
}

template SampleBlocks samplesOf(const SurfaceLight&, const TexelRect&, int);

void addLights(SurfaceLight& surface, std::span<const std::size_t> lights,
               const BakeSettings& settings, const SumsOf& sumsOf, BakeProgress& progress,
               const std::stop_token& stop) {
  addLightsIn(surface.texels(), surface, lights, settings, sumsOf, progress, stop);
}

void addLightsDraft(SurfaceLight& surface, std::span<const std::size_t> lights,
                    const BakeSettings& settings, const SumsOf& sumsOf) {
  const TexelRect rect = surface.texels();
  const auto samplesAlong = [](int texels) { return (texels + kDraftSide - 1) / kDraftSide; };
  const auto middle = [](int first, int texels, int k) {
    return first + std::min((k + 0.5) * kDraftSide, static_cast<double>(texels));
  };
  const int columns = samplesAlong(rect.width);
  const int rows = samplesAlong(rect.height);
  std::vector<SamplePoint> samples;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      samples.push_back(
          surface.place({middle(rect.i0, rect.width, i), middle(rect.j0, rect.height, j)}));
  const SampleBlocks blocks = surface.inBlocks(std::move(samples), columns, rows);
  for (const std::size_t light : lights) {
    TexelSums& sums = sumsOf(light);
    const std::vector<double>& seen = surface.seenFractions(light, blocks);
    for (int j = 0; j < rect.height; ++j)
      for (int i = 0; i < rect.width; ++i) {
        const std::size_t index = blocks.index(i / kDraftSide, j / kDraftSide);
        if (seen[index] > 0)
          sums.add(rect.i0 + i, rect.j0 + j, surface.light(light),
                   settings.samples.value_or(1) * seen[index] *
                       surface.unshadowedBrightness(light, blocks.samples()[index]));
      }
  }
}

TexelRect texelsToBake(const SurfaceTexels& wanted, const Scene& scene, const LitSurfaces& surfaces,
                       const BakeSettings& settings) {
  const TexelRect& all = surfaces[wanted.surface.index()]->texels;
  const bool areAlone =
      settings.samples && !mayHaveSamplesInMeshes(scene, surfaces, wanted.surface);
  return areAlone ? intersection(wanted.texels, all) : all;
}

template <typename Lit>
EmptyTexels emptyTexelsOf(const Lit& surface, const TexelRect& baked,
                          const BakeSettings& settings) {
  EmptyTexels empty(baked);
  if (!surface.mayLeaveOut()) return empty;
  // With corners for samples, one more each way.
  const int side = settings.samples ? samplesAlong(settings) : 1;
  const bool areCorners = !settings.samples;
  const auto isLeftOut = [&](int i, int j, int column, int row) {
    const double shift = areCorners ? 0 : 0.5;
    return surface.isLeftOut(
        surface.place({i + (column + shift) / side, j + (row + shift) / side}));
  };
  const int samples = areCorners ? 2 : side;
  const auto isEmpty = [&](int i, int j) {
    for (int row = 0; row < samples; ++row)
      for (int column = 0; column < samples; ++column)
        if (!isLeftOut(i, j, column, row)) return false;
    return true;
  };
  for (int j = baked.j0; j < baked.j0 + baked.height; ++j) {
    UsedTexelRow row = surface.usedRuns(j);
    for (int i = baked.i0; i < baked.i0 + baked.width; ++i) {
      if (const int used = row.nearest(i); used != i)
        empty.addUnused(i, j, used);
      else if (isEmpty(i, j))
        empty.add(i, j);
    }
  }
  return empty;
}

template EmptyTexels emptyTexelsOf(const SurfaceLight&, const TexelRect&, const BakeSettings&);

template <typename Lit>
std::optional<Lightmap> bakeSurface(Lit& surface, const TexelRect& baked,
                                    const BakeSettings& settings, BakeProgress& progress) {
  if (surface.facing().empty()) {
    progress.add(baked.count());
    return std::nullopt;
  }
  TexelSums sums(baked, surface.channels());
  const auto all = [&](std::size_t) -> TexelSums& { return sums; };
  addLightsIn(baked, surface, surface.facing(), settings, all, progress, {});
  emptyTexelsOf(surface, baked, settings).fill(sums);
  return lightmapOf(sums, settings);
}

template std::optional<Lightmap> bakeSurface(SurfaceLight&, const TexelRect&, const BakeSettings&,
                                             BakeProgress&);
template std::optional<Lightmap> bakeSurface(PatchLight&, const TexelRect&, const BakeSettings&,
                                             BakeProgress&);

std::optional<Lightmap> lightmapOf(const TexelSums& sums, const BakeSettings& settings) {
  return sums.toLightmap(settings.samples.value_or(1));
}

}  // namespace hearth
