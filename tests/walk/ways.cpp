#include <fmt/format.h>

#include <optional>

#include "math/trig.h"
#include "random_levels/random.h"
#include "random_levels/random_level.h"
#include "walk/body.h"
#include "walk/walker.h"
#include "walk_tests/random_walks.h"
#include "walk_tests/solids.h"
#include "walk_tests/starts.h"

namespace hearth::random_walks {

namespace {

constexpr double kStep = 0.02;      // m, between tries
constexpr double kWay = 0.3;        // m
constexpr double kAhead = 0.25;     // m, that the walker must get
constexpr double kStouter = 0.005;  // m
constexpr int kDirections = 8;

/// A column of the level and the height of the feet in it.
struct Foothold {
  SectorId sector;
  Vec3 feet;
};

class Search {
 public:
  Search(const Scene& scene, const Solids& solids) : scene_(scene), solids_(solids) {}

  bool isOpen(Foothold at, Vec2 direction) const {
    for (double gone = 0; gone < kWay; gone += kStep) {
      const auto next = nextAlong(at, direction);
      if (!next) return false;
      at = *next;
    }
    return true;
  }

 private:
  /// The lowest foothold a little farther, no higher than a step: on the ground, and in the air.
  std::optional<Foothold> nextAlong(const Foothold& from, Vec2 direction) const {
    const Vec2 p = from.feet.xy() + kStep * direction;
    std::optional<Foothold> best;
    for (std::size_t i = 0; i < scene_.level().sectors.size(); ++i)
      for (const double z : {from.feet.z, scene_.level().sectors[i].floor.z}) {
        const bool isHigher = best && z >= best->feet.z;
        if (z < from.feet.z || z > from.feet.z + body_.stepHeight || isHigher) continue;
        if (const auto there = standsAt(from, {p.x, p.y, z})) best = there;
      }
    return best;
  }

  std::optional<Foothold> standsAt(const Foothold& from, Vec3 feet) const {
    const auto sector = solids_.sectorAlong(from.sector, {from.feet.x, from.feet.y, feet.z}, feet);
    if (!sector || !solids_.isFree(*sector, feet, body_, 32)) return std::nullopt;
    const bool isInTheAir = solids_.isFree(*sector, feet - Vec3{0, 0, 2 * kStep}, body_, 32);
    if (isInTheAir) return std::nullopt;
    return Foothold{*sector, feet};
  }

  Body stouter() const {
    Body body = bodyOf(scene_.level(), 0);
    body.radius += kStouter;
    return body;
  }

  Scene scene_;
  const Solids& solids_;
  Body body_ = stouter();
};

/// A walker on the ground, upright, at rest and with room around it.
std::optional<Walker> wander(const Scene& scene, const Solids& solids, Walker walker,
                             random_levels::Random& random) {
  WalkInput input{.forward = 127, .turn = static_cast<int>(random.between(-3000, 3000))};
  for (int i = 0; i < 100; ++i) walker = walked(scene, walker, input);
  for (int i = 0; i < 64; ++i) walker = walked(scene, walker, {});
  const bool isBesideOneWay = solids.isBesideOneWay(walker.feet.xy(), 0.7);
  if (!walker.isOnGround || walker.crouch > 0 || isBesideOneWay) return std::nullopt;
  return walker;
}

}  // namespace

WaysReport& WaysReport::operator+=(const WaysReport& other) {
  if (first.empty()) first = other.first;
  asked += other.asked;
  taken += other.taken;
  return *this;
}

WaysReport tryWays(std::uint64_t seed, const std::filesystem::path& folder, int places) {
  const RandomLevel random = makeRandomLevel(seed);
  std::optional<LoadedLevel> loaded = loadRandom(random, folder);
  if (!loaded) return {1, 0, fmt::format("seed {} does not load", seed)};
  loaded->level.player = Player{};
  const Scene scene = loaded->scene();
  const Solids solids(scene);
  const Search search(scene, solids);
  random_levels::Random choices(seed);
  WaysReport report;
  for (int i = 0; i < places; ++i) {
    const auto start = standIn(scene, solids, choices.pickFrom(random.views));
    const auto walker = start ? wander(scene, solids, *start, choices) : std::nullopt;
    if (!walker) continue;
    for (int d = 0; d < kDirections; ++d) {
      Walker pushed = *walker;
      pushed.angle = choices.real(0, 360);
      const SinCos heading = sinCosDegrees(pushed.angle);
      const Vec2 direction{heading.cos, heading.sin};
      if (!search.isOpen({pushed.sector, pushed.feet}, direction)) continue;
      ++report.asked;
      for (int tick = 0; tick < kTicksPerSecond; ++tick)
        pushed = walked(scene, pushed, {.forward = kFullSpeed});
      const double ahead = dot(pushed.feet.xy() - walker->feet.xy(), direction);
      report.taken += ahead >= kAhead;
      if (ahead < kAhead && report.first.empty())
        report.first =
            fmt::format("seed {}: {:.3g} m from {:.17g},{:.17g},{:.17g} in {} towards {:.17g}",
                        seed, ahead, walker->feet.x, walker->feet.y, walker->feet.z,
                        scene[walker->sector].name, pushed.angle);
    }
  }
  return report;
}

}  // namespace hearth::random_walks
