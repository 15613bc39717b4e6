#include "light/baking/baked_surface.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "light/baking/clipped_light.h"
#include "light/baking/left_out.h"
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
std::vector<std::size_t> samplesOfTexel(const TexelRect& tile, int side, int i, int j) {
  std::vector<std::size_t> samples;
  const int columns = tile.width * side;
  for (int row = (j - tile.j0) * side; row < (j - tile.j0 + 1) * side; ++row)
    for (int column = (i - tile.i0) * side; column < (i - tile.i0 + 1) * side; ++column)
      samples.push_back(static_cast<std::size_t>(row * columns + column));
  return samples;
}

/// How often each sample of a tile counts, so that the others stand for those that are left out.
std::vector<double> weightsOf(const Tile& tile, const LeftOut& left) {
  std::vector<double> weights(static_cast<std::size_t>(tile.rect.count() * tile.side * tile.side));
  const TexelRect& rect = tile.rect;
  for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
    for (int i = rect.i0; i < rect.i0 + rect.width; ++i) {
      const std::vector<std::size_t> samples = samplesOfTexel(rect, tile.side, i, j);
      const auto kept = static_cast<double>(
          std::ranges::count_if(samples, [&](std::size_t sample) { return !left.is(sample); }));
      for (const std::size_t sample : samples)
        weights[sample] = left.is(sample) ? 0 : static_cast<double>(samples.size()) / kept;
    }
  return weights;
}

/// Adds the used texels of a tile whose samples are all left out.
void addEmpty(const TexelRect& tile, int side, const UsedTexels& texels, const LeftOut& left,
              EmptyTexels& empty) {
  if (left.isNone()) return;
  for (int j = tile.j0; j < tile.j0 + tile.height; ++j)
    texels.forEachRunIn(tile, j, [&](int first, int last) {
      for (int i = first; i <= last; ++i)
        if (left.areAll(samplesOfTexel(tile, side, i, j))) empty.add(i, j);
    });
}

/// Adds what is empty of the tile to `empty`, if that is asked for.
template <typename Lit>
void addTile(const Tile& tile, const UsedTexels& texels, Lit& surface, const SumsOf& sumsOf,
             EmptyTexels* empty) {
  const typename Lit::Blocks blocks = samplesOf(surface, texels, tile.rect, tile.side);
  const LeftOut left(surface, blocks.samples());
  if (empty) addEmpty(tile.rect, tile.side, texels, left, *empty);
  const std::vector<double> weights = left.isNone() ? std::vector<double>{} : weightsOf(tile, left);
  std::vector<double> weighted;
  for (const std::size_t light : surface.reaching(blocks, tile.lights)) {
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

int samplesAlong(const BakeSettings& settings) {
  return static_cast<int>(std::lround(std::sqrt(*settings.samples)));
}

/// Adds some of the facing lights to the used texels of a tile, which is a rectangle around them.
template <typename Lit>
void addLightsToTile(Lit& surface, const UsedTexels& texels, const TexelRect& tile,
                     std::span<const std::size_t> lights, const BakeSettings& settings,
                     const SumsOf& sumsOf, EmptyTexels* empty, const std::stop_token& stop) {
  if (settings.samples)
    addTile({tile, samplesAlong(settings), lights}, texels, surface, sumsOf, empty);
  else
    addClippedLight(surface, texels, tile, lights, sumsOf, empty, stop);
}

/// The sums of all facing lights in a tile, which is a rectangle around used texels.
template <typename Lit>
TexelSums sumsOfTile(Lit& surface, const UsedTexels& texels, const TexelRect& tile,
                     const BakeSettings& settings, EmptyTexels* empty) {
  TexelSums sums(tile, surface.channels());
  const auto all = [&](std::size_t) -> TexelSums& { return sums; };
  addLightsToTile(surface, texels, tile, surface.facing(), settings, all, empty, {});
  return sums;
}

/// Fills a row of samples up to some number with spare ones at the place of another.
void fillUpTo(std::size_t size, SamplePoint place, std::vector<SamplePoint>& samples) {
  place.isSpare = true;
  samples.resize(size, place);
}

/// The samples of a tile, row by row.
template <typename Places>
std::vector<SamplePoint> placedSamples(const Places& places, const UsedTexels& texels,
                                       const TexelRect& tile, int side) {
  const auto along = [&](int texel0, int k) {
    const int texel = texel0 + k / side;
    return texel + (k % side + 0.5) / side;
  };
  const auto columns = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(side);
  const int rows = tile.height * side;
  std::vector<SamplePoint> samples;
  samples.reserve(columns * static_cast<std::size_t>(rows));
  SamplePlacement::Rows inRows = places.inRows();
  for (int j = 0; j < rows; ++j) {
    const std::size_t begin = samples.size();
    inRows.begin(along(tile.j0, j));
    texels.forEachRunIn(tile, tile.j0 + j / side, [&](int first, int last) {
      const int end = (last + 1 - tile.i0) * side;
      int k = (first - tile.i0) * side;
      const SamplePoint atFirst = inRows.place(along(tile.i0, k));
      fillUpTo(begin + static_cast<std::size_t>(k), atFirst, samples);
      for (samples.push_back(atFirst); ++k < end;)
        samples.push_back(inRows.place(along(tile.i0, k)));
    });
    fillUpTo(begin + columns, samples.back(), samples);
  }
  return samples;
}

}  // namespace

std::vector<TexelRect> tilesOf(const TexelRect& all, int side) {
  std::vector<TexelRect> tiles;
  for (int j = 0; j < all.height; j += side)
    for (int i = 0; i < all.width; i += side)
      tiles.push_back(
          {all.i0 + i, all.j0 + j, std::min(side, all.width - i), std::min(side, all.height - j)});
  return tiles;
}

std::vector<TexelRect> tilesOf(const UsedTexels& texels) {
  constexpr int kSide = 32;
  std::vector<TexelRect> tiles;
  for (const TexelRect& tile : tilesOf(texels.rect(), kSide))
    if (const auto used = texels.around(tile)) tiles.push_back(*used);
  return tiles;
}

template <typename Lit>
typename Lit::Blocks samplesOf(const Lit& surface, const UsedTexels& texels, const TexelRect& tile,
                               int side) {
  return surface.inBlocks(placedSamples(surface, texels, tile, side), tile.width * side);
}

template SampleBlocks samplesOf(const SurfaceLight&, const UsedTexels&, const TexelRect&, int);

void addLights(SurfaceLight& surface, const UsedTexels& texels, std::span<const std::size_t> lights,
               const BakeSettings& settings, const SumsOf& sumsOf, BakeProgress& progress,
               const std::stop_token& stop) {
  const std::vector<TexelRect> tiles = tilesOf(texels);
  SurfaceProgress done(progress, texels.rect().count(), std::ssize(tiles));
  for (const TexelRect& tile : tiles) {
    if (stop.stop_requested()) return;
    addLightsToTile(surface, texels, tile, lights, settings, sumsOf, nullptr, stop);
    done.step();
  }
}

void addLightsDraft(SurfaceLight& surface, std::span<const std::size_t> lights,
                    const BakeSettings& settings, const SumsOf& sumsOf) {
  const TexelRect rect = surface.surface().texels;
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
  const SampleBlocks blocks = surface.inBlocks(std::move(samples), columns);
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

TexelRect texelsToBake(const SurfaceTexels& wanted, const Scene& scene,
                       const LitSurfaces& surfaces) {
  const TexelRect& all = surfaces[wanted.surface.index()]->texels;
  return mayHaveSamplesInMeshes(scene, surfaces, wanted.surface) ? all
                                                                 : intersection(wanted.texels, all);
}

template <typename Places>
EmptyTexels emptyTexelsOf(const Places& places, const UsedTexels& texels,
                          const BakeSettings& settings) {
  EmptyTexels empty(texels);
  if (!places.mayLeaveOut()) return empty;
  for (const TexelRect& tile : tilesOf(texels)) {
    if (!settings.samples) {
      addEmptyOfCorners(places, texels, tile, empty);
      continue;
    }
    const int side = samplesAlong(settings);
    addEmpty(tile, side, texels, LeftOut(places, placedSamples(places, texels, tile, side)), empty);
  }
  return empty;
}

template EmptyTexels emptyTexelsOf(const SurfacePlaces&, const UsedTexels&, const BakeSettings&);
template EmptyTexels emptyTexelsOf(const PatchPlaces&, const UsedTexels&, const BakeSettings&);

template <typename Places>
std::optional<Lightmap> finishedLightmap(const Places& places, LightmapBuilder map,
                                         const BakeSettings& settings) {
  if (map.isDark()) return std::nullopt;
  const EmptyTexels empty = emptyTexelsOf(places, map.texels(), settings);
  return std::move(map).finished(empty);
}

template std::optional<Lightmap> finishedLightmap(const SurfacePlaces&, LightmapBuilder,
                                                  const BakeSettings&);
template std::optional<Lightmap> finishedLightmap(const PatchPlaces&, LightmapBuilder,
                                                  const BakeSettings&);

template <typename Lit>
TexelSums sumsOfTile(Lit& surface, const TexelRect& tile, const BakeSettings& settings,
                     const std::stop_token& stop) {
  const UsedTexels texels(surface.surface(), tile);
  const auto used = texels.around(tile);
  if (!used) return {{tile.i0, tile.j0, 0, 0}, 1};
  TexelSums sums(*used, surface.channels());
  const auto all = [&](std::size_t) -> TexelSums& { return sums; };
  for (const TexelRect& part : tilesOf(texels)) {
    if (stop.stop_requested()) break;
    addLightsToTile(surface, texels, part, surface.facing(), settings, all, nullptr, stop);
  }
  return sums;
}

template TexelSums sumsOfTile(SurfaceLight&, const TexelRect&, const BakeSettings&,
                              const std::stop_token&);
template TexelSums sumsOfTile(PatchLight&, const TexelRect&, const BakeSettings&,
                              const std::stop_token&);

template <typename Lit>
std::optional<Lightmap> bakeSurface(Lit& surface, const TexelRect& rect,
                                    const BakeSettings& settings, BakeProgress& progress) {
  if (surface.facing().empty()) {
    progress.add(rect.count());
    return std::nullopt;
  }
  const UsedTexels texels(surface.surface(), rect);
  LightmapBuilder map(texels, settings.samples.value_or(1));
  EmptyTexels empty(texels);
  const std::vector<TexelRect> tiles = tilesOf(texels);
  SurfaceProgress done(progress, rect.count(), std::ssize(tiles));
  for (const TexelRect& tile : tiles) {
    map.add(sumsOfTile(surface, texels, tile, settings, &empty));
    done.step();
  }
  return std::move(map).finished(empty);
}

template std::optional<Lightmap> bakeSurface(SurfaceLight&, const TexelRect&, const BakeSettings&,
                                             BakeProgress&);
template std::optional<Lightmap> bakeSurface(PatchLight&, const TexelRect&, const BakeSettings&,
                                             BakeProgress&);

}  // namespace hearth
