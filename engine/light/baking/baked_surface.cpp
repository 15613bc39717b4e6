#include "light/baking/baked_surface.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "light/baking/clipped_light.h"
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

void addTile(const Tile& tile, SurfaceLight& surface, const SumsOf& sumsOf) {
  const SampleBlocks blocks = samplesOf(surface, tile.rect, tile.side);
  for (const std::size_t light : tile.lights) {
    if (!surface.reaches(light, blocks)) continue;
    TexelSums& sums = sumsOf(light);
    if (std::ranges::any_of(surface.seenFractions(light, blocks),
                            [](double seen) { return seen > 0; }))
      addLevels(tile, surface.light(light), surface.brightness(light, blocks), sums);
  }
}

void addSampledLight(const TexelRect& rect, int side, std::span<const std::size_t> lights,
                     SurfaceLight& surface, const SumsOf& sumsOf, BakeProgress& progress,
                     const std::stop_token& stop) {
  const std::vector<TexelRect> tiles = tilesOf(rect);
  SurfaceProgress done(progress, rect.count(), std::ssize(tiles));
  for (const TexelRect& tile : tiles) {
    if (stop.stop_requested()) return;
    addTile({tile, side, lights}, surface, sumsOf);
    done.step();
  }
}

/// `rect` is what must be baked, see texelsToBake.
void addLightsIn(const TexelRect& rect, SurfaceLight& surface, std::span<const std::size_t> lights,
                 const BakeSettings& settings, const SumsOf& sumsOf, BakeProgress& progress,
                 const std::stop_token& stop) {
  if (settings.samples)
    addSampledLight(rect, static_cast<int>(std::lround(std::sqrt(*settings.samples))), lights,
                    surface, sumsOf, progress, stop);
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

SampleBlocks samplesOf(const SurfaceLight& surface, const TexelRect& tile, int side) {
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

TexelRect texelsToBake(const TexelRect& wanted, const LitSurface& surface,
                       const BakeSettings& settings) {
  return settings.samples ? intersection(wanted, surface.texels) : surface.texels;
}

std::optional<Lightmap> bakeSurface(SurfaceLight& surface, const TexelRect& baked,
                                    const BakeSettings& settings, BakeProgress& progress) {
  if (surface.facing().empty()) {
    progress.add(baked.count());
    return std::nullopt;
  }
  TexelSums sums(baked, surface.channels());
  const auto all = [&](std::size_t) -> TexelSums& { return sums; };
  addLightsIn(baked, surface, surface.facing(), settings, all, progress, {});
  return lightmapOf(sums, settings);
}

std::optional<Lightmap> lightmapOf(const TexelSums& sums, const BakeSettings& settings) {
  return sums.toLightmap(settings.samples.value_or(1));
}

}  // namespace hearth
