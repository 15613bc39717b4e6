#pragma once

#include <functional>
#include <memory>

#include "image/pixel_rows.h"
#include "viewer/input/event.h"
#include "viewer/overlay/triangle_painter.h"

struct ImGuiContext;

namespace hearth {

/// How many times the smallest letters, 13 pixels high, those of a picture are: whole times, so
/// that they stay sharp.
int letterScale(int pictureHeight);

/// A panel at the right of a picture, made of Dear ImGui's widgets. Needs no window: it takes
/// events from anywhere and draws on the CPU.
class Overlay {
 public:
  Overlay();

  bool isOpen() const { return isOpen_; }
  /// Opens or closes. What is held in it is let go of.
  void toggle();

  /// Returns whether the event is for the panel alone: all of the mouse, and what is typed into a
  /// field. Positions are in pixels of the picture. Takes nothing while closed.
  bool handle(const Event& event);

  /// What it shows has changed, though it took no event.
  void refresh() { framesLeft_ = kFramesToSettle; }

  /// Whether it may look otherwise than when it was drawn last; `now` in seconds.
  bool isStale(double now) const;

  /// How many pixels of a picture's width are left of the panel, as it was drawn last.
  int widthBeside(int pictureWidth) const;

  /// Whether a list or a field of the panel has opened over the picture.
  bool hasPopup() const { return hasPopup_; }

  /// Draws the panel with what `sections` puts into it by calls of ImGui. Only while open.
  void draw(double now, const std::function<void()>& sections, const PixelRows& picture);

 private:
  void begin(int scale);
  bool handleKey(const KeyEvent& key);
  void handleButton(const MouseButtonEvent& button);
  void release();

  std::shared_ptr<ImGuiContext> context_;  ///< made anew with each scale
  TrianglePainter painter_;
  GlyphAtlas atlas_;
  int scale_ = 1;  ///< of letters and widgets
  bool isOpen_ = false;
  int panelWidth_ = 0;  ///< pixels
  double drawn_ = 0;    ///< when that was, in seconds
  bool hasPopup_ = false;

  /// ImGui answers an event a frame later, and lays a panel out anew in the one after that.
  static constexpr int kFramesToSettle = 3;
  int framesLeft_ = 0;  ///< until what has happened is settled

  static constexpr int kButtons = 3;
  bool isHeld_[kButtons] = {};
  bool wasPressed_[kButtons] = {};  ///< since the last frame, even if let go again
};

}  // namespace hearth
