#include "level/light_source.h"

#include <algorithm>
#include <limits>

namespace hearth {

namespace {

double curveAt(const std::vector<CurvePoint>& curve, double distance) {
  const auto after =
      std::upper_bound(curve.begin(), curve.end(), distance,
                       [](double d, const CurvePoint& point) { return d < point.distance; });
  if (after == curve.begin()) return curve.front().level;
  const CurvePoint a = *(after - 1);
  if (after == curve.end()) return a.level;
  const double fraction = (distance - a.distance) / (after->distance - a.distance);
  return a.level + fraction * (after->level - a.level);
}

double reachOf(const std::vector<CurvePoint>& curve, double level) {
  const auto isMore = [level](const CurvePoint& point) { return point.level > level; };
  const auto last = std::find_if(curve.rbegin(), curve.rend(), isMore);
  if (last == curve.rend()) return 0;
  if (last == curve.rbegin()) return std::numeric_limits<double>::infinity();
  const CurvePoint a = *last;
  const CurvePoint b = *(last - 1);
  if (b.level == level) return b.distance;
  return a.distance + (a.level - level) / (a.level - b.level) * (b.distance - a.distance);
}

}  // namespace

double LightSource::brightnessAt(double distance) const {
  return curve.empty() ? intensity / (distance * falloff + 1) : curveAt(curve, distance);
}

double LightSource::brightnessAt(Vec3 point) const {
  if (!hasPlace()) return intensity;
  const Vec3 offset = point - position;
  const double level = brightnessAt(length(offset));
  return spot ? level * spot->factor(offset) : level;
}

double LightSource::greatestFactor() const {
  return std::max({colorFactor(0), colorFactor(1), colorFactor(2)});
}

double LightSource::reach(double level) const {
  const double most = greatestFactor();
  if (most == 0) return 0;
  const double white = level / most;
  if (!curve.empty()) return reachOf(curve, white);
  if (intensity <= white) return 0;
  return white == 0 || falloff == 0 ? std::numeric_limits<double>::infinity()
                                    : (intensity / white - 1) / falloff;
}

}  // namespace hearth
