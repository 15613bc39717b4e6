#include "measure/frame_times.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace hearth {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<Camera> camerasOf(const Level& level) {
  std::vector<Camera> cameras;
  for (const Shot& shot : level.shots) cameras.push_back(cameraOf(shot));
  if (cameras.empty() && level.player)
    cameras.push_back({level.player->sector, level.player->eye, level.player->angle});
  return cameras;
}

FrameTimes::FrameTimes(ImageSize size, Workers* workers)
    : workers_(workers),
      bench_{size, workers ? workers->threads() : 1, {}, {}, {}, {}, countersOf({}, {})},
      memory_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

void FrameTimes::draw(const Renderer& renderer, Camera camera, const Clock& clock) {
  camera.width = bench_.size.width;
  camera.height = bench_.size.height;
  const double begin = clock();
  renderer.findSpans(camera, scratch_, workers_);
  const double found = clock();
  renderer.paintSpans(camera, LightMode::Both, scratch_, picture_.rows(camera.width, camera.height),
                      workers_);
  findMilliseconds_.push_back(1e3 * (found - begin));
  colorMilliseconds_.push_back(1e3 * (clock() - found));
  const FrameCounters ofFrame = countersOf(scratch_.found(), scratch_.painted);
  for (std::size_t i = 0; i < ofFrame.size(); ++i) bench_.counters[i].mean += ofFrame[i].mean;
  write(clock);
}

void FrameTimes::begin() {
  bench_.counters = countersOf({}, {});
  findMilliseconds_.clear();
  colorMilliseconds_.clear();
  writeMilliseconds_.clear();
}

FrameBench FrameTimes::result() const {
  FrameBench bench = bench_;
  for (FrameCounter& counter : bench.counters)
    counter.mean /= static_cast<double>(writeMilliseconds_.size());
  std::vector<double> milliseconds;
  for (std::size_t i = 0; i < findMilliseconds_.size(); ++i)
    milliseconds.push_back(findMilliseconds_[i] + colorMilliseconds_[i]);
  bench.milliseconds = spreadOf(std::move(milliseconds));
  bench.findMilliseconds = spreadOf(findMilliseconds_);
  bench.colorMilliseconds = spreadOf(colorMilliseconds_);
  bench.writeMilliseconds = spreadOf(writeMilliseconds_);
  return bench;
}

void FrameTimes::write(const Clock& clock) {
  const double begin = clock();
  std::ranges::fill(memory_, memory_.front() + 1);
  writeMilliseconds_.push_back(1e3 * (clock() - begin));
}

}  // namespace hearth
