#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/scene.h"
#include "render/by_strip.h"
#include "render/camera.h"
#include "render/face_span.h"
#include "render/frustum.h"
#include "render/segment_columns.h"

namespace hearth {

/// The faces of the meshes in view. A mesh is searched behind the windows through which a frame
/// sees it first, and once more in the whole frame if other windows show more of it. Keeps its
/// memory from frame to frame.
class MeshFronts {
 public:
  /// Forgets all meshes, and begins a frame, which shows this part of the picture.
  void begin(const Level& level, const PictureRect& frame);

  /// Finds the faces of a mesh (an index) that may show in a part of the frame, unless they have
  /// been found. Only of parts of its face tree that are in the frustum each face is looked at.
  void find(const Scene& scene, const Projection& projection, std::uint32_t mesh,
            const PictureRect& part);

  /// Those of a mesh that has been found that may show in the columns of a strip, by their numbers
  /// in `frontsOf`, in their order.
  std::span<const std::uint32_t> inStrip(std::uint32_t mesh, int strip) const {
    return foundOf(mesh).byStrip.in(strip);
  }
  /// Those found in this frame, of all meshes.
  std::size_t count() const;
  /// All of a mesh. They stay where they are until the next frame.
  std::span<const FaceFront> frontsOf(std::uint32_t mesh) const { return foundOf(mesh).fronts; }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  struct Found {
    PictureRect part;  ///< of the frame: what was searched
    std::vector<FaceFront> fronts;
    ByStrip byStrip;
  };

  template <typename Visit>
  void visitInFrustum(const Frustum& frustum, const FaceTree& tree, std::span<const MeshFace> faces,
                      Visit&& visit);
  const Found& foundOf(std::uint32_t mesh) const { return found_[placeOf_[mesh]]; }
  static void add(const Mesh& mesh, const MeshFace& face, const Projection& projection,
                  ColumnRange within, std::vector<FaceFront>& fronts);

  PictureRect frame_{};
  std::vector<std::uint8_t> isInFrustum_;  ///< by face of the present mesh; all 0 between meshes
  std::vector<std::uint32_t> placeOf_;     ///< by mesh: an index into found_, or kNone
  std::vector<Found> found_;  ///< and, behind those of this frame, memory of earlier ones
  std::uint32_t count_ = 0;   ///< of this frame, those of a mesh that was found again included
};

}  // namespace hearth
