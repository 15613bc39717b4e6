#pragma once

#include <optional>
#include <string>

#include "image/pixel_rows.h"
#include "viewer/host/walk_host.h"
#include "viewer/overlay/figures_section.h"
#include "viewer/walk/frame_pacer.h"
#include "viewer/walk/frame_painter.h"
#include "viewer/walk/frame_rate.h"
#include "viewer/walk/walk_frame.h"
#include "viewer/walk/walk_panel.h"
#include "viewer/walk/walk_session.h"

namespace hearth {

/// Shows the frames of a walk in its window, with captions and the panel over them.
class WalkScreen {
 public:
  /// All must outlive it, the scene's level and geometry too.
  WalkScreen(const Scene& scene, const Renderer& renderer, const WalkSession& session,
             const WalkHost& host);

  /// Goes on in another version of the level.
  void continueIn(const Scene& scene, const Renderer& renderer);

  const Renderer& renderer() const { return painter_.renderer(); }

  /// Draws the next frame even if it equals the last one.
  void redraw() { isShown_ = false; }
  /// Keeps the next frame as a picture.
  void keepNext();
  /// Sets the progress of a bake, for the panel.
  void setBake(const std::optional<StageProgress>& bake) { figures_.bake = bake; }

  /// Draws a frame, unless it equals the last one or comes too soon. Then it rests until an event
  /// comes or a tick is due. The panel may change settings and view.
  PanelRequests show(WalkFrame& frame, const PanelSubject& subject, WalkPanel& panel,
                     WalkSettings& settings, double now);

 private:
  bool isCovered(const WalkFrame& frame, const WalkPanel& panel) const;
  void drawUncovered(const WalkFrame& frame, double now);
  PanelRequests drawCovered(WalkFrame& frame, const PanelSubject& subject, WalkPanel& panel,
                            WalkSettings& settings, double now);
  void keepScreenshot(const WalkFrame& frame, const PixelRows& picture);
  void drawCaptions(const WalkFrame& frame, const PanelSubject& subject, const WalkPanel& panel,
                    const Preferences& preferences, const PixelRows& picture) const;
  void count(double begin, double end);

  Scene scene_;
  const WalkSession& session_;
  WindowHost& window_;
  Screenshots& screenshots_;
  FramePacer pacer_;
  FramePainter painter_;
  WalkFrame last_;
  bool isShown_ = false;  ///< the last frame; else it must be drawn again
  PixelBuffer memory_;    ///< of pictures that something is drawn over
  bool keepsNext_ = false;
  Figures figures_;
  FrameRate rate_;
  std::string title_;
};

}  // namespace hearth
