#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/scene.h"
#include "render/camera.h"
#include "render/column_run.h"
#include "render/mesh_fronts.h"
#include "render/span_groups.h"

namespace hearth {

/// The memory of MeshSpans, kept from frame to frame.
struct MeshSpansScratch {
  /// The nearest face in a pixel.
  struct Nearest {
    double nearness = 0;               ///< 1 / depth, per metre
    const FaceFront* front = nullptr;  ///< null if there is none
  };

  MeshFronts fronts;
  std::vector<Nearest> nearest;  ///< of a strip, row by row
  std::vector<FaceSpan> narrow;  ///< spans of narrow faces of the present run
};

/// Rows [begin, end) of a column whose rays meet a face.
struct CoveredRows {
  int begin;
  int end;
};

/// Finds the spans of meshes: in each pixel of a run the nearest face between the depths at which
/// the ray enters the sector and leaves it, in its air.
class MeshSpans {
 public:
  /// Columns of the camera's picture.
  MeshSpans(const Scene& scene, const Camera& camera, const Projection& projection,
            ColumnRange columns, MeshSpansScratch& scratch);

  /// Whether any may show in a run. If so, the rest is about this run.
  bool find(const ColumnRun& run, const RunEntry& entry);

  /// Whether they hide a thing (see Mesh::thing) that is so deep in a pixel. Of two at one depth
  /// the later hides the earlier.
  bool hide(std::size_t lane, int row, double depth, std::uint32_t thing) const;

  /// Adds their spans to those found.
  void show(const ColumnRun& run, SpanGroups& found);

 private:
  using Nearest = MeshSpansScratch::Nearest;
  struct Air;

  Air airOf(const ColumnRun& run, const RunEntry& entry, std::size_t lane) const;
  void cover(const ColumnRun& run, const FaceFront& front, std::span<const Air> air);
  void cover(const FaceFront& front, const Air& air, std::size_t lane, CoveredRows rows);
  void reach(int begin, int end);
  void show(const ColumnRun& run, const FaceSpan& span, SpanGroups& found);
  void showNarrow(const ColumnRun& run, SpanGroups& found);
  Nearest& at(std::size_t lane, int row) {
    return scratch_.nearest[static_cast<std::size_t>(row) * Strip::kColumns + lane];
  }
  const Nearest& at(std::size_t lane, int row) const {
    return scratch_.nearest[static_cast<std::size_t>(row) * Strip::kColumns + lane];
  }

  Scene scene_;
  const Projection& projection_;
  MeshSpansScratch& scratch_;
  // Rows of the present run in which something may show:
  int begin_ = 0;
  int end_ = 0;
};

}  // namespace hearth
