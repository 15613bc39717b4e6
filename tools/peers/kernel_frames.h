#pragma once

#include <deque>
#include <vector>

#include "peers/kernel.h"
#include "peers/peer_inputs.h"
#include "render/span_painter.h"

namespace hearth {

/// What a level's shots show, with all geometry worked out for the kernel; except for what hangs in
/// openings.
class KernelFrames {
 public:
  /// Keeps a reference to the level. The size is a multiple of strips and of 4 rows.
  KernelFrames(const PeerLevel& level, ImageSize size);

  /// By the shots.
  const std::vector<KernelFrame>& frames() const { return frames_; }

 private:
  /// What all spans of a frame have in common, by row.
  struct Rows {
    std::vector<double> raySlopes;
    const float* narrowRaySlopes;
    const float* reciprocals;  ///< of ray slopes: depths on flats a metre above the eye
  };

  KernelFrame frameOf(const Camera& camera);
  void addSpans(const SpanPainter& painter, const Span& span, const Rows& rows,
                std::vector<KernelSpan>& spans);
  /// Returns how much the mapping's own parameter changes with them.
  double setParameters(const SpanMapping& mapping, const Texture& image, const Rows& rows,
                       KernelSpan& kernel);
  const float* kept(std::vector<float> values);
  const std::vector<Pixel>& lightOf(SurfaceId surface, const Lightmap& lightmap);

  const PeerLevel& level_;
  std::vector<MipMap> textures_;
  std::vector<Texture> images_;             ///< of sizes that are powers of two
  std::vector<std::vector<Pixel>> lights_;  ///< by SurfaceId, with a border of a texel
  std::deque<std::vector<float>> parameters_;
  std::vector<KernelFrame> frames_;
};

}  // namespace hearth
