#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "level/mesh.h"
#include "peers/peer_inputs.h"

namespace hearth {

/// A model in a room, to be drawn by Hearth and by a rasteriser of triangles.
struct ModelScene {
  const PeerLevel* level;
  Camera camera;
  std::vector<MeshFace> faces;  ///< of the model, then of the room; texture by TextureId
};

/// A torus of 99,856 triangles in a room of six sides, all with images. It covers about half of the
/// picture, 1920x1080 pixels.
tl::expected<ModelScene, std::string> makeModelScene(PeerInputs& inputs);

}  // namespace hearth
