#pragma once

#include <vector>

#include "measure/frame_times.h"
#include "render/renderer.h"

/// Frames whose two phases are timed apart.
namespace hearth {

/// Of frames, milliseconds of their two phases.
class PhaseTimes {
 public:
  /// Of work that does one after the other.
  template <typename Find, typename Color>
  void add(const Clock& clock, Find&& find, Color&& color) {
    const double begin = clock();
    find();
    const double found = clock();
    color();
    const double end = clock();
    finds_.push_back(1e3 * (found - begin));
    colors_.push_back(1e3 * (end - found));
    frames_.push_back(1e3 * (end - begin));
  }

  void clear() { finds_.clear(), colors_.clear(), frames_.clear(); }

  // Medians.
  double find() const { return spreadOf(finds_).median; }
  double color() const { return spreadOf(colors_).median; }
  double frame() const { return spreadOf(frames_).median; }

 private:
  std::vector<double> finds_;
  std::vector<double> colors_;
  std::vector<double> frames_;
};

/// What frames are drawn in.
class Canvas {
 public:
  explicit Canvas(LightMode mode = LightMode::Both) : mode_(mode) {}

  void find(const Renderer& renderer, const Camera& camera, Workers* workers) {
    renderer.findSpans(camera, scratch_, workers);
  }
  void color(const Renderer& renderer, const Camera& camera, Workers* workers) {
    renderer.paintSpans(camera, mode_, scratch_, memory_.rows(camera.width, camera.height),
                        workers);
  }
  /// One frame, both phases.
  void draw(const Renderer& renderer, const Camera& camera, Workers* workers, PhaseTimes& times,
            const Clock& clock) {
    times.add(
        clock, [&] { find(renderer, camera, workers); }, [&] { color(renderer, camera, workers); });
  }

 private:
  LightMode mode_;
  FrameScratch scratch_;
  PixelBuffer memory_;
};

}  // namespace hearth
