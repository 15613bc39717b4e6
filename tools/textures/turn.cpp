#include "textures/turn.h"

#include "textures/noise.h"

namespace hearth::textures {

Image turned(const Image& tile) {
  Image out(tile.height(), tile.width());
  for (int y = 0; y < tile.height(); ++y) {
    for (int x = 0; x < tile.width(); ++x) out.at(tile.height() - 1 - y, x) = tile.at(x, y);
  }
  return out;
}

// An eighth of a turn maps (x, y) to (x - y, x + y) / sqrt(2). Without the root, both are whole
// numbers, and a step of the tile's side along x or y changes both by a multiple of it.
Image diagonal(const Image& tile) {
  Image out(tile.width(), tile.height());
  for (int y = 0; y < tile.height(); ++y) {
    for (int x = 0; x < tile.width(); ++x)
      out.at(x, y) = tile.at(wrap(x - y, tile.width()), wrap(2 * (x + y), tile.height()));
  }
  return out;
}

}  // namespace hearth::textures
