#include "measure/tradeoff/page.h"

#include <fmt/format.h>

#include <ostream>
#include <string_view>
#include <vector>

#include "files/replace_file.h"
#include "measure/tradeoff/pareto_front.h"
#include "measure/tradeoff/plot.h"
#include "text/html.h"

namespace hearth {

namespace {

constexpr std::string_view kStyle = R"css(.plots, table { --front: light-dark(#b3400c, #ff9a4d); }
.plots { display: grid; gap: 2rem 4rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); margin: 5rem 4rem 1.5rem 0; }
svg { display: block; width: 100%; height: auto; overflow: visible; }
svg text { font-size: 12px; fill: currentColor; }
svg .label { font-size: 10px; }
.grid { stroke: currentColor; stroke-opacity: .15; fill: none; }
.line { stroke: var(--front); stroke-width: 1.5; fill: none; }
circle.front { fill: var(--front); }
circle.other { fill: currentColor; fill-opacity: .35; }
.table { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .15rem .6rem; text-align: right; white-space: nowrap; }
th { position: sticky; top: 0; background: Canvas; vertical-align: bottom; }
td:first-child, th:first-child, td:last-child, th:last-child { text-align: left; }
tr + tr { border-top: 1px solid color-mix(in srgb, currentColor 15%, transparent); }
tr.front { color: var(--front); }
)css";

constexpr std::string_view kColumns =
    "<table>\n<tr><th>settings</th><th>bake, x</th><th>s</th><th>frame, "
    "x</th><th>ms</th><th>texels</th><th>rays</th>"
    "<th>light, bytes</th><th>light: max</th><th>RMS</th><th>p99</th><th>over 2, %</th>"
    "<th>over 8, %</th><th>largest blob</th><th>PSNR, dB</th><th>SSIM</th><th>front</th></tr>\n";

std::string row(const TradeoffReport& report, std::size_t i) {
  const TrialResult& of = report.trials[i];
  const auto& [light, picture] = of.errors;
  const std::string_view front = frontName(report, i);
  return fmt::format(
      "<tr{}><td>{}</td><td>{:.2f}</td><td>{:.3f}</td><td>{:.2f}</td><td>{:.3f}</td><td>{}</"
      "td><td>{}</td><td>{}</td>"
      "<td>{:.1f}</td><td>{:.2f}</td><td>{:.1f}</td><td>{:.2f}</td><td>{:.2f}</td><td>{}</td>"
      "<td>{:.1f}</td><td>{:.4f}</td><td>{}</td></tr>\n",
      front.empty() ? "" : " class=\"front\"", escaped(nameOf(of.trial)), of.bakeCost,
      of.bakeSeconds, of.frameCost, of.frameMilliseconds, of.texels, of.rays, of.bytes, light.max,
      light.rms, light.p99, 100 * picture.over2, 100 * picture.over8, picture.largestPatch,
      picture.psnr, picture.ssim, front);
}

std::string figure(std::string_view caption, const std::string& plot) {
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", plot, caption);
}

std::string bakePlot(const TradeoffReport& report) {
  std::vector<PlotPoint> points;
  for (std::size_t i = 0; i < report.trials.size(); ++i) {
    const TrialResult& of = report.trials[i];
    if (of.trial.draw == report.trials.front().trial.draw)
      points.push_back({of.bakeSeconds, of.errors.light.rms, report.onBakeFront[i],
                        std::string(nameOf(of.trial))});
  }
  return plotOf(points, "seconds to bake", "RMS error of light, levels");
}

std::string framePlot(const TradeoffReport& report) {
  std::vector<PlotPoint> points;
  for (std::size_t i = 0; i < report.trials.size(); ++i) {
    const TrialResult& of = report.trials[i];
    if (of.trial.bake == report.trials.front().trial.bake)
      points.push_back({of.frameMilliseconds, of.errors.picture.rms, report.onFrameFront[i],
                        std::string(nameOf(of.trial))});
  }
  return plotOf(points, "milliseconds for a frame", "RMS error of pictures, levels");
}

std::string pageOf(const TradeoffReport& report) {
  std::string html = pageBegin("hearth tradeoff", kStyle);
  html += fmt::format("<h1>What settings cost, and how far off they are: {}</h1>\n",
                      escaped(report.level));
  html += fmt::format(
      "<p>{}, {} thread(s), {}. Bakes on {} thread(s), frames of {}x{} on one; x: times what the "
      "level's own settings take, measured in turn with them. Errors against truth, in the level's "
      "shots at {}x{}: of light in levels of 255, of pictures by pixels that "
      "are off by more than 2 or 8 levels.</p>\n<div class=\"plots\">\n",
      escaped(report.machine.processor), report.machine.threads, escaped(report.machine.compiler),
      report.bakeThreads, report.frameSize.width, report.frameSize.height, report.truthSize.width,
      report.truthSize.height);
  html +=
      figure("Bakes, drawn as the level's own. On the line: nothing is both shorter and nearer.",
             bakePlot(report));
  html += figure("Frames of the level's own bake.", framePlot(report));
  html += "</div>\n<div class=\"table\">\n";
  html += kColumns;
  for (std::size_t i = 0; i < report.trials.size(); ++i) html += row(report, i);
  html += "</table>\n</div>\n";
  return html.append(kPageEnd);
}

constexpr std::string_view kAreaColumns =
    "<table>\n<tr><th>settings</th><th>bake, x</th><th>s</th><th>slices</th><th>places</th>"
    "<th>RMS</th><th>max</th><th>over 4, %</th></tr>\n";

std::string row(const AreaTrial& of) {
  return fmt::format(
      "<tr><td>{}</td><td>{:.2f}</td><td>{:.3f}</td><td>{}</td><td>{}</td><td>{:.2f}</td>"
      "<td>{:.1f}</td><td>{:.2f}</td></tr>\n",
      nameOf(of), of.cost, of.seconds, of.slices, of.places, of.rms, of.most, 100 * farShareOf(of));
}

/// Of gather errors: what fewer bounces leave out is far more than how far these are off.
std::string areaPlot(const std::vector<AreaTrial>& trials) {
  std::vector<CostAndError> all;
  std::vector<std::string> names;
  for (const AreaTrial& of : trials) {
    if (of.setting.of != AreaSetting::Of::GatherError) continue;
    all.push_back({of.seconds, of.rms});
    names.push_back(nameOf(of));
  }
  const std::vector<bool> front = onParetoFront(all);
  std::vector<PlotPoint> points;
  for (std::size_t i = 0; i < all.size(); ++i)
    points.push_back({all[i].cost, all[i].error, front[i], names[i]});
  return plotOf(points, "seconds to bake", "RMS error of light of areas, levels");
}

std::string pageOf(const AreaReport& report) {
  std::string html = pageBegin("hearth tradeoff --areas", kStyle);
  html += fmt::format("<h1>What light of areas costs, and how far off it is: {}</h1>\n",
                      escaped(report.level));
  html += fmt::format(
      "<p>{}, {} thread(s), {}. Bakes on {} thread(s), all light included, with {} bounce(s); x: "
      "times what the level's own settings take, measured in turn with them. The light of the "
      "sky, of surfaces that shine, and that bounces is held against truth at the same texels; "
      "what fewer bounces leave out counts as error.</p>\n<div class=\"plots\">\n",
      escaped(report.machine.processor), report.machine.threads, escaped(report.machine.compiler),
      report.threads, report.bounces);
  html += figure("On the line: nothing is both shorter and nearer.", areaPlot(report.trials));
  html += "</div>\n<div class=\"table\">\n";
  html += kAreaColumns;
  for (const AreaTrial& of : report.trials) html += row(of);
  html += "</table>\n</div>\n";
  return html.append(kPageEnd);
}

template <typename Report>
tl::expected<void, std::string> writePage(const std::filesystem::path& path, const Report& report) {
  return replaceFile(path, [&](std::ostream& out) {
    out << pageOf(report);
    return out.good();
  });
}

}  // namespace

tl::expected<void, std::string> writeTradeoffPage(const std::filesystem::path& path,
                                                  const TradeoffReport& report) {
  return writePage(path, report);
}

tl::expected<void, std::string> writeTradeoffPage(const std::filesystem::path& path,
                                                  const AreaReport& report) {
  return writePage(path, report);
}

}  // namespace hearth
