#include "measure/tradeoff/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "text/html.h"

namespace hearth {

namespace {

// In units of the SVG; browsers fit it to the page.
constexpr double kWidth = 640;
constexpr double kHeight = 400;
constexpr double kLeft = 60;
constexpr double kRight = 20;
constexpr double kTop = 20;
constexpr double kBottom = 50;

/// A range of values that a side of the plot stands for, and where it has marks.
struct Axis {
  double least;
  double most;
  std::vector<double> marks;
};

/// From the mark below the least value to the one above the most: 1, 2 and 5 times powers of ten.
Axis logAxis(double least, double most) {
  std::vector<double> marks;
  const double power = std::floor(std::log10(least));
  for (double p = power; p <= power + 20; ++p)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double mark = digit * std::pow(10.0, p);
      if (mark <= least) marks.clear();
      marks.push_back(mark);
      if (mark >= most && marks.size() > 1) return {marks.front(), marks.back(), marks};
    }
  return {least, most, {}};
}

/// From 0 on, in at most ten steps of 1, 2 or 5 times a power of ten.
Axis evenAxis(double most) {
  double step = std::pow(10.0, std::floor(std::log10(most)) - 1);
  while (most > 10 * step) step *= most > 50 * step ? 10 : (most > 20 * step ? 5 : 2);
  Axis axis{0, 0, {}};
  for (int i = 0; axis.most < most; ++i) axis.marks.push_back(axis.most = i * step);
  return axis;
}

class Plot {
 public:
  Plot(Axis x, Axis y) : x_(std::move(x)), y_(std::move(y)) {}

  double column(double x) const {
    const double fraction = std::log(x / x_.least) / std::log(x_.most / x_.least);
    return kLeft + fraction * (kWidth - kLeft - kRight);
  }
  double row(double y) const {
    return kHeight - kBottom - y / y_.most * (kHeight - kTop - kBottom);
  }

  std::string axes(const std::string& xTitle, const std::string& yTitle) const {
    std::string svg;
    for (const double mark : x_.marks)
      svg += fmt::format(
          "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/>"
          "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g}</text>\n",
          column(mark), kTop, kHeight - kBottom, kHeight - kBottom + 18, mark);
    for (const double mark : y_.marks)
      svg += fmt::format(
          "<path class=\"grid\" d=\"M{1} {0:.1f}H{2}\"/>"
          "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>\n",
          row(mark), kLeft, kWidth - kRight, kLeft - 6, row(mark) + 4, mark);
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                       (kLeft + kWidth - kRight) / 2, kHeight - 10, escaped(xTitle));
    svg += fmt::format(
        "<text transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        (kTop + kHeight - kBottom) / 2, escaped(yTitle));
    return svg;
  }

  /// Upwards from the point, so that those of neighbours do not meet.
  std::string label(const PlotPoint& p) const {
    return fmt::format(
        "<text class=\"label\" transform=\"translate({:.1f} {:.1f}) rotate(-50)\">{}</text>\n",
        column(p.x) + 5, row(p.y) - 8, escaped(p.name));
  }

  std::string point(const PlotPoint& p) const {
    return fmt::format(
        "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"><title>{}: {:.3g}, "
        "{:.3g}</title></circle>\n",
        p.isOnFront ? "front" : "other", column(p.x), row(p.y), escaped(p.name), p.x, p.y);
  }

 private:
  Axis x_;
  Axis y_;
};

}  // namespace

std::string plotOf(std::vector<PlotPoint> points, const std::string& xTitle,
                   const std::string& yTitle) {
  constexpr double kLeast = 1e-6;  // of what has a logarithm
  double least = INFINITY;
  double most = kLeast;
  double highest = kLeast;
  for (PlotPoint& p : points) {
    p.x = std::max(p.x, kLeast);
    least = std::min(least, p.x);
    most = std::max(most, p.x);
    highest = std::max(highest, p.y);
  }
  if (points.empty()) return {};
  const Plot plot(logAxis(least, most), evenAxis(highest));
  std::ranges::sort(points, {}, &PlotPoint::x);

  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\">\n", kWidth, kHeight);
  svg += plot.axes(xTitle, yTitle);
  std::string line;
  for (const PlotPoint& p : points)
    if (p.isOnFront)
      line +=
          fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", plot.column(p.x), plot.row(p.y));
  svg += fmt::format("<path class=\"line\" d=\"{}\"/>\n", line);
  for (const PlotPoint& p : points) svg += plot.point(p);
  for (const PlotPoint& p : points)
    if (p.isOnFront) svg += plot.label(p);
  return svg + "</svg>\n";
}

}  // namespace hearth
