#include "level/light_source.h"

#include <algorithm>

#include "math/planted_bug.h"

namespace hearth {

namespace {

double curveAt(const std::vector<CurvePoint>& curve, double distance) {
  const auto after =
      std::upper_bound(curve.begin(), curve.end(), distance,
                       [](double d, const CurvePoint& point) { return d < point.distance; });
  if (after == curve.begin()) return curve.front().level;
  const CurvePoint a = *(after - 1);
  if (after == curve.end())
    return planted(PlantedBug::CurveExtrapolated) ? a.level / (1 + distance - a.distance) : a.level;
  const double share = (distance - a.distance) / (after->distance - a.distance);
  return a.level + share * (after->level - a.level);
}

}  // namespace

double LightSource::levelAt(double distance) const {
  return curve.empty() ? intensity / (distance * falloff + 1) : curveAt(curve, distance);
}

}  // namespace hearth
