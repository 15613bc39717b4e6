#pragma once

#include "image/pixel_rows.h"
#include "level/scene.h"
#include "render/frame_stats.h"
#include "render/renderer.h"
#include "viewer/overlay/automap.h"
#include "viewer/walk/walk_frame.h"

namespace hearth {

/// The workers that help to draw a picture; null if it is small. All of them are at work only after
/// a tenth of a millisecond. That does not pay off for less than twice 64,000 pixels, which take
/// 0.6 ms each.
Workers* workersFor(ImageSize picture, Workers* workers);

/// Draws the frames of a walk, and remembers which sectors they have shown.
class FramePainter {
 public:
  /// All must outlive it, the scene's level and geometry too.
  FramePainter(const Scene& scene, const Renderer& renderer, Workers* workers)
      : scene_(scene), renderer_(&renderer), workers_(workers), seen_(scene.level()) {}

  /// From now on draws another version of the level.
  void continueIn(const Scene& scene, const Renderer& renderer);

  const Renderer& renderer() const { return *renderer_; }

  /// The two phases of a frame, into a picture of the camera's size.
  void find(const WalkFrame& frame);
  void paint(const WalkFrame& frame, const PixelRows& picture);

  /// Remembers what the camera has seen, and the sector of the player.
  void noteSeen(const WalkFrame& frame, SectorId player);

  /// The map, over the picture.
  void drawMap(const WalkFrame& frame, const PixelRows& picture) const;

  /// The counters of the last frame.
  FrameCounters counters(const WalkFrame& frame) const;

 private:
  Scene scene_;
  const Renderer* renderer_;
  Workers* workers_;
  FrameScratch scratch_;
  SeenSectors seen_;
};

}  // namespace hearth
