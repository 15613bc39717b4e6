#include "way_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "walk/moving_level.h"

namespace hearth::test {

namespace {

constexpr double kMetresPerTick = 5.0 / kTicksPerSecond;  // of one who runs
constexpr double kHaste = 1.5;  // a metre ahead counts for so many behind: quick, not shortest
constexpr std::size_t kMaxVisits = 100000;
constexpr double kCellsPerMetre = 2;
constexpr double kNear = 2;  // metres from a mover to where its height tells places apart
constexpr int kHeadings = 16;
constexpr int kStretch = 10;  // ticks in one direction
constexpr int kLongestJump = 96;
constexpr int kLongestWait = 10 * kTicksPerSecond;
constexpr int kJumpCosts = 32;  // ticks more than it takes: who can, walks

struct Visit {
  Walker walker;
  std::vector<MoverState> movers;
  std::size_t from = 0;           ///< index of the visit before
  std::vector<WalkInput> inputs;  ///< from there
  int cost = 0;                   ///< ticks
};

/// One way to go on, in a direction to which the walker turns first.
struct Action {
  enum class Kind { Run, Jump, Use, Wait } kind;
  double angle;  ///< degrees
};

bool isStarted(const MoverState& state) { return state.direction > 0 || state.share >= 1; }

bool isLoop(const Mover& mover) { return mover.trigger == MoverTrigger::Loop; }

/// The input that turns to there, and does nothing else.
WalkInput turnTo(double angle, const Walker& walker) {
  return {.turn =
              static_cast<int>(std::lround(1000 * std::remainder(angle - walker.angle, 360.0)))};
}

double angleOf(Vec2 v) { return std::atan2(v.y, v.x) * (180 / std::numbers::pi); }

bool isNear(const Level& level, const Mover& mover, Vec2 p) {
  return std::ranges::any_of(mover.sectors, [&](SectorId sector) {
    const Box& box = level[sector].box;
    return touch(box, {p - Vec2{kNear, kNear}, p + Vec2{kNear, kNear}});
  });
}

/// What tells places apart besides their coordinates: of movers nearby, roughly how they stand, and
/// of others that never return, whether they were started.
std::vector<int> marksOf(const Level& level, const Walker& walker,
                         std::span<const MoverState> states) {
  std::vector<int> marks;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Mover& mover = level.movers[i];
    const bool stays = !mover.wait && !isLoop(mover);
    if (isNear(level, mover, walker.feet.xy()))
      marks.push_back(10 * static_cast<int>(8 * states[i].share) + states[i].direction);
    else
      marks.push_back(stays && isStarted(states[i]) ? 1 : 0);
  }
  return marks;
}

/// A* from where a walker and the movers of a level are.
class Search {
 public:
  using IsReached = std::function<bool(const Walker& before, const Walker& after)>;

  Search(MovingLevel& moving, const Distances& distances, bool jumps, IsReached isReached)
      : moving_(moving), distances_(distances), jumps_(jumps), isReached_(std::move(isReached)) {}

  /// The inputs, after which the level and the walker are as they leave them. The error is the
  /// least distance that was left.
  tl::expected<std::vector<WalkInput>, double> find(Walker& walker) {
    add({walker, statesNow(), 0, {}, 0});
    while (!open_.empty() && visits_.size() < kMaxVisits) {
      const std::size_t next = open_.top().second;
      open_.pop();
      for (const Action& action : actionsFrom(visits_[next])) {
        std::optional<Visit> visit = acted(next, action);
        if (isFound_) {
          walker = visit->walker;
          return inputsTo(*visit);
        }
        if (visit) add(std::move(*visit));
      }
    }
    return tl::unexpected(nearest_);
  }

 private:
  /// Sector, place and marks.
  using Cell = std::tuple<SectorId, int, int, int, std::vector<int>>;
  using Open = std::pair<double, std::size_t>;  ///< metres of the way through a visit

  const Level& level() const { return moving_.level(); }
  std::vector<MoverState> statesNow() const {
    return {moving_.movers().begin(), moving_.movers().end()};
  }

  Cell cellOf(const Visit& visit) const {
    const auto index = [](double metres) {
      return static_cast<int>(std::floor(kCellsPerMetre * metres));
    };
    const Vec3 feet = visit.walker.feet;
    return {visit.walker.sector, index(feet.x), index(feet.y), index(feet.z),
            marksOf(level(), visit.walker, visit.movers)};
  }

  void add(Visit visit) {
    const double ahead = distances_.from({visit.walker.sector, visit.walker.feet.xy()});
    if (ahead == std::numeric_limits<double>::infinity()) return;
    const auto [cell, isNew] = costs_.emplace(cellOf(visit), visit.cost);
    if (!isNew && cell->second <= visit.cost) return;
    cell->second = visit.cost;
    nearest_ = std::min(nearest_, ahead);
    open_.emplace(visit.cost * kMetresPerTick + kHaste * ahead, visits_.size());
    visits_.push_back(std::move(visit));
  }

  std::vector<Action> actionsFrom(const Visit& visit) const {
    std::vector<Action> actions;
    for (int i = 0; i < kHeadings; ++i) {
      actions.push_back({Action::Kind::Run, 360.0 / kHeadings * i});
      if (jumps_ && visit.walker.isOnGround)
        actions.push_back({Action::Kind::Jump, 360.0 / kHeadings * i});
    }
    addUses(visit, actions);
    if (mayWait(visit)) actions.push_back({Action::Kind::Wait, visit.walker.angle});
    return actions;
  }

  void addUses(const Visit& visit, std::vector<Action>& actions) const {
    const Vec2 feet = visit.walker.feet.xy();
    for (const MoverSwitch& each : level().switches) {
      if (each.isCrossed || isStarted(visit.movers[each.mover])) continue;
      const Segment& segment = level()[each.segment];
      const Vec2 to = nearestOf(segment, feet) - feet;
      if (to != Vec2{} && length(to) < MovingLevel::kUseReach)
        actions.push_back({Action::Kind::Use, angleOf(to)});
    }
  }

  bool mayWait(const Visit& visit) const {
    for (std::size_t i = 0; i < visit.movers.size(); ++i) {
      const MoverState& state = visit.movers[i];
      if (state.direction == 0 && state.share == 0) continue;
      if (isNear(level(), level().movers[i], visit.walker.feet.xy())) return true;
    }
    return false;
  }

  /// None if it does nothing.
  std::optional<Visit> acted(std::size_t from, const Action& action) {
    moving_.setMovers(visits_[from].movers);
    Visit visit{visits_[from].walker, {}, from, {}, visits_[from].cost};
    const WalkInput turn = turnTo(action.angle, visit.walker);
    const bool isDone = action.kind == Action::Kind::Run    ? run(visit, turn)
                        : action.kind == Action::Kind::Jump ? jump(visit, turn)
                        : action.kind == Action::Kind::Use  ? use(visit, turn)
                                                            : wait(visit);
    if (!isDone && !isFound_) return std::nullopt;
    visit.movers = statesNow();
    return visit;
  }

  /// Whether the way goes on from there.
  bool tick(Visit& visit, const WalkInput& input) {
    const Walker before = visit.walker;
    visit.walker = moving_.ticked(before, input);
    visit.inputs.push_back(input);
    ++visit.cost;
    isFound_ = isReached_(before, visit.walker);
    return !isFound_;
  }

  bool run(Visit& visit, WalkInput input) {
    input.forward = kFullSpeed;
    input.run = true;
    for (int i = 0; i < kStretch && tick(visit, input); ++i) input.turn = 0;
    return true;
  }

  bool jump(Visit& visit, WalkInput input) {
    input.forward = kFullSpeed;
    input.run = input.jump = true;
    visit.cost += kJumpCosts;
    for (int i = 0; i < kLongestJump && tick(visit, input); ++i) {
      input.turn = 0;
      input.jump = false;
      if (visit.walker.isOnGround) break;
    }
    return true;
  }

  /// Whether that starts a mover.
  bool use(Visit& visit, const WalkInput& turn) {
    if (!tick(visit, turn) || !tick(visit, {.use = true})) return true;
    const std::vector<MoverState>& before = visits_[visit.from].movers;
    for (std::size_t i = 0; i < before.size(); ++i)
      if (!isStarted(before[i]) && isStarted(moving_.movers()[i])) return true;
    return false;
  }

  /// Until a mover nearby has come on.
  bool wait(Visit& visit) {
    const auto before = marksOf(level(), visit.walker, visits_[visit.from].movers);
    for (int i = 0; i < kLongestWait && tick(visit, {}); ++i)
      if (marksOf(level(), visit.walker, moving_.movers()) != before) return true;
    return false;
  }

  std::vector<WalkInput> inputsTo(const Visit& last) const {
    std::vector<const Visit*> visits{&last};
    while (visits.back()->from != 0) visits.push_back(&visits_[visits.back()->from]);
    std::vector<WalkInput> inputs;
    for (auto it = visits.rbegin(); it != visits.rend(); ++it)
      inputs.insert(inputs.end(), (*it)->inputs.begin(), (*it)->inputs.end());
    return inputs;
  }

  MovingLevel& moving_;
  const Distances& distances_;
  bool jumps_;
  IsReached isReached_;
  bool isFound_ = false;  ///< by the last tick
  double nearest_ = std::numeric_limits<double>::infinity();
  std::vector<Visit> visits_;
  std::map<Cell, int> costs_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

/// A walk that comes from one aim to the next.
class Way {
 public:
  Way(const Scene& authored, const Walker& start, double leap)
      : level_(authored.level()),
        passages_(level_, level_.player->stepHeight + leap, level_.player->height),
        leaps_(leap > 0),
        moving_(authored),
        walker_(start),
        ends_(level_.movers.size(), MoverEnds::Authored) {
    for (std::size_t i = 0; i < ends_.size(); ++i)
      if (isLoop(level_.movers[i])) ends_[i] = MoverEnds::Both;
  }

  tl::expected<std::vector<WalkInput>, std::string> to(const Aim& aim) {
    const auto movers = moversOnTheWay(level_, passages_, aim.spots);
    if (!movers) return tl::unexpected(std::string("the heights forbid it"));
    for (const std::size_t mover : *movers) {
      const auto isThere = [&](const Walker&, const Walker&) {
        return isStarted(moving_.movers()[mover]);
      };
      if (!isThere(walker_, walker_) && !goOn({spotsToStart(level_, mover), isThere}))
        return tl::unexpected(missed(level_.movers[mover].name));
      ends_[mover] = MoverEnds::Both;
    }
    if (!goOn(aim)) return tl::unexpected(missed("the aim"));
    return inputs_;
  }

 private:
  bool goOn(const Aim& aim) {
    const Distances distances(level_, passages_, aim.spots, ends_);
    const auto inputs = Search(moving_, distances, leaps_, aim.isReached).find(walker_);
    if (inputs)
      inputs_.insert(inputs_.end(), inputs->begin(), inputs->end());
    else
      missing_ = inputs.error();
    return inputs.has_value();
  }

  std::string missed(std::string_view what) const {
    return fmt::format("{} is not reached from {:.2f} {:.2f} in {}: {:.2f} m are missing", what,
                       walker_.feet.x, walker_.feet.y, level_[walker_.sector].name, missing_);
  }

  const Level& level_;
  Passages passages_;
  bool leaps_;
  MovingLevel moving_;
  Walker walker_;
  std::vector<MoverEnds> ends_;  ///< by mover: both once it was started, and of a loop
  std::vector<WalkInput> inputs_;
  double missing_ = 0;
};

}  // namespace

tl::expected<std::vector<WalkInput>, std::string> wayThroughMovers(const Scene& authored,
                                                                   const Walker& start, double leap,
                                                                   const Aim& aim) {
  return Way(authored, start, leap).to(aim);
}

}  // namespace hearth::test
