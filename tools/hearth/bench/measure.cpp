#include "hearth/bench/measure.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "render/renderer.h"

namespace hearth {

namespace {

constexpr std::array<PictureSize, 3> kSizes{{{320, 200}, {640, 400}, {1920, 1080}}};

std::vector<Camera> camerasOf(const Level& level) {
  std::vector<Camera> cameras;
  for (const Shot& shot : level.shots) cameras.push_back(cameraOf(shot));
  if (cameras.empty() && level.player)
    cameras.push_back({level.player->sector, level.player->eye, level.player->angle});
  return cameras;
}

/// One thread, and all that there are.
std::vector<int> threadCounts(int threads) {
  return threads == 1 ? std::vector{1} : std::vector{1, threads};
}

FrameCounters countersOf(const FrameStats& found, const PaintStats& painted) {
  const auto mean = [](auto count) { return static_cast<double>(count); };
  return {{{"viewports", mean(found.viewports)},
           {"flatPortals", mean(found.flatPortals)},
           {"windows", mean(found.windows)},
           {"segments", mean(found.segments)},
           {"wallColumns", mean(found.wallColumns)},
           {"stackColumns", mean(found.stackColumns)},
           {"slopeColumns", mean(found.slopeColumns)},
           {"spans", mean(found.spans)},
           {"slopeSpans", mean(painted.slopeSpans)},
           {"lightmapSpans", mean(painted.lightmapSpans)},
           {"coloredSpans", mean(painted.coloredSpans)},
           {"lightmapPixels", mean(painted.lightmapPixels)},
           {"lightLookups", mean(painted.lightLookups)},
           {"pixels", mean(painted.pixels)}}};
}

/// Frames of one size on so many threads, with all times that were taken.
class FrameTimes {
 public:
  FrameTimes(PictureSize size, int threads)
      : bench_{size, threads, {}, {}, countersOf({}, {})},
        memory_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

  void draw(const Renderer& renderer, Camera camera, const Clock& clock) {
    camera.width = bench_.size.width;
    camera.height = bench_.size.height;
    const double begin = clock();
    renderer.draw(camera, LightMode::Both, scratch_, picture_, bench_.threads);
    milliseconds_.push_back(1e3 * (clock() - begin));
    const FrameCounters ofFrame = countersOf(scratch_.visibility.found.stats, scratch_.painted);
    for (std::size_t i = 0; i < ofFrame.size(); ++i) bench_.counters[i].mean += ofFrame[i].mean;
    write(clock);
  }

  /// Forgets the times and the work so far, but not the memory.
  void begin() {
    bench_.counters = countersOf({}, {});
    milliseconds_.clear();
    writeMilliseconds_.clear();
  }

  FrameBench result() const {
    FrameBench bench = bench_;
    for (FrameCounter& counter : bench.counters)
      counter.mean /= static_cast<double>(milliseconds_.size());
    bench.milliseconds = spreadOf(milliseconds_);
    bench.writeMilliseconds = spreadOf(writeMilliseconds_);
    return bench;
  }

 private:
  void write(const Clock& clock) {
    const double begin = clock();
    std::ranges::fill(memory_, memory_.front() + 1);
    writeMilliseconds_.push_back(1e3 * (clock() - begin));
  }

  FrameBench bench_;
  std::vector<double> milliseconds_;
  std::vector<double> writeMilliseconds_;
  std::vector<std::uint32_t> memory_;
  FrameScratch scratch_;
  Image picture_;
};

}  // namespace

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Spread spreadOf(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    const auto index = std::ceil(share * static_cast<double>(values.size())) - 1;
    return values[static_cast<std::size_t>(std::max(0.0, index))];
  };
  return {at(0.5), at(0.95)};
}

BenchReport measure(const LoadedLevel& loaded, const BakeSettings& settings,
                    const DrawSettings& drawSettings, int threads, int repeats,
                    const Clock& clock) {
  const Level& level = loaded.level;
  const std::vector<Camera> cameras = camerasOf(level);
  const BakedLight light = bake(level, settings, threads);
  const Renderer renderer(level, loaded.textures, light, drawSettings);

  std::vector<FrameTimes> frames;
  std::vector<std::vector<double>> bakeSeconds;
  for (const int count : threadCounts(threads)) {
    for (const PictureSize size : kSizes) frames.emplace_back(size, count);
    bakeSeconds.emplace_back();
  }
  const auto drawAll = [&] {
    for (const Camera& camera : cameras)
      for (FrameTimes& of : frames) of.draw(renderer, camera, clock);
  };
  drawAll();
  for (FrameTimes& of : frames) of.begin();
  for (int i = 0; i < repeats; ++i) {
    drawAll();
    for (std::size_t k = 0; k < bakeSeconds.size(); ++k) {
      const double begin = clock();
      (void)bake(level, settings, threadCounts(threads)[k]);
      bakeSeconds[k].push_back(clock() - begin);
    }
  }

  BenchReport report{repeats, settings, drawSettings, {}, {}, light.stats};
  if (!cameras.empty())
    for (const FrameTimes& of : frames) report.frames.push_back(of.result());
  for (std::size_t k = 0; k < bakeSeconds.size(); ++k)
    report.bakes.push_back({threadCounts(threads)[k], spreadOf(bakeSeconds[k])});
  for (const LightCost& cost : light.lightCosts) report.texelLightTests += cost.samples;
  return report;
}

}  // namespace hearth
