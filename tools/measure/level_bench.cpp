#include "measure/level_bench.h"

#include <array>

#include "render/renderer.h"

namespace hearth {

namespace {

constexpr std::array<ImageSize, 3> kSizes{{{320, 200}, {640, 400}, {1920, 1080}}};

/// One thread, and all that there are.
std::vector<int> threadCounts(int threads) {
  return threads == 1 ? std::vector{1} : std::vector{1, threads};
}

}  // namespace

BenchReport measure(const LoadedLevel& loaded, const BakeSettings& settings,
                    const DrawSettings& drawSettings, int threads, int repeats,
                    const Clock& clock) {
  const Scene scene = loaded.scene();
  const std::vector<Camera> cameras = camerasOf(loaded.level);
  const BakedLight light = bake(scene, settings, threads);
  const Renderer renderer(scene, loaded.textures, light, drawSettings);

  std::vector<FrameTimes> frames;
  std::vector<std::vector<double>> bakeSeconds;
  Workers workers(threads);
  for (const int count : threadCounts(threads)) {
    for (const ImageSize size : kSizes) frames.emplace_back(size, count == 1 ? nullptr : &workers);
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
      (void)bake(scene, settings, threadCounts(threads)[k]);
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
