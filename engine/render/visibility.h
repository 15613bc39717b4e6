#pragma once

#include "level/scene.h"
#include "level/sprite_index.h"
#include "render/camera.h"
#include "render/span_groups.h"
#include "render/visibility_scratch.h"

namespace hearth {

/// The first phase of a frame: finds which surface shows in which rows of some of its columns,
/// which begin with a strip. No column depends on the others. The camera's sector must contain its
/// eye; `projection` has moved the eye off the walls. The result lies in `scratch` until the next
/// search.
const VisibleSpans& findVisibleSpans(const Scene& scene, const SpriteIndex& sprites,
                                     const Camera& camera, const Projection& projection,
                                     ColumnRange columns, VisibilityScratch& scratch);
/// The same for all columns, without sprites.
inline const VisibleSpans& findVisibleSpans(const Scene& scene, const Camera& camera,
                                            const Projection& projection,
                                            VisibilityScratch& scratch) {
  return findVisibleSpans(scene, SpriteIndex(), camera, projection, {0, camera.width}, scratch);
}

}  // namespace hearth
