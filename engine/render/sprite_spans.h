#pragma once

#include <vector>

#include "level/scene.h"
#include "level/sprite_index.h"
#include "render/camera.h"
#include "render/column_run.h"
#include "render/lanes.h"
#include "render/mesh_spans.h"
#include "render/span_groups.h"
#include "render/sprite_fronts.h"

namespace hearth {

/// What a sprite shows in some columns.
struct SpritePart {
  const SpriteFront* front;
  double nearest;  ///< the least depth, of what stands
  LaneRowRanges rows;
  LaneDoubles depth;     ///< metres; where it lies, those at which it ends
  LaneDoubles fraction;  ///< of the way from the image's left edge to the right; of what stands
};

/// The memory of SpriteSpans, kept from frame to frame.
struct SpriteSpansScratch {
  SpriteFronts fronts;
  // Of the present columns:
  std::vector<SpritePart> standing;
  std::vector<const SpritePart*> nearToFar;  ///< these, sorted
  std::vector<const SpriteFront*> lying;     ///< by rising distance from the height of the eye
};

/// Finds the spans of sprites: where they are between the depths at which a ray enters a sector and
/// leaves it, in its air. So no depth of a pixel has to be kept.
class SpriteSpans {
 public:
  /// Columns of the camera's picture.
  SpriteSpans(const Scene& scene, const SpriteIndex& index, const Camera& camera,
              const Projection& projection, ColumnRange columns, SpriteSpansScratch& scratch);

  /// Adds the spans of a run, near to far, to those found: where they are before `meshes`, those of
  /// the same run, if any show.
  void show(const ColumnRun& run, const RunEntry& entry, const MeshSpans* meshes,
            SpanGroups& found);

 private:
  struct Look;

  std::span<const SpriteFront> frontsIn(SectorId sector);
  void add(const Look& look, const SpritePart& part, const LaneRowRanges& rows,
           SpanGroups& found) const;
  double depthAt(const SpritePart& part, std::size_t lane, int row) const;
  void findStanding(const Look& look, const SpriteFront& front);
  bool isBeforeEntry(const Look& look, const SpriteFront& front) const;
  LaneRowRanges standingRows(const Look& look, const SpriteFront& front, LaneSet lanes,
                             const LaneDoubles& depth) const;
  SpritePart lyingPart(const Look& look, const SpriteFront& front) const;
  void lie(const Look& look, std::size_t lane, SpriteFront::Depths between, SpritePart& part) const;
  bool sortStanding();
  void showLane(const Look& look, std::size_t lane, SpanGroups& found);
  void putLaterFirst(std::size_t lane);
  void showLying(const Look& look, std::size_t lane, SpriteFront::Depths between,
                 SpanGroups& found) const;

  Scene scene_;
  const SpriteIndex& index_;
  const Camera& camera_;
  const Projection& projection_;
  ColumnRange columns_;
  SpriteSpansScratch& scratch_;
  const StandingKernels& kernels_ = standingKernels();
};

}  // namespace hearth
