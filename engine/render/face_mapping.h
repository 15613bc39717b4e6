#pragma once

#include <array>

#include "level/level.h"
#include "light/lit_mesh.h"
#include "render/camera.h"
#include "render/group_mapping.h"

namespace hearth {

/// Where the corners of a face lie on a lightmap.
using FacePlaces = std::array<Vec2, 3>;

/// Of a face of a level on the lightmap of its mesh; null without a mesh.
const FacePlaces* placesOf(const Level& level, const LitMesh* mesh, const MeshFace& face);

/// Maps the columns of a group to the plane of its face and, where these are, to an image and to
/// `places`. Depths are those of the group.
void mapFace(const Projection& projection, const SpanGroup& group, const Texture* image,
             const FacePlaces* places, GroupMapping& mapping);

/// Of how many of an image's repeats a pixel takes the area, 1 m deep; it grows with the cube of
/// the depth.
double repeatsOfPixel(const Projection& projection, const MeshFace& face);

}  // namespace hearth
