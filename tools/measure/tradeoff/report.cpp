#include "measure/tradeoff/report.h"

#include <fmt/format.h>

#include <functional>

#include "measure/tradeoff/pareto_front.h"

namespace hearth {

namespace {

/// By trial, among those that are asked for.
std::vector<bool> frontAmong(const std::vector<TrialResult>& trials,
                             const std::function<bool(const TrialResult&)>& isAsked,
                             const std::function<CostAndError(const TrialResult&)>& pointOf) {
  std::vector<CostAndError> points;
  for (const TrialResult& result : trials)
    if (isAsked(result)) points.push_back(pointOf(result));
  const std::vector<bool> front = onParetoFront(points);
  std::vector<bool> found;
  std::size_t point = 0;
  for (const TrialResult& result : trials) found.push_back(isAsked(result) && front[point++]);
  return found;
}

}  // namespace

std::string_view frontName(const TradeoffReport& report, std::size_t trial) {
  if (report.onBakeFront[trial]) return report.onFrameFront[trial] ? "both" : "bake";
  return report.onFrameFront[trial] ? "frame" : "";
}

std::string_view nameOf(const Trial& trial) {
  return trial.options.empty() ? "(the level's own)" : std::string_view(trial.options);
}

TradeoffReport reportOf(TradeoffReport measured) {
  const Trial& own = measured.trials.front().trial;
  measured.onBakeFront = frontAmong(
      measured.trials, [&](const TrialResult& result) { return result.trial.draw == own.draw; },
      [](const TrialResult& result) {
        return CostAndError{result.bakeSeconds, result.errors.light.rms};
      });
  measured.onFrameFront = frontAmong(
      measured.trials, [&](const TrialResult& result) { return result.trial.bake == own.bake; },
      [](const TrialResult& result) {
        return CostAndError{result.frameMilliseconds, result.errors.picture.rms};
      });
  return measured;
}

std::string tableOf(const TradeoffReport& report) {
  std::string text = fmt::format(
      "{}, {} thread(s), {}; bakes on {} thread(s), frames of {}x{} on one;\n"
      "x: times what the level's own settings take, measured in turn with them\n"
      "errors against truth at {}x{}: of light in levels of 255, of pictures in percent of pixels\n"
      "\n{:<38} {:>7} {:>8} {:>7} {:>8} {:>9} {:>10} {:>10} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} "
      "{:>6} {:>6}  front\n",
      report.machine.processor, report.machine.threads, report.machine.compiler, report.bakeThreads,
      report.frameSize.width, report.frameSize.height, report.truthSize.width,
      report.truthSize.height, "settings", "bake x", "bake s", "frame x", "frame ms", "texels",
      "rays", "bytes", "max", "RMS", "p99", "> 2 %", "> 8 %", "blob", "PSNR", "SSIM");
  for (std::size_t i = 0; i < report.trials.size(); ++i) {
    const TrialResult& of = report.trials[i];
    const auto& [light, picture] = of.errors;
    text += fmt::format(
        "{:<38} {:>7.2f} {:>8.3f} {:>7.2f} {:>8.3f} {:>9} {:>10} {:>10} {:>6.1f} {:>6.2f} {:>6.1f} "
        "{:>6.2f} {:>6.2f} {:>6} {:>6.1f} {:>6.4f}  {}\n",
        nameOf(of.trial), of.bakeCost, of.bakeSeconds, of.frameCost, of.frameMilliseconds,
        of.texels, of.rays, of.bytes, light.max, light.rms, light.p99, 100 * picture.over2,
        100 * picture.over8, picture.largestPatch, picture.psnr, picture.ssim,
        frontName(report, i));
  }
  return text;
}

std::string csvOf(const TradeoffReport& report) {
  std::string text =
      "settings,front,bake_cost,bake_seconds,frame_cost,frame_ms,texels,rays,lightmap_bytes,frame_"
      "pixels,light_max,light_rms,light_p99,picture_rms,over2_share,over8_share,largest_blob,psnr,"
      "ssim\r\n";
  for (std::size_t i = 0; i < report.trials.size(); ++i) {
    const TrialResult& of = report.trials[i];
    const auto& [light, picture] = of.errors;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n",
                        of.trial.options, frontName(report, i), of.bakeCost, of.bakeSeconds,
                        of.frameCost, of.frameMilliseconds, of.texels, of.rays, of.bytes, of.pixels,
                        light.max, light.rms, light.p99, picture.rms, picture.over2, picture.over8,
                        picture.largestPatch, picture.psnr, picture.ssim);
  }
  return text;
}

}  // namespace hearth
