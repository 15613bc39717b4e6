#include "render/wireframe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "render/screen_edges.h"
#include "render/segment_colors.h"

namespace hearth {

namespace {

/// Metres at which lines are half as bright as beside the eye.
constexpr double kHalfBright = 20;
constexpr double kLeastBright = 0.25;

Rgb faded(Rgb color, double depth) {
  const double fraction = std::max(kLeastBright, kHalfBright / (kHalfBright + depth));
  const auto fade = [fraction](std::uint8_t c) { return static_cast<std::uint8_t>(fraction * c); };
  return {fade(color.r), fade(color.g), fade(color.b)};
}

/// Calls `plot(x, y, depth)` for the pixels of a face's edge, the same ones whichever end is first:
/// most edges are those of two faces.
template <typename Plot>
void plotFaceEdge(const Projection& projection, const Camera& camera, Vec3 a, Vec3 b, double slant,
                  Plot&& plot) {
  if (std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z)) std::swap(a, b);
  const ViewedLine seen = viewed(projection, a.xy(), b.xy(), slant, kNearPlaneOfScreen);
  if (!seen.part) return;
  const auto endAt = [&](double fraction) {
    return EdgeEnd{fraction, std::lerp(a.z, b.z, fraction)};
  };
  plotEdge(projection, camera, seen, endAt(seen.part->from), endAt(seen.part->to), plot);
}

}  // namespace

void drawWireframe(const Scene& scene, const Camera& camera, const Projection& projection,
                   const PixelRows& picture) {
  const double slant = slantOfEdge(camera, projection);
  const auto plot = [&](int x, int y, double depth, Rgb color) {
    *picture.at(x, y) = toXrgb(faded(color, depth));
  };
  forWallsThenWaysOn(scene, [&](const Segment& segment) {
    const ViewedLine seen = viewed(projection, segment.p0, segment.p1, slant, kNearPlaneOfScreen);
    if (seen.part) plotEdges(scene, projection, camera, segment, seen, plot);
  });
  for (const MeshFace& face : scene.level().meshFaces)
    for (std::size_t i = 0; i < face.corners.size(); ++i)
      plotFaceEdge(projection, camera, face.corners[i], face.corners[(i + 1) % face.corners.size()],
                   slant, [&](int x, int y, double depth) { plot(x, y, depth, kMeshColor); });
}

}  // namespace hearth
