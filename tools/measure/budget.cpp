#include "measure/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "settings/measured_pareto_front.h"
#include "settings/settings.h"

namespace hearth {

FittingBake bakeFitting(const Scene& scene, const BakeSettings& authored, double seconds,
                        int threads, const Clock& clock) {
  const MeasuredBake& fastest = measuredBakes().back();
  const double begin = clock();
  (void)bake(scene, fastest.bake.appliedTo(authored), threads);
  const double tried = clock() - begin;
  const double authoredSeconds = std::max(tried, 1e-6) / fastest.cost;
  const MeasuredBake* found = &bakeWithin((seconds - tried) / authoredSeconds);
  // Of a large level, fine texels may be too many for any time.
  while (found != &fastest && mistakeInSettings(scene, found->bake.appliedTo(authored))) ++found;
  return {found->bake.appliedTo(authored), found->cost * authoredSeconds, found->rms};
}

FittingFrame frameFitting(const Renderer& renderer, const Camera& camera, double milliseconds,
                          Workers* workers, const Clock& clock) {
  constexpr int kFrames = 5;
  FrameScratch scratch;
  PixelBuffer memory;
  const PixelRows picture = memory.rows(camera.width, camera.height);
  renderer.draw(camera, LightMode::Both, scratch, picture, workers);  // takes the memory
  std::vector<double> times;
  for (int i = 0; i < kFrames; ++i) {
    const double begin = clock();
    renderer.draw(camera, LightMode::Both, scratch, picture, workers);
    times.push_back(1e3 * (clock() - begin));
  }
  const double exact = std::max(spreadOf(times).median, 1e-6);
  const MeasuredFrame& found = frameWithin(milliseconds / exact);
  return {found.draw, found.cost * exact, found.over2};
}

std::string words(const FittingBake& fitting) {
  return fmt::format("{}: about {:.2g} s, light off by about {:.2g} levels (RMS)",
                     optionsOf(fitting.settings), fitting.seconds, fitting.rms);
}

std::string words(const FittingFrame& fitting) {
  const std::string options = optionsOf(fitting.draw);
  return fmt::format("{}: about {:.2g} ms a frame, {:.2g} % of pixels off by more than 2 levels",
                     options.empty() ? "drawn exactly" : options, fitting.milliseconds,
                     100 * fitting.over2);
}

}  // namespace hearth
