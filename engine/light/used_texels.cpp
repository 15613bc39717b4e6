#include "light/used_texels.h"

#include <algorithm>

namespace hearth {

UsedTexels::UsedTexels(const LitSurface& surface, const TexelRect& rect)
    : rect_(rect), runs_(surface.usedRuns(rect.j0, rect.height)) {}

std::int64_t UsedTexels::countIn(const TexelRect& part) const {
  std::int64_t count = 0;
  for (int j = part.j0; j < part.j0 + part.height; ++j)
    forEachRunIn(part, j, [&](int first, int last) { count += last - first + 1; });
  return count;
}

std::optional<TexelRect> UsedTexels::around(const TexelRect& part) const {
  int left = part.i0 + part.width;
  int right = part.i0;
  int top = part.j0 + part.height;
  int bottom = part.j0;
  for (int j = part.j0; j < part.j0 + part.height; ++j)
    forEachRunIn(part, j, [&](int first, int last) {
      left = std::min(left, first);
      right = std::max(right, last + 1);
      top = std::min(top, j);
      bottom = std::max(bottom, j + 1);
    });
  if (top >= bottom) return std::nullopt;
  return TexelRect{left, top, right - left, bottom - top};
}

}  // namespace hearth
