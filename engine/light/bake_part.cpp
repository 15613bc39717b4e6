#include "light/bake_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "light/baking/bounces.h"
#include "light/geometry_hash.h"
#include "light/light_hash.h"
#include "light/parts/joined_light.h"
#include "light/parts/light_tile.h"
#include "light/parts/part_frame.h"
#include "light/parts/sums_as_bytes.h"
#include "light/parts/tile_baker.h"
#include "math/parallel.h"

namespace hearth {

namespace {

/// Indices of tiles, those that take the longest first, so that no thread begins one at the end.
std::vector<std::size_t> byFallingCost(std::span<const LightTile> tiles) {
  std::vector<std::size_t> order(tiles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::size_t i) { return tiles[i].cost; });
  return order;
}

std::int64_t texelsOfTiles(std::span<const LightTile> tiles) {
  std::int64_t texels = 0;
  for (const LightTile& tile : tiles) texels += tile.texels.count();
  return texels;
}

}  // namespace

BakeInParts::BakeInParts(const Scene& scene, const BakeSettings& settings, std::string settingsText)
    : scene_(scene),
      settings_(settings),
      settingsText_(std::move(settingsText)),
      geometryHash_(hearth::geometryHash(scene, settings.texel)),
      lightHash_(hearth::lightHash(scene, settings)) {}

std::string bakePart(const BakeInParts& bake, PartNumber number, int threads,
                     BakeProgress* progress) {
  BakeProgress unwatched;
  BakeProgress& done = progress ? *progress : unwatched;
  Bounces bounces(bake.scene(), bake.settings(), threads);
  const LevelInTiles level(bounces.scene(), bake.settings(), threads);
  const std::vector<std::size_t> firstTiles = firstTilesOf(number.parts, level.tiles);
  const auto tiles =
      std::span(level.tiles).first(firstTiles[number.part]).subspan(firstTiles[number.part - 1]);
  done.begin(texelsOfTiles(tiles));
  if (!tiles.empty()) bounces.find(done);
  const TileBaker baker(bounces, bake.settings(), level, tiles, threads);
  std::vector<std::string> sums(tiles.size());
  const std::vector<std::size_t> order = byFallingCost(tiles);
  parallelFor(order.size(), threads, [&](std::size_t job) {
    const std::size_t i = order[job];
    putSums(sums[i], baker.baked(tiles[i]), tiles[i].texels);
    done.add(tiles[i].texels.count());
  });
  return framed(bake, number, sums);
}

tl::expected<PartNumber, std::string> partNumberOf(const BakeInParts& bake,
                                                   std::string_view bytes) {
  return numberIn(bake, bytes);
}

tl::expected<BakedLight, JoinMistake> joinParts(const BakeInParts& bake,
                                                std::span<const std::string> parts, int threads) {
  const Bounces bounces(bake.scene(), bake.settings(), threads);
  LevelInTiles level(bounces.scene(), bake.settings(), threads);
  const std::vector<LightTile> tiles = std::move(level.tiles);
  const auto firstTiles = firstTilesOf(static_cast<std::uint32_t>(parts.size()), tiles);
  JoinedLight light(bake.scene(), bake.settings(), std::move(level.surfaces),
                    std::move(level.meshes));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto mistake = [k](std::string what) {
      return tl::unexpected(JoinMistake{k, std::move(what)});
    };
    ByteReader in(sumsIn(parts[k]));
    for (std::size_t i = firstTiles[k]; i < firstTiles[k + 1]; ++i) {
      const auto sums = takeSums(in, tiles[i].texels);
      if (!sums)
        return mistake(fmt::format("has no sums for tile {} of {}", i - firstTiles[k] + 1,
                                   firstTiles[k + 1] - firstTiles[k]));
      if (!light.add(tiles[i], *sums)) return mistake("has white and coloured sums of one surface");
    }
    if (in.left() > 0) return mistake(fmt::format("has {} bytes after its sums", in.left()));
  }
  return light.taken();
}

}  // namespace hearth
