#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/scene.h"
#include "render/camera.h"
#include "render/column_run.h"
#include "render/face_cover.h"
#include "render/mesh_fronts.h"
#include "render/nearest_faces.h"
#include "render/picture_rect.h"
#include "render/span_groups.h"

namespace hearth {

/// The memory of MeshSpans, kept from frame to frame.
struct MeshSpansScratch {
  MeshFronts fronts;
  std::vector<double> raySlopes;  ///< by row
  // Of the present run:
  NearestFaces nearest;
  std::vector<const FaceFront*> faces;  ///< by their number in `nearest`, less 1
  std::vector<FaceSpan> narrow;         ///< spans of narrow faces
};

/// Finds the spans of meshes: in each pixel of a run the nearest face between the depths at which
/// the ray enters the sector and leaves it, in its air.
class MeshSpans {
 public:
  /// Columns of the camera's picture.
  MeshSpans(const Scene& scene, const Camera& camera, const Projection& projection,
            ColumnRange columns, MeshSpansScratch& scratch);

  /// Whether any may show in a run, one of those that are seen through these windows. If so, the
  /// rest is about this run.
  bool find(const ColumnRun& run, const RunEntry& entry, const PictureRect& windows);

  /// Whether they hide a thing (see Mesh::thing) that is so deep in a pixel. Of two at one depth
  /// the later hides the earlier.
  bool hide(std::size_t lane, int row, double depth, std::uint32_t thing) const;

  /// Adds their spans to those found.
  void show(const ColumnRun& run, SpanGroups& found);

 private:
  AirRays raysOf(const ColumnRun& run, const RunEntry& entry) const;
  /// The nearest face in a pixel, or null.
  const FaceFront* frontAt(std::size_t lane, int row) const;
  void addSpan(const ColumnRun& run, const FaceSpan& span, SpanGroups& found);
  void addNarrow(const ColumnRun& run, SpanGroups& found);

  Scene scene_;
  const Projection& projection_;
  MeshSpansScratch& scratch_;
  CoverFace cover_ = coverFace();
};

}  // namespace hearth
