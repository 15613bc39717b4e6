#include "light/gather/area_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "level/locate.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth {

namespace {

/// Around a point, where all steps are halved as often as can be.
constexpr int kMostSlices = 1024;
constexpr double kAround = 2 * std::numbers::pi;
/// Of light of more levels the same part may change as of so many.
constexpr double kFullBrightness = 255;

/// Degrees. None runs along an axis: walls do, and their corners lie in line.
double compassOf(int slice) {
  constexpr double kOffAxis = 0.0573;
  return kOffAxis + 360.0 * slice / kMostSlices;
}

/// Of length 1.
Vec2 directionOf(int slice) {
  const SinCos at = sinCosDegrees(compassOf(slice));
  return {at.cos, at.sin};
}

/// Of the angle whose tangent is a slope.
double sineOf(double slope) {
  return std::abs(slope) == kStraightUp ? std::copysign(1.0, slope)
                                        : slope / std::sqrt(1 + slope * slope);
}

Vec2 unitOf(double slope) {
  const double sine = sineOf(slope);
  return {std::sqrt(std::max(0.0, 1 - sine * sine)), sine};
}

Arc arcOf(SlopeRange slopes) {
  return {unitOf(slopes.from), unitOf(slopes.to),
          hearth::atan(slopes.to) - hearth::atan(slopes.from)};
}

double slopeOf(Vec2 unit) {
  return unit.x > 0 ? unit.y / unit.x : std::copysign(kStraightUp, unit.y);
}

}  // namespace

/// What a receiver makes of directions: the cosine before a surface, integrated over them, or their
/// solid angle at a point of the air. Both for each radian of the compass.
class AreaVisibility::Receiver {
 public:
  /// A surface; `ahead` is the part of its normal in the compass direction.
  Receiver(Vec3 normal, double ahead)
      : before_(slopesBefore(normal, ahead)), ahead_(ahead), up_(normal.z) {}
  /// A point of the air.
  Receiver() : before_{-kStraightUp, kStraightUp}, isAir_(true) {}

  /// The slopes of which it makes anything.
  SlopeRange before() const { return before_; }

  /// Of all directions.
  double ofAll() const { return of(before_); }
  double of(SlopeRange slopes) const {
    const SlopeRange seen = common(slopes, before_);
    if (seen.isEmpty()) return 0;
    return isAir_ ? sineOf(seen.to) - sineOf(seen.from) : upTo(seen.to) - upTo(seen.from);
  }
  /// The same of an arc.
  double of(const Arc& arc) const {
    if (isAir_) return arc.to.y - arc.from.y;
    const auto inFront = [this](Vec2 unit) { return ahead_ * unit.x + up_ * unit.y; };
    // Where the plane cuts the arc it is the slopes that tell.
    constexpr double kRounding = 1e-12;
    if (inFront(arc.from) < -kRounding || inFront(arc.to) < -kRounding)
      return of(SlopeRange{slopeOf(arc.from), slopeOf(arc.to)});
    return (ahead_ * (arc.angle + arc.to.x * arc.to.y - arc.from.x * arc.from.y) +
            up_ * (arc.to.y * arc.to.y - arc.from.y * arc.from.y)) /
           2;
  }

 private:
  /// The integral from level up to a slope, with a the angle, of (ahead cos a + up sin a) cos a.
  double upTo(double slope) const {
    const double sine = sineOf(slope);
    double sum = up_ * sine * sine;
    if (ahead_ != 0) {
      const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
      sum += ahead_ * (hearth::atan(slope) + sine * cosine);
    }
    return sum / 2;
  }

  SlopeRange before_;
  double ahead_ = 0;
  double up_ = 0;
  bool isAir_ = false;
};

/// Between two slices, by their numbers, and where their values begin in `inSlices_`.
struct AreaVisibility::Step {
  int from;
  int to;
  std::size_t atFrom;
  std::size_t atTo;
};

/// A compass direction from a point, and who receives light from there.
struct AreaVisibility::InDirection {
  Vec3 point;
  Vec2 direction;
  std::span<const Receiver> receivers;
};

AreaVisibility::AreaVisibility(const Scene& scene, bool solidMaskedMiddles, GatherAccuracy accuracy)
    : scene_(scene),
      accuracy_(accuracy),
      slice_(scene, solidMaskedMiddles),
      small_(scene, slice_.lights()) {
  for (const std::size_t i : lights()) {
    const LightSource& light = scene.lights()[i];
    changes_.push_back(fractionFor(accuracy.changeOf(light), light));
    worth_.push_back(fractionFor(accuracy.missed, light));
  }
}

/// The integral over the compass of what slices have, as a fraction of the same integral of all
/// that receivers can see, which is `whole`: so what looks the same everywhere is found exactly.
template <typename InSlice>
void AreaVisibility::integrate(const SliceStart& start, InSlice&& inSlice, double whole,
                               std::span<double> fractions, std::int64_t& slices, SectorSet* met) {
  if (lights().empty()) return;
  const std::size_t receivers = fractions.size() / lights().size();
  inSlices_.clear();
  sums_.assign(fractions.size() + receivers, 0);
  narrow_.clear();
  small_.findAround(start, 360.0 / accuracy_.firstSlices, worth_, narrow_, met);
  const int width = kMostSlices / accuracy_.firstSlices;
  atFirst_.clear();
  for (int number = 0; number < kMostSlices; number += width)
    atFirst_.push_back(slice(number, inSlice, slices));
  atFirst_.push_back(atFirst_.front());
  setLimits(fractions.size(), whole);
  for (int i = 0; i < accuracy_.firstSlices; ++i)
    addStep({i * width, (i + 1) * width, atFirst_[static_cast<std::size_t>(i)],
             atFirst_[static_cast<std::size_t>(i) + 1]},
            inSlice, slices);
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    const double all = sums_[fractions.size() + k / lights().size()];
    fractions[k] = all > 0 ? std::max(0.0, sums_[k] / all) : 0;
  }
}

/// By what the first slices have. What receivers could see needs no more slices.
void AreaVisibility::setLimits(std::size_t values, double whole) {
  limits_.assign(values, 0);
  for (const std::size_t first : std::span(atFirst_).first(atFirst_.size() - 1))
    for (std::size_t k = 0; k < values; ++k) limits_[k] += inSlices_[first + k];
  for (std::size_t k = 0; k < values; ++k) {
    const std::size_t i = k % changes_.size();
    const double change = accuracy_.changeOf(scene_.lights()[lights()[i]]);
    limits_[k] = std::max(changes_[i] * whole,
                          change / kFullBrightness * kAround / accuracy_.firstSlices * limits_[k]);
  }
}

template <typename InSlice>
void AreaVisibility::addStep(const Step& step, const InSlice& inSlice, std::int64_t& slices) {
  const int middle = (step.from + step.to) / 2;
  const double half = kAround * (middle - step.from) / kMostSlices;
  const std::size_t atMiddle = slice(middle, inSlice, slices);
  const auto meanOfEnds = [&](std::size_t k) {
    return (inSlices_[step.atFrom + k] + inSlices_[step.atTo + k]) / 2;
  };
  bool changes = false;
  for (std::size_t k = 0; k < limits_.size(); ++k)
    changes |= half * std::abs(inSlices_[atMiddle + k] - meanOfEnds(k)) > limits_[k];
  if ((changes || hidesSmallArea(step)) && middle - step.from > 1) {
    addStep({step.from, middle, step.atFrom, atMiddle}, inSlice, slices);
    addStep({middle, step.to, atMiddle, step.atTo}, inSlice, slices);
    return;
  }
  for (std::size_t k = 0; k < sums_.size(); ++k)
    sums_[k] += half * (inSlices_[atMiddle + k] + meanOfEnds(k));
}

/// Whether something lies in a step that is narrower than it: then its slices may miss it.
bool AreaVisibility::hidesSmallArea(const Step& step) const {
  const double from = compassOf(step.from);
  const double to = compassOf(step.to);
  return std::ranges::any_of(narrow_, [&](const CompassInterval& directions) {
    const double end = directions.from + directions.width;
    const bool meets = (directions.from < to && end > from) || end - 360 > from;
    return meets && directions.width < to - from;
  });
}

/// Returns where its values begin.
template <typename InSlice>
std::size_t AreaVisibility::slice(int number, const InSlice& inSlice, std::int64_t& slices) {
  const std::size_t first = inSlices_.size();
  inSlices_.resize(first + sums_.size());
  ++slices;
  inSlice(directionOf(number), std::span(inSlices_).subspan(first));
  return first;
}

/// The sums are those of all lights, receiver by receiver, and what each receiver can see at all.
void AreaVisibility::addAreas(const InDirection& at, const std::vector<AreaInSlice>& areas,
                              std::span<double> sums) const {
  for (std::size_t k = 0; k < at.receivers.size(); ++k)
    sums[at.receivers.size() * lights().size() + k] = at.receivers[k].ofAll();
  for (const AreaInSlice& area : areas) {
    if (area.light)
      for (std::size_t k = 0; k < at.receivers.size(); ++k)
        sums[k * lights().size() + *area.light] += at.receivers[k].of(area.slopes);
    if (area.surface && irradiance_) addBounced(at, area, sums);
  }
}

void AreaVisibility::addBounced(const InDirection& at, const AreaInSlice& area,
                                std::span<double> sums) const {
  // Radians; slices in the middle of steps included.
  const double betweenSlices = std::numbers::pi / accuracy_.firstSlices;
  // What is seen of a surface is brighter, by and large, than what something hides from the point
  // and the lights alike. So a slice must not take much of what it does not see itself.
  const double width = 0.3 * betweenSlices;
  const std::size_t bounced = *slice_.lights().bounced();
  const std::size_t channels = lights().size() - bounced;
  irradiance_->forEachPart(
      area, at.point, at.direction, arcOf(area.slopes), width, [&](const Arc& part, Vec3 levels) {
        const std::array<double, 3> of{levels.x, levels.y, levels.z};
        for (std::size_t k = 0; k < at.receivers.size(); ++k) {
          const double weight = at.receivers[k].of(part);
          for (std::size_t channel = 0; channel < channels; ++channel)
            sums[k * lights().size() + bounced + channel] += weight * of[channel];
        }
      });
}

void AreaVisibility::findBefore(const SliceStart& start, std::span<const Vec3> normals,
                                std::span<double> fractions, std::int64_t& slices, SectorSet* met) {
  std::vector<Receiver> receivers;
  const auto inSlice = [&](Vec2 direction, std::span<double> sums) {
    receivers.clear();
    SlopeRange beforeAny{kStraightUp, -kStraightUp};
    for (const Vec3 normal : normals) {
      const SlopeRange before =
          receivers.emplace_back(normal, dot(normal.xy(), direction)).before();
      if (before.isEmpty()) continue;
      beforeAny = {std::min(beforeAny.from, before.from), std::max(beforeAny.to, before.to)};
    }
    addAreas({start.point, direction, receivers}, slice_.areas(start, direction, beforeAny, met),
             sums);
  };
  integrate(start, inSlice, std::numbers::pi, fractions, slices, met);
}

void AreaVisibility::findOnSurface(Vec3 point, SectorId sector, Vec3 normal,
                                   std::span<double> fractions, std::int64_t& slices,
                                   SectorSet* met) {
  findBefore({point, sector, kArrival}, {&normal, 1}, fractions, slices, met);
}

/// A point of a mesh may lie in the plane of a wall.
void AreaVisibility::findOnMesh(Vec3 point, SectorId sector, std::span<const Vec3> normals,
                                std::span<double> fractions, std::int64_t& slices, SectorSet* met) {
  const Vec3 inside = nudgedInside(scene_, scene_[sector], point);
  findBefore({inside, sector, kPositionSlack}, normals, fractions, slices, met);
}

void AreaVisibility::findFromAir(Vec3 point, SectorId sector, std::span<double> fractions,
                                 std::int64_t& slices) {
  const Receiver air;
  const SliceStart start{point, sector, kArrival};
  const auto inSlice = [&](Vec2 direction, std::span<double> sums) {
    addAreas({point, direction, {&air, 1}}, slice_.areas(start, direction, air.before(), nullptr),
             sums);
  };
  integrate(start, inSlice, 4 * std::numbers::pi, fractions, slices, nullptr);
}

}  // namespace hearth
