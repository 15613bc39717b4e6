#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "image/image.h"
#include "level/level.h"
#include "light/bakery.h"

namespace hearth {

/// In pixels. 64 bits, because rectangles that do not fit into a picture have sizes, too.
struct AtlasPlace {
  std::int64_t x = 0;
  std::int64_t y = 0;
};
struct AtlasSize {
  std::int64_t width = 0;
  std::int64_t height = 0;
};

/// Rectangles beside one another on shelves.
struct Shelves {
  std::vector<AtlasPlace> places;  ///< of the left top corners, in the order of the rectangles
  AtlasSize size;                  ///< of all
};

/// Places rectangles, the tallest first, on shelves about as wide as all are high. They touch
/// neither one another nor the border.
Shelves placeOnShelves(std::span<const AtlasSize> rectangles);

/// The label above a surface's lightmap: its kind, and its sector with the number of the wall as
/// in the file, or `SECTOR/LOOP` and the number in an inner loop.
std::vector<std::string> labelOf(const Level& level, SurfaceId surface);

/// All lightmaps of a level side by side, with labels: a picture to look at. Walls are upright.
/// All texels are squares of one whole number of pixels, larger if the picture stays small. A
/// picture larger than the limit is refused.
tl::expected<Image, std::string> lightmapAtlas(const Level& level, const BakedLight& light);

}  // namespace hearth
