#pragma once

#include "level/mesh.h"
#include "level/scene.h"
#include "render/camera.h"
#include "render/span.h"
#include "render/span_mapping.h"
#include "render/texture.h"

namespace hearth {

/// The mip level whose texels are nearest in area to pixels that cover so many texels: 0 is the
/// full size.
int mipLevelOf(double texels);

/// How many texels of a face's image a pixel covers where the face is so deep.
double texelsOnFace(const Projection& projection, const MeshFace& face, const Texture& image,
                    double depth);

/// How many texels the pixels of a span cover.
class Footprint {
 public:
  /// `mapping` is the span's on the texture in its full size.
  Footprint(const Scene& scene, const Projection& projection, const Span& span,
            const Texture& image, const SpanMapping& mapping);

  /// The texels under a pixel at one of the span's parameters.
  double texelsAt(double parameter) const;
  /// It rises or falls along the span, but not both.
  int mipLevelAt(double parameter) const { return mipLevelOf(texelsAt(parameter)); }

 private:
  double texels_;        ///< under a pixel; of a plane 1 m deep
  bool growsWithDepth_;  ///< as its cube
};

}  // namespace hearth
