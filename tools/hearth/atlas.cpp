#include "hearth/atlas.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hearth {

namespace {

constexpr int kGap = 1;                    // pixels between lightmaps
constexpr Rgb kBackground = {24, 24, 64};  // no grey, so that no lightmap has it

struct Placement {
  std::size_t surface;
  int x;
  int y;
};

struct Shelves {
  std::vector<Placement> placements;
  int width;
  int height;
};

/// Lightmaps by falling height, one beside the other on shelves about as wide as all are high.
Shelves placeOnShelves(const BakedLight& light) {
  std::vector<std::size_t> order;
  double area = 0;
  int width = 1;
  for (std::size_t i = 0; i < light.lightmaps.size(); ++i) {
    if (!light.lightmaps[i]) continue;
    const TexelRect& rect = light.lightmaps[i]->rect;
    order.push_back(i);
    area += (rect.width + kGap) * static_cast<double>(rect.height + kGap);
    width = std::max(width, rect.width);
  }
  const auto height = [&](std::size_t i) { return light.lightmaps[i]->rect.height; };
  std::ranges::stable_sort(order, [&](auto a, auto b) { return height(a) > height(b); });

  Shelves shelves{{}, std::max(width, static_cast<int>(std::sqrt(area)) + kGap), 1};
  int x = 0;
  int y = 0;
  for (const std::size_t i : order) {
    const int wide = light.lightmaps[i]->rect.width;
    if (x + wide > shelves.width) x = 0, y = shelves.height + kGap;
    shelves.placements.push_back({i, x, y});
    shelves.height = std::max(shelves.height, y + height(i));
    x += wide + kGap;
  }
  return shelves;
}

Rgb colorOf(const Lightmap& map, int i, int j) {
  return {map.at(i, j, 0), map.at(i, j, 1), map.at(i, j, 2)};
}

}  // namespace

Image lightmapAtlas(const BakedLight& light) {
  const Shelves shelves = placeOnShelves(light);
  Image image(shelves.width, shelves.height, kBackground);
  for (const auto& [surface, x, y] : shelves.placements) {
    const Lightmap& map = *light.lightmaps[surface];
    const bool isTurned = light.surfaces[surface]->grid.axisT.z > 0;  // its rows rise
    for (int j = 0; j < map.rect.height; ++j)
      for (int i = 0; i < map.rect.width; ++i) {
        image.at(x + i, y + (isTurned ? map.rect.height - 1 - j : j)) =
            colorOf(map, map.rect.i0 + i, map.rect.j0 + j);
      }
  }
  return image;
}

}  // namespace hearth
