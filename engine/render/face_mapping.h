#pragma once

#include "level/mesh.h"
#include "render/camera.h"
#include "render/group_mapping.h"

namespace hearth {

/// Maps the columns of a group to the plane of its face and, if there is an image, to that. Depths
/// are those of the group.
void mapFace(const Projection& projection, const SpanGroup& group, const Texture* image,
             GroupMapping& mapping);

/// Of how many of an image's repeats a pixel takes the area, 1 m deep; it grows with the cube of
/// the depth.
double repeatsOfPixel(const Projection& projection, const MeshFace& face);

}  // namespace hearth
