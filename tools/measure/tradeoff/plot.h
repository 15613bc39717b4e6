#pragma once

#include <string>
#include <vector>

namespace hearth {

/// A point of a plot, both coordinates >= 0.
struct PlotPoint {
  double x = 0;
  double y = 0;
  bool isOnFront = false;
  std::string name;
};

/// A plot of points, the front among them joined by a line, as SVG. The scale of x is logarithmic:
/// costs differ by factors.
std::string plotOf(std::vector<PlotPoint> points, const std::string& xTitle,
                   const std::string& yTitle);

}  // namespace hearth
