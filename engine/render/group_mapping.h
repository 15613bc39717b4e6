#pragma once

#include <cstddef>

#include "level/scene.h"
#include "light/lit_mesh.h"
#include "light/lit_surface.h"
#include "render/camera.h"
#include "render/lanes.h"
#include "render/span_groups.h"
#include "render/span_mapping.h"
#include "render/texture.h"

namespace hearth {

/// Where the light of a surface lies on its lightmap. Nowhere on skies and sprites, on what does
/// not show, and where nobody asks.
struct LitPlaces {
  const LitSurface* surface = nullptr;
  const LitMesh* mesh = nullptr;  ///< or this one

  explicit operator bool() const { return surface || mesh; }
};

/// A linear function for each column.
struct LaneAffine {
  LaneDoubles atZero;
  LaneDoubles per;
};

/// A texel coordinate of an image for each column (see ImageAxis).
struct LaneImageAxis {
  LaneAffine place;
  LaneDoubles origin;
  double texelsPerPlace = 1;
  double offset = 0;
};

/// The mappings of a group's spans (see SpanMapping). Columns without a span have one, too: on
/// planes their own, else that of another column. `u` and `v` are 0 without an image, `s` and `t`
/// without light.
struct GroupMapping {
  bool isPlane = false;
  bool isLevel = false;  ///< a plane that does not rise
  bool isSky = false;
  bool isOfFace = false;  ///< of a mesh: all coordinates may change down a column
  double height = 0;      ///< of planes
  LaneDoubles rise;       ///< of planes
  LaneDoubles depth;
  LaneImageAxis u;
  LaneImageAxis v;
  LaneAffine s;
  LaneAffine t;

  SpanMapping of(std::size_t lane) const;
};

/// `image` is null where only the place on the lightmap counts.
GroupMapping mappingOf(const Scene& scene, const Projection& projection, const SpanGroup& group,
                       const Texture* image, const LitPlaces& lit);

/// The same group on another size of the same image.
GroupMapping onImage(GroupMapping mapping, const Texture& from, const Texture& to);

/// The mapping of one span.
SpanMapping mappingOf(const Scene& scene, const Projection& projection, const Span& span,
                      const Texture* image, const LitPlaces& lit);

}  // namespace hearth
