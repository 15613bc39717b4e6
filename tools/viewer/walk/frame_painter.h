#pragma once

#include "image/pixel_rows.h"
#include "level/scene.h"
#include "measure/frame_times.h"
#include "render/renderer.h"
#include "viewer/walk/automap.h"
#include "viewer/walk/walk_frame.h"

namespace hearth {

/// Draws the frames of a walk, and remembers which sectors they have shown.
class FramePainter {
 public:
  /// The scene's level and geometry, and the renderer, must outlive it.
  FramePainter(const Scene& scene, const Renderer& renderer)
      : scene_(scene), renderer_(&renderer), seen_(scene.level()) {}

  /// From now on of another version of the level.
  void goOnIn(const Scene& scene, const Renderer& renderer);

  const Renderer& renderer() const { return *renderer_; }

  /// The two phases of what the camera sees, into a picture of the camera's size.
  void find(const WalkFrame& frame, int threads);
  void paint(const WalkFrame& frame, const PixelRows& picture, int threads);

  /// Remembers what the camera has seen, and the sector of the player.
  void noteSeen(const WalkFrame& frame, SectorId player);

  /// The map, over the picture.
  void drawMap(const WalkFrame& frame, const PixelRows& picture) const;

  /// Of the frame that was drawn last.
  FrameCounters counters(const WalkFrame& frame) const;

 private:
  Scene scene_;
  const Renderer* renderer_;
  FrameScratch scratch_;
  SeenSectors seen_;
};

}  // namespace hearth
