#include "render/texels_in_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "render/group_mapping.h"
#include "render/renderer.h"
#include "render/visibility.h"

namespace hearth {

namespace {

/// A box of points on a lightmap, in texel coordinates.
struct Reads {
  Vec2 low;
  Vec2 high;

  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

/// Light is mixed from texels whose middles are less than one texel off. Another one, as places in
/// the middle of a span are worked out on other ways than at its ends.
constexpr int kAround = 2;

/// The first and one past the last texel of an axis, of those in [begin, end), that is read between
/// two places; at least two, as lightmaps have. Clamped before they are whole numbers: on a plane
/// that is seen on edge, rounding can put places anywhere.
std::pair<int, int> readBetween(double low, double high, int begin, int end) {
  const auto within = [](double texel, int least, int most) {
    return static_cast<int>(std::clamp<double>(texel, least, most));
  };
  return {within(std::floor(low) - kAround, begin, end - 2),
          within(std::floor(high) + kAround + 1, begin + 2, end)};
}

TexelRect readIn(const Reads& reads, const TexelRect& all) {
  const auto [i0, i1] = readBetween(reads.low.x, reads.high.x, all.i0, all.i0 + all.width);
  const auto [j0, j1] = readBetween(reads.low.y, reads.high.y, all.j0, all.j0 + all.height);
  return {i0, j0, i1 - i0, j1 - j0};
}

/// Along a span places change in one direction: its ends bound them.
void addEnds(const SpanMapping& mapping, const Projection& projection, const Span& span,
             std::map<SurfaceId, Reads>& reads) {
  for (const int row : {span.rowBegin, span.rowEnd - 1}) {
    const double parameter = mapping.parameterAt(projection.raySlopeAt(row + 0.5));
    const Vec2 place{mapping.s.at(parameter), mapping.t.at(parameter)};
    reads.try_emplace(span.surface, Reads{place, place}).first->second.add(place);
  }
}

}  // namespace

WantedTexels texelsInView(const Scene& scene, const LitSurfaces& surfaces, const Camera& camera,
                          const DrawSettings& settings) {
  const Projection projection = projectionFor(scene, camera, settings.pixelSize);
  VisibilityScratch scratch;
  std::map<SurfaceId, Reads> reads;
  std::set<std::uint32_t> faces;
  const Camera squares = inSquares(camera, settings.pixelSize);
  findVisibleSpans(scene, squares, projection, scratch).forEachSpan([&](const Span& span) {
    if (span.face) faces.insert(scene.level().indexOf(*span.face));
    if (const auto& lit = surfaces[span.surface.index()])
      addEnds(mappingOf(scene, projection, span, nullptr, {&*lit, nullptr}), projection, span,
              reads);
  });

  WantedTexels seen;
  for (const auto& [id, read] : reads)
    seen.surfaces.push_back({id, readIn(read, surfaces[id.index()]->texels)});
  seen.faces.assign(faces.begin(), faces.end());
  return seen;
}

}  // namespace hearth
