#include "truth/truth_gather.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "math/hash.h"
#include "math/trig.h"
#include "truth/gather_rays.h"

namespace hearth {

namespace {

/// A texture reflects no more than this, so that light in a closed room ends.
constexpr double kMostReflected = 0.95;

/// The standard error of the mean of independent means.
Vec3 errorOf(const std::vector<Vec3>& means, Vec3 mean) {
  const auto count = static_cast<double>(means.size());
  Vec3 squares;
  for (const Vec3 of : means) squares = squares + product(of - mean, of - mean);
  const auto error = [&](double sum) { return std::sqrt(sum / (count * (count - 1))); };
  return {error(squares.x), error(squares.y), error(squares.z)};
}

Vec3 meanOf(const std::vector<Vec3>& values) {
  Vec3 sum;
  for (const Vec3 value : values) sum = sum + value;
  return 1.0 / static_cast<double>(values.size()) * sum;
}

/// All directions alike.
Vec3 anyDirection(double u, double v) {
  const double z = 2 * u - 1;
  const double radius = std::sqrt(1 - z * z);
  const auto [s, c] = sinCosDegrees(360 * v);
  return {radius * c, radius * s, z};
}

}  // namespace

/// SplitMix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
class TruthGather::Random {
 public:
  Random(std::uint64_t seed, Vec3 place) {
    Hash hash;
    hash.addWhole(seed);
    hash.addPoint(place);
    state_ = hash.value();
  }

  /// 0 <= number < 1.
  double unit() {
    state_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

TruthGather::TruthGather(const Level& level, const TruthLight& direct)
    : level_(level), direct_(direct), emission_(level) {
  for (const LightSource& light : level.lights)
    if (light.isSky)
      sky_ =
          light.intensity * Vec3{light.colorFactor(0), light.colorFactor(1), light.colorFactor(2)};
}

TruthGather::Estimate TruthGather::at(const SurfacePoint& place, const Effort& effort) const {
  const SurfacePoint lit = litSideOf(level_, place);
  const GatherRays rays(level_, direct_.meshes(), lit);
  return estimate(rays, effort, Random(effort.seed, lit.point),
                  [&](double u, double v) { return cosineDirection(lit.normal, u, v); });
}

TruthGather::Estimate TruthGather::at(const AirPoint& place, const Effort& effort) const {
  const GatherRays rays(level_, direct_.meshes(), place.point, place.sector);
  return estimate(rays, effort, Random(effort.seed, place.point), anyDirection);
}

/// Means over rays whose directions are `directionAt(u, v)` of u and v evenly spread in 0..1.
template <typename DirectionAt>
TruthGather::Estimate TruthGather::estimate(const GatherRays& rays, const Effort& effort,
                                            Random random, DirectionAt&& directionAt) const {
  std::vector<Vec3> skies;
  std::vector<Vec3> emitted;
  std::vector<Vec3> bounced;
  for (int round = 0; round < effort.rounds; ++round) {
    AreaLight sum;
    for (int i = 0; i < effort.side; ++i)
      for (int j = 0; j < effort.side; ++j) {
        const double u = (i + random.unit()) / effort.side;
        const double v = (j + random.unit()) / effort.side;
        const AreaLight light = arriving(rays, directionAt(u, v), random);
        sum = {sum.sky + light.sky, sum.emitted + light.emitted, sum.bounced + light.bounced};
      }
    const double perRay = 1.0 / (effort.side * effort.side);
    skies.push_back(perRay * sum.sky);
    emitted.push_back(perRay * sum.emitted);
    bounced.push_back(perRay * sum.bounced);
  }
  const AreaLight light{meanOf(skies), meanOf(emitted), meanOf(bounced)};
  return {light,
          {errorOf(skies, light.sky), errorOf(emitted, light.emitted),
           errorOf(bounced, light.bounced)}};
}

/// Along one ray, and along one path from what it meets.
AreaLight TruthGather::arriving(const GatherRays& rays, Vec3 direction, Random& random) const {
  AreaLight light;
  Vec3 reflected{1, 1, 1};  // of what comes in at the end of the path
  std::optional<TruthHit> hit = rays.firstMet(direction);
  for (int bounce = 0; hit; ++bounce) {
    if (isSky(hit->kind)) {
      Vec3& fallen = bounce == 0 ? light.sky : light.bounced;
      fallen = fallen + product(reflected, sky_);
      return light;
    }
    if (!isFront(*hit, direction)) return light;
    Vec3& shone = bounce == 0 ? light.emitted : light.bounced;
    shone = shone + product(reflected, emission_.of(*hit));
    if (bounce == level_.bake.bounces) return light;
    const SurfacePoint place = litSideOf(level_, *hit);
    reflected = product(reflected, reflectanceOf(*hit));
    light.bounced = light.bounced + product(reflected, direct_.at(place));
    direction = cosineDirection(place.normal, random.unit(), random.unit());
    hit = GatherRays(level_, direct_.meshes(), place).firstMet(direction);
  }
  return light;
}

/// Whether a ray meets a side of a surface that has light. Two-sided meshes have the same on both.
bool TruthGather::isFront(const TruthHit& hit, Vec3 direction) const {
  if (hit.mesh && level_.meshOf(*hit.mesh).isTwoSided) return true;
  return dot(litSideOf(level_, hit).normal, direction) < 0;
}

Vec3 TruthGather::reflectanceOf(const TruthHit& hit) const {
  const std::size_t texture = hit.texture->texture.index();
  if (texture >= level_.reflectances.size()) return {};
  const Vec3 most = level_.bake.reflectance * level_.reflectances[texture];
  return {std::min(most.x, kMostReflected), std::min(most.y, kMostReflected),
          std::min(most.z, kMostReflected)};
}

}  // namespace hearth
