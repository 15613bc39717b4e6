#include "walk_tests/random_walks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "level/locate.h"
#include "level/moved_geometry.h"
#include "level/thing_bodies.h"
#include "load/load.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "movers/random_movers.h"
#include "random_levels/random.h"
#include "random_levels/random_level.h"
#include "walk/body.h"
#include "walk/moving_level.h"
#include "walk/recording.h"
#include "walk/walk_clock.h"
#include "walk/walker.h"
#include "walk_tests/solid_things.h"
#include "walk_tests/solids.h"
#include "walk_tests/starting_movers.h"
#include "walk_tests/starts.h"

namespace hearth::random_walks {

namespace {

using random_levels::Random;

constexpr double kEdgeInset = 4 * kSkin;
constexpr double kTick = 1.0 / kTicksPerSecond;

/// Bodies of all sizes: a player's, a child's, one without breadth, a stout one without a step,
/// and one so small that a tick takes it past whole sectors.
constexpr std::array<Player, 5> kBodies{{
    {{}, {}, 0, 1.8, 1.6, 0.3, 0.4},
    {{}, {}, 0, 0.9, 0.8, 0.15, 0.2},
    {{}, {}, 0, 1.2, 1.2, 0, 0.3},
    {{}, {}, 0, 1.0, 0.5, 0.45, 0},
    {{}, {}, 0, 0.0018, 0.0016, 0.0003, 0.0004},
}};

bool isIn(const Scene& scene, SectorId sector, Vec3 p) {
  return contains(scene, scene[sector], p, kPositionSlack);
}

/// Inputs that last, as a player's do: now and then some of them change.
WalkInput changed(WalkInput input, bool uses, Random& random) {
  input.toggleFlight = random.chance(0.002);
  input.use = uses && random.chance(0.05);
  if (!random.chance(0.05)) return input;
  const auto fraction = [&] { return static_cast<int>(random.between(-1, 1) * 127); };
  input.forward = random.chance(0.7) ? 127 : fraction();
  input.right = fraction();
  input.up = fraction();
  input.turn = random.chance(0.5) ? 0 : static_cast<int>(random.between(-4000, 4000));
  input.run = random.chance(0.5);
  input.jump = random.chance(0.2);
  input.crouch = random.chance(0.2);
  return input;
}

class Walk {
 public:
  Walk(const Scene& authored, const std::vector<SolidThing>& things, const RecordedStart& start,
       std::uint64_t seed, int lines)
      : authored_(authored),
        moving_(authored),
        between_(authored.level(), authored.geometry()),
        scene_(moving_.scene()),
        solids_(scene_),
        things_(things),
        walker_(*walkerAtStart(scene_, start)),
        recording_{start, {}, {}},
        inputs_(seed),
        checks_(seed),
        lines_(lines) {}

  Report run(int ticks) {
    report_.walks = 1;
    WalkInput input;
    for (int tick = 0; tick < ticks && report_.failures == 0; ++tick) {
      input = changed(input, !moving_.movers().empty(), inputs_);
      const Walker before = walker_;
      advance(input);
      check(before, input);
      if (report_.failures > 0)
        report_.first = fmt::format(
            "{} in tick {}: {} {:.17g},{:.17g},{:.17g} from {} {:.17g},{:.17g},{:.17g} speed "
            "{:.4g},{:.4g},{:.4g} angle {:.17g} crouch {} flying {} ground {}",
            fault_, tick, scene_[walker_.sector].name, walker_.feet.x, walker_.feet.y,
            walker_.feet.z, scene_[before.sector].name, before.feet.x, before.feet.y, before.feet.z,
            before.velocity.x, before.velocity.y, before.velocity.z, before.angle, before.crouch,
            before.isFlying, before.isOnGround);
    }
    if (!moving_.movers().empty() && report_.failures == 0) replay();
    return report_;
  }

 private:
  void advance(const WalkInput& input) {
    recording_.inputs.push_back(input);
    sharesBefore_.assign(moving_.shares().begin(), moving_.shares().end());
    const std::vector<MoverState> before(moving_.movers().begin(), moving_.movers().end());
    const Walker walker = moving_.ticked(walker_, input);
    if (!std::ranges::equal(sharesBefore_, moving_.shares())) {
      ++report_.whileMoving;
      solids_ = Solids(scene_);
    }
    for (std::size_t i = 0; i < before.size(); ++i)
      report_.turnedBack += before[i].direction > 0 && moving_.movers()[i].direction < 0;
    walker_ = walker;
  }

  void fail(std::string fault) {
    if (report_.failures == 0) fault_ = std::move(fault);
    report_.failures = 1;
  }
  void expect(bool holds, const char* fault) {
    if (!holds) fail(fault);
  }

  void check(const Walker& before, const WalkInput& input) {
    count(before);
    expect(isIn(scene_, walker_.sector, walker_.feet), "the sector does not contain the feet");
    const Eye eye = eyeOf(scene_, walker_);
    expect(isIn(scene_, eye.sector, eye.point), "the sector does not contain the eye");
    expectEyeBetween(before);
    expectPhysics(before, input);
    expectFree();
    expectOutOfThings();
  }

  void expectEyeBetween(const Walker& before) {
    const double fraction = checks_.unit();
    // In a tick movers move first and then the walker, in a frame both at once. Where it crosses
    // into another sector, a flat can be past an eye that is nearer than it moves.
    const Body body = bodyOf(scene_.level(), walker_.crouch);
    const double movement = movedBy();
    if (movement > 0 && movement >= std::min(body.eyeHeight, body.height - body.eyeHeight)) return;
    for (std::size_t i = 0; i < sharesBefore_.size(); ++i)
      if (const double share = std::lerp(sharesBefore_[i], moving_.shares()[i], fraction);
          share != between_.shares()[i])
        between_.setShare(i, share);
    const Scene scene = between_.scene();
    const Eye eye = eyeBetween(scene, before, walker_, fraction);
    expect(isIn(scene, eye.sector, eye.point), "an eye between ticks is nowhere");
  }

  /// From its text, whatever the frames: few long ones, which make up for a part of their time
  /// only, and many short ones.
  void replay() {
    recording_.end = recordedState(scene_, walker_);
    const auto read = readRecording(writeRecording(recording_));
    expect(read && *read == recording_, "the recording does not come back from its text");
    if (report_.failures > 0) return;
    for (const double framesPerSecond : {1.0, 1000.0}) {
      MovingLevel moving(authored_);
      Walker walker = *walkerAtStart(moving.scene(), read->start);
      WalkClock clock;
      std::size_t tick = 0;
      for (int frame = 0; tick < read->inputs.size(); ++frame)
        for (int due = clock.advance(frame / framesPerSecond).ticks;
             due > 0 && tick < read->inputs.size(); --due)
          walker = moving.ticked(walker, read->inputs[tick++]);
      expect(recordedState(moving.scene(), walker) == read->end &&
                 std::ranges::equal(moving.movers(), moving_.movers()),
             "a replay ends elsewhere");
    }
    ++report_.replays;
    if (report_.failures > 0) report_.first = fault_;
  }

  void count(const Walker& before) {
    ++report_.ticks;
    report_.onGround += walker_.isOnGround;
    report_.inFlight += walker_.isFlying;
    if (walker_.sector == before.sector) return;
    ++report_.crossings;
    const Sector& from = scene_[before.sector];
    const Sector& to = scene_[walker_.sector];
    report_.throughFlats +=
        (from.floor.flatPortal && from.floor.flatPortal == to.ceiling.flatPortal) ||
        (from.ceiling.flatPortal && from.ceiling.flatPortal == to.floor.flatPortal);
  }

  /// No farther than the greater of the speeds before and wanted takes the walker, plus what
  /// steps and slopes lift or lower it by.
  void expectPhysics(const Walker& before, const WalkInput& input) {
    const Body body = bodyOf(scene_.level(), walker_.crouch);
    const double wanted = walker_.isFlying ? (input.run ? 10 : 5) : (input.run ? 5 : 2.5);
    const double speed = std::max(length(before.velocity.xy()), wanted);
    const Vec3 moved = walker_.feet - before.feet;
    const double reach = speed * kTick + kEdgeInset;
    expect(length(moved.xy()) <= reach, "faster than physics allows");
    const double parts = std::clamp(std::ceil(2 * reach / std::max(body.radius, 1e-9)), 1.0, 16.0);
    const double lift = parts * body.stepHeight + reach + movedBy();
    const double rise = std::max({before.velocity.z, walker_.isFlying ? wanted : 3.3});
    const double fall = std::max({-before.velocity.z, walker_.isFlying ? wanted : 0.0});
    expect(moved.z <= rise * kTick + lift, "higher than physics allows");
    expect(-moved.z <= fall * kTick + 9.81 * kTick * kTick + lift, "deeper than physics allows");
  }

  /// The metres by which flats have moved in this tick.
  double movedBy() const {
    double metres = 0;
    for (std::size_t i = 0; i < sharesBefore_.size(); ++i)
      metres += std::abs(between_.heightAt(i, moving_.shares()[i]) -
                         between_.heightAt(i, sharesBefore_[i]));
    return metres;
  }

  void expectOutOfThings() {
    const Body body = bodyOf(scene_.level(), walker_.crouch);
    for (const SolidThing& thing : things_) meet(thing, body);
  }

  /// They overlap where the air between their axes is free, and leads to the thing's sector.
  void meet(const SolidThing& thing, const Body& body) {
    const double between = apart(thing, walker_.feet.xy(), body.radius);
    if (between > kEdgeInset || walker_.feet.z > thing.zTop + kEdgeInset) return;
    if (walker_.feet.z >= thing.zTop - kEdgeInset) {
      report_.onThings += walker_.isOnGround;
      return;
    }
    const double zLow = std::max(walker_.feet.z, thing.position.z);
    const double zHigh = std::min(walker_.feet.z + body.height, thing.zTop);
    if (zHigh - zLow <= 2 * kEdgeInset) return;
    if (between >= -kEdgeInset) {
      ++report_.againstThings;
      return;
    }
    const double z = (zLow + zHigh) / 2;
    const Vec3 axis{walker_.feet.x, walker_.feet.y, z};
    const Vec3 other{thing.position.x, thing.position.y, z};
    if (solids_.isBesideOneWay(axis.xy(), length(other.xy() - axis.xy()) + body.radius)) return;
    const SectorId sector = solids_.inColumn(walker_.sector, axis);
    if (solids_.sectorAlong(sector, axis, other) == solids_.inColumn(thing.sector, other))
      fail(fmt::format(
          "{:.3g} m in the thing at {:.6g},{:.6g},{:.6g} of radius {:.3g}, up to {:.6g}", -between,
          other.x, other.y, thing.position.z, thing.radius, thing.zTop));
  }

  /// A few lines out of the axis, at the feet, the head and between.
  void expectFree() {
    const Body body = bodyOf(scene_.level(), walker_.crouch);
    const bool isHeld = !solids_.isBesideOneWay(walker_.feet.xy(), body.radius);
    isClear_ = isHeld && (isClear_ || solids_.isFree(walker_.sector, walker_.feet, body, 90));
    if (!isClear_) {
      ++report_.besideOneWay;
      return;
    }
    for (int i = 0; i < lines_; ++i) {
      const double fraction = i % 3 == 0 ? 0 : i % 3 == 1 ? 1 : checks_.unit();
      const double z = walker_.feet.z + kEdgeInset + fraction * (body.height - 2 * kEdgeInset);
      const Vec3 axis{walker_.feet.x, walker_.feet.y, z};
      const SectorId sector = solids_.inColumn(walker_.sector, axis);
      expect(isIn(scene_, sector, axis), "the axis is in solid");
      const SinCos turn = sinCosDegrees(checks_.real(0, 360));
      const double free = solids_.freeAlong(sector, axis, {turn.cos, turn.sin}, body.radius);
      if (free < body.radius - kEdgeInset)
        fail(fmt::format(
            "in solid {:.3g} of {} m off the axis at height {:.6g} of {} towards {:.5g},{:.5g}",
            free, body.radius, z - walker_.feet.z, body.height, turn.cos, turn.sin));
    }
  }

  Scene authored_;
  MovingLevel moving_;
  MovedGeometry between_;  ///< at the time of a frame
  Scene scene_;            ///< as it moves
  Solids solids_;
  const std::vector<SolidThing>& things_;
  Walker walker_;
  std::vector<double> sharesBefore_;  ///< of the movers, a tick ago
  Recording recording_;
  Random inputs_;
  Random checks_;  // apart, so that other checks see the same walk
  int lines_;
  bool isClear_ = true;  // not in what the walker entered through a one-way wall
  Report report_;
  std::string fault_;
};

bool isInAny(const std::vector<SolidThing>& things, const Walker& walker, const Body& body) {
  return std::ranges::any_of(things,
                             [&](const SolidThing& thing) { return isIn(thing, walker, body); });
}

Report failed(std::string why) { return {.failures = 1, .first = std::move(why)}; }

/// Walks from some views of a level, whose player becomes another one each time.
Report walkFrom(const std::vector<RandomView>& views, LoadedLevel& loaded,
                const std::vector<SolidThing>& things, const Effort& effort, std::uint64_t seed) {
  const Scene scene = loaded.scene();
  const Solids solids(scene);
  Random choices(seed);
  Report report;
  for (int i = 0; i < effort.walks; ++i) {
    loaded.level.player = kBodies[static_cast<std::size_t>(i) % kBodies.size()];
    std::optional<Walker> start;
    const RandomView* view = nullptr;
    for (int attempt = 0; !start && attempt < 8; ++attempt) {
      view = &choices.pickFrom(views);
      start = standIn(scene, solids, *view);
    }
    if (start && isInAny(things, *start, bodyOf(loaded.level, start->crouch))) start.reset();
    if (!start) {
      ++report.stuck;
      continue;
    }
    const RecordedStart recorded{view->sector, {view->x, view->y, view->z}, view->angle, 0};
    Report one = Walk(scene, things, recorded, choices.next(), effort.lines).run(effort.ticks);
    if (!one.first.empty()) one.first = fmt::format("seed {} walk {}: {}", seed, i, one.first);
    report += one;
  }
  return report;
}

void makeOnlyTheLevelSolid(LoadedLevel& loaded) {
  for (Mesh& mesh : loaded.level.meshes) mesh.isSolid = false;
  addBodies(loaded.level, loaded.geometry);
}

}  // namespace

std::optional<SectorId> sectorNamed(const Level& level, const std::string& name) {
  for (std::size_t i = 0; i < level.sectors.size(); ++i)
    if (level.sectors[i].name == name) return SectorId(i);
  return std::nullopt;
}

std::optional<LoadedLevel> loadRandom(const RandomLevel& random,
                                      const std::filesystem::path& folder) {
  if (!writeRandomLevel(folder, random)) return std::nullopt;
  LoadResult result = loadLevel(folder / (random.name + ".json"));
  std::filesystem::remove(folder / (random.name + ".json"));
  std::filesystem::remove(folder / (random.name + ".lights.json"));
  if (!result.loaded) return std::nullopt;
  makeOnlyTheLevelSolid(*result.loaded);
  return std::move(result.loaded);
}

std::optional<Walker> standIn(const Scene& scene, const Solids& solids, const RandomView& view) {
  const auto sector = sectorNamed(scene.level(), view.sector);
  if (!sector || !isIn(scene, *sector, {view.x, view.y, view.z})) return std::nullopt;
  const Walker walker = walkerAt(scene, *sector, {view.x, view.y, view.z}, view.angle, 0);
  const Body body = bodyOf(scene.level(), walker.crouch);
  if (!solids.isFree(walker.sector, walker.feet, body, 720)) return std::nullopt;
  return walker;
}

Report& Report::operator+=(const Report& other) {
  if (first.empty()) first = other.first;
  walks += other.walks;
  ticks += other.ticks;
  failures += other.failures;
  onGround += other.onGround;
  inFlight += other.inFlight;
  crossings += other.crossings;
  throughFlats += other.throughFlats;
  stuck += other.stuck;
  onThings += other.onThings;
  againstThings += other.againstThings;
  besideOneWay += other.besideOneWay;
  whileMoving += other.whileMoving;
  turnedBack += other.turnedBack;
  replays += other.replays;
  return *this;
}

Report walkRandomLevel(std::uint64_t seed, const std::filesystem::path& folder,
                       const Effort& effort, int solidThings) {
  const RandomLevel random = makeRandomLevel(seed);
  std::optional<LoadedLevel> loaded = loadRandom(random, folder);
  if (!loaded) return failed(fmt::format("seed {} does not load", seed));
  const std::vector<SolidThing> things = addSolidThings(*loaded, random, solidThings);
  return walkFrom(random.views, *loaded, things, effort, seed);
}

Report walkMovingLevel(std::uint64_t seed, const std::filesystem::path& folder,
                       const Effort& effort) {
  const movers::RandomMovers random(seed, folder);
  std::optional<LoadedLevel> loaded = random.loaded().result.loaded;
  if (!loaded) return {};
  makeOnlyTheLevelSolid(*loaded);
  Random whims(seed);
  letStart(loaded->level, whims);
  return walkFrom(makeRandomLevel(seed).views, *loaded, {}, effort, seed);
}

std::string inWords(const Report& report) {
  return fmt::format(
      "{} walks, {} ticks: {} on the ground, {} in flight, {} into another sector, {} of these "
      "through flat portals; {} on solid things, {} against their sides; {} beside one-way walls, "
      "where solids are not looked for; {} while something moves, which turned back {} times; {} "
      "walks replayed; {} starts without room; {} walks failed\n{}",
      report.walks, report.ticks, report.onGround, report.inFlight, report.crossings,
      report.throughFlats, report.onThings, report.againstThings, report.besideOneWay,
      report.whileMoving, report.turnedBack, report.replays, report.stuck, report.failures,
      report.first);
}

}  // namespace hearth::random_walks
