#pragma once

#include "level/scene.h"
#include "render/camera.h"
#include "render/span.h"
#include "render/span_mapping.h"
#include "render/texture.h"

namespace hearth {

/// How many texels the pixels of a span cover.
class Footprint {
 public:
  /// `mapping` is the span's on the texture in its full size.
  Footprint(const Scene& scene, const Projection& projection, const Span& span,
            const Texture& image, const SpanMapping& mapping);

  /// The texels under a pixel at one of the span's parameters.
  double texelsAt(double parameter) const;
  /// The mip level whose texels are nearest to a pixel in area: 0 is the full size. It rises or
  /// falls along the span, but not both.
  int mipLevelAt(double parameter) const;

 private:
  double texels_;        ///< under a pixel; of a plane 1 m deep
  bool growsWithDepth_;  ///< as its cube
};

}  // namespace hearth
