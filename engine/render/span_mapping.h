#pragma once

#include <algorithm>

#include "render/texture.h"

namespace hearth {

/// A linear function.
struct Affine {
  double atZero = 0;
  double per = 0;

  double at(double x) const { return atZero + x * per; }
};

/// A texel coordinate of an image, not yet repeated. Where authors give places in metres, on planes
/// and up walls, the place is computed first and the texel from it. So at round places, where they
/// put edges of texels, the result is exact.
struct ImageAxis {
  /// In metres; on faces of meshes in repeats; up a sky the tangent of the elevation; along walls,
  /// standing sprites and skies in texels.
  Affine place;
  double origin = 0;  ///< the place of the image's edge
  double texelsPerPlace = 1;
  double offset = 0;  ///< in texels

  double at(double x) const { return (place.at(x) - origin) * texelsPerPlace - offset; }
};

/// Where the rows of a span lie in space, on the texture and on the lightmap. The four texel
/// coordinates are linear functions of one number, the span's parameter: on planes the depth, on
/// upright surfaces and sky the slope of the view ray (see Projection::raySlopeAt).
struct SpanMapping {
  bool isPlane = false;  ///< a flat or slope, a sprite that lies, or a face that is not upright
  bool isSky = false;    ///< all else is upright
  /// Planes: z = height + rise * depth above the eye, in the direction of the column.
  double height = 0;
  double rise = 0;
  double depth = 0;  ///< metres; of a plane the farthest
  ImageAxis u{};
  ImageAxis v{};
  Affine s{};  ///< in texels of the lightmap
  Affine t{};

  double parameterAt(double raySlope) const { return isPlane ? depthAt(raySlope) : raySlope; }

  /// The depth of a plane. Rounding at the horizon and at the far edge cannot leave the sector.
  double depthAt(double raySlope) const {
    const double found = height / (raySlope - rise);
    return found >= 0 && found < depth ? found : depth;
  }

  /// The v of a sky. Beyond the image its edge rows are repeated.
  double skyV(double raySlope, const Texture& image) const {
    return std::max(0.5, std::min(v.at(raySlope), image.height() - 0.5));
  }
};

}  // namespace hearth
