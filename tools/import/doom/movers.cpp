#include "import/doom/movers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "import/doom/destinations.h"

namespace hearth::doom {

namespace {

/// Pairs of a mover and a line, or a wall, that starts it: without a bound, a small hostile map has
/// billions.
constexpr std::size_t kMaxStarts = 100'000;

constexpr std::string_view kIsThere = "what it moves stands there already";
constexpr std::string_view kTooMany = "there are too many lines before it that move things";
constexpr std::string_view kOtherWay = "another line moves the same floor or ceiling elsewhere";

/// Lines that do the same: of one type and tag, or all of one type behind which one sector lies.
struct Order {
  const LineType* type;
  std::vector<std::uint32_t> lines;
  std::vector<std::uint32_t> sectors;
};

/// What an order makes of a flat.
struct Wish {
  std::size_t order;
  Motion motion;
};

struct Flat {
  std::uint32_t sector;
  FlatPart part;

  friend auto operator<=>(const Flat&, const Flat&) = default;
};

/// What a flat does, and the orders that start it.
struct Choice {
  int from;
  Motion motion;
  std::vector<std::size_t> orders;

  friend auto operator<=>(const Choice&, const Choice&) = default;
};

/// Why lines of a type start no mover, whatever they belong to; none if they may.
std::string_view reasonAgainst(const LineType& type) {
  switch (type.kind) {
    case LineKind::Crusher:
      return "it starts a crusher";
    case LineKind::Stop:
      return "it stops what another line started";
    case LineKind::Light:
      return "it changes light";
    case LineKind::Teleport:
      return "it teleports";
    case LineKind::Exit:
      return "it ends the map";
    case LineKind::Scroll:
      return "its texture scrolls";
    default:
      break;
  }
  if (type.activation == Activation::Shot) return "a shot starts it";
  if (type.destination == Destination::LowerTexture)
    return "it moves a floor by a texture's height";
  if (type.destination == Destination::Ring) return "it moves a floor and a ring around it";
  return {};
}

FlatPart partOf(LineKind kind) {
  return kind == LineKind::Door || kind == LineKind::Ceiling ? FlatPart::Ceiling : FlatPart::Floor;
}

std::string_view nounOf(LineKind kind) {
  switch (kind) {
    case LineKind::Door:
      return "door";
    case LineKind::Lift:
      return "lift";
    case LineKind::Stairs:
      return "step";
    case LineKind::Ceiling:
      return "ceiling";
    default:
      return "floor";
  }
}

/// Of two ways of one flat the one with which a player gets further: a ceiling rises and stays, a
/// floor is a lift that returns, or else sinks.
bool isBetter(FlatPart part, const Motion& a, const Motion& b) {
  if (part == FlatPart::Ceiling)
    return std::tuple(a.to, !a.wait, a.speed) > std::tuple(b.to, !b.wait, b.speed);
  return std::tuple(a.wait.has_value(), -a.to, a.speed) >
         std::tuple(b.wait.has_value(), -b.to, b.speed);
}

class MoverFinder {
 public:
  MoverFinder(const Map& map, const std::vector<Heights>& heights)
      : map_(map), heights_(heights), destinations_(map) {}

  MapMovers find() {
    for (std::uint32_t i = 0; i < map_.lines.size(); ++i)
      if (map_.lines[i].special != 0) addLine(i);
    for (std::size_t i = 0; i < orders_.size(); ++i) wish(i);
    for (const auto& [flat, wishes] : wishes_) choose(flat, wishes);
    keepFlatsApart();
    group();
    tell();
    return std::move(result_);
  }

 private:
  // --- Orders ------------------------------------------------------------------------------------

  void addLine(std::uint32_t i) {
    const Line& line = map_.lines[i];
    const LineType* type = findLineType(line.special);
    if (!type) return settle(i, std::nullopt, "its type is none of Doom's");
    if (const auto reason = reasonAgainst(*type); !reason.empty())
      return settle(i, type->kind, reason);
    const bool isPushed = type->activation == Activation::Push;
    if (!isPushed && line.tag == 0) return settle(i, type->kind, "it has no tag");
    const std::uint32_t key = !isPushed       ? line.tag
                              : line.sides[1] ? map_.sides[*line.sides[1]].sector
                                              : 0;
    const auto [known, isNew] = known_.try_emplace({type->number, key}, orders_.size());
    if (isNew) orders_.push_back({type, {}, destinations_.sectorsOf(line, *type)});
    Order& order = orders_[known->second];
    if (order.sectors.empty())
      return settle(i, type->kind, isPushed ? "nothing lies behind it" : "no sector has its tag");
    order.lines.push_back(i);
  }

  /// Without a reason it starts movers.
  void settle(std::uint32_t line, std::optional<LineKind> kind, std::string_view reason) {
    result_.lines.push_back({line, kind, std::string(reason)});
  }

  // --- Wishes ------------------------------------------------------------------------------------

  void wish(std::size_t order) {
    for (const std::uint32_t sector : orders_[order].sectors)
      if (orders_[order].type->kind == LineKind::Stairs)
        climb(order, sector);
      else
        wishFor(order, sector);
  }

  void wishFor(std::size_t order, std::uint32_t sector) {
    const LineType& type = *orders_[order].type;
    if (type.destination == Destination::LowestAndHighestFloor) return loop(order, sector);
    const auto to = destinations_.heightFor(type.destination, sector);
    if (!to) return refuse(order, sector, "nothing around says where it stops");
    add(order, {sector, partOf(type.kind)}, {*to, type.speed, type.wait, false});
  }

  /// Between two heights, at one of which it has to stand as the map begins.
  void loop(std::size_t order, std::uint32_t sector) {
    const LineType& type = *orders_[order].type;
    const int from = heights_[sector].floor;
    const int lowest = destinations_.heightFor(Destination::LowestFloor, sector).value();
    const int highest =
        std::max(from, destinations_.heightFor(Destination::HighestFloor, sector).value_or(from));
    if (from != lowest && from != highest)
      return refuse(order, sector, "it moves a floor that begins between its ends");
    add(order, {sector, FlatPart::Floor},
        {from == lowest ? highest : lowest, type.speed, type.wait, true});
  }

  /// From step to step as Doom does (EV_BuildStairs): over the first line whose front is this step
  /// and behind which lies a floor of the same flat. As there, one that climbs already is passed by
  /// and makes the next step higher.
  void climb(std::size_t order, std::uint32_t first) {
    const LineType& type = *orders_[order].type;
    const int size = type.destination == Destination::Steps8 ? 8 : 16;
    int z = heights_[first].floor;
    std::optional<std::uint32_t> step = first;
    if (isStep_.contains(first)) return refuse(order, first, kOtherWay);
    while (step) {
      z += step == first ? size : 0;
      isStep_.insert(*step);
      add(order, {*step, FlatPart::Floor}, {z, type.speed, type.wait, false});
      step = nextStep(*step, map_.sectors[first].floorFlat, size, z);
    }
  }

  std::optional<std::uint32_t> nextStep(std::uint32_t step, const std::string& flat, int size,
                                        int& z) {
    for (const std::uint32_t next : sectorsBehind(step)) {
      if (map_.sectors[next].floorFlat != flat) continue;
      z += size;
      if (!isStep_.contains(next)) return next;
    }
    return std::nullopt;
  }

  /// Of the lines whose front is a sector.
  const std::vector<std::uint32_t>& sectorsBehind(std::uint32_t sector) {
    if (behind_.empty()) {
      behind_.resize(map_.sectors.size());
      for (const Line& line : map_.lines)
        if (line.sides[0] && line.sides[1])
          behind_[map_.sides[*line.sides[0]].sector].push_back(map_.sides[*line.sides[1]].sector);
    }
    return behind_[sector];
  }

  void add(std::size_t order, Flat flat, const Motion& motion) {
    const bool isFloor = flat.part == FlatPart::Floor;
    const Sector& sector = map_.sectors[flat.sector];
    const Heights& own = heights_[flat.sector];
    if ((isFloor ? sector.floorFlat : sector.ceilingFlat) == kSkyFlat)
      return refuse(order, flat.sector, "it moves sky");
    if (isFloor ? motion.to > own.ceiling : motion.to < own.floor)
      return refuse(order, flat.sector, "a floor would pass its ceiling");
    wishes_[flat].push_back({order, motion});
  }

  void refuse(std::size_t order, std::uint32_t sector, std::string_view reason) {
    refused_.try_emplace({order, sector}, reason);
  }

  // --- Choices -----------------------------------------------------------------------------------

  int startOf(Flat flat) const {
    const Heights& own = heights_[flat.sector];
    return flat.part == FlatPart::Floor ? own.floor : own.ceiling;
  }

  /// A door that is open stays so where lines open and close it: a mover has one other end.
  void choose(Flat flat, const std::vector<Wish>& wishes) {
    const int from = startOf(flat);
    const Wish* best = bestOf(flat, wishes);
    const bool moves = best && best->motion.to != from;
    Choice choice{from, best ? best->motion : Motion{}, {}};
    for (const Wish& wish : wishes) {
      const bool stays = wish.motion.to == from;
      const bool bringsBack = moves && stays && isLift(flat, wish);
      if (bringsBack) {
        choice.motion.speed = wish.motion.speed;
        choice.motion.wait = wish.motion.wait;
      }
      if (bringsBack || (moves && wish.motion.to == best->motion.to))
        choice.orders.push_back(wish.order);
      else
        refuse(wish.order, flat.sector, stays ? kIsThere : kOtherWay);
    }
    if (moves) choices_.emplace(flat, std::move(choice));
  }

  const Wish* bestOf(Flat flat, const std::vector<Wish>& wishes) const {
    const Wish* best = nullptr;
    for (const Wish& wish : wishes) {
      if (flat.part == FlatPart::Floor && wish.motion.to == startOf(flat)) continue;
      if (!best || isBetter(flat.part, wish.motion, best->motion)) best = &wish;
    }
    return best;
  }

  /// A lift that is down as the map begins, and that another line raises first, returns down
  /// instead of up: then one gets on it from both ends, too.
  static bool isLift(Flat flat, const Wish& wish) {
    return flat.part == FlatPart::Floor && wish.motion.wait.has_value();
  }

  /// The floor keeps its motion where both flats of a sector would meet.
  void keepFlatsApart() {
    std::erase_if(choices_, [this](const auto& choice) {
      const auto& [flat, chosen] = choice;
      if (flat.part == FlatPart::Floor) return false;
      const auto floor = choices_.find({flat.sector, FlatPart::Floor});
      if (floor == choices_.end() || floor->second.motion.to <= chosen.motion.to) return false;
      for (const std::size_t order : chosen.orders)
        refuse(order, flat.sector, "its ceiling would meet a floor that moves");
      return true;
    });
  }

  // --- Movers ------------------------------------------------------------------------------------

  /// What the same lines move in the same way is one mover.
  void group() {
    std::map<std::tuple<FlatPart, Choice>, std::size_t> movers;
    std::size_t starts = 0;
    for (const auto& [flat, choice] : choices_) {
      const auto [known, isNew] = movers.try_emplace({flat.part, choice}, result_.movers.size());
      if (isNew) {
        MapMover mover = moverOf(flat, choice);
        starts += mover.lines.size();
        if (starts > kMaxStarts) return tellOfTooMany();
        result_.movers.push_back(std::move(mover));
      }
      result_.movers[known->second].sectors.push_back(flat.sector);
      for (const std::size_t order : choice.orders) moving_.insert(order);
    }
  }

  MapMover moverOf(Flat flat, const Choice& choice) const {
    const LineKind kind = orders_[choice.orders.front()].type->kind;
    MapMover mover{fmt::format("{} {}", nounOf(kind), flat.sector),
                   flat.part,
                   choice.from,
                   choice.motion,
                   {},
                   {}};
    for (const std::size_t order : choice.orders)
      mover.lines.insert(mover.lines.end(), orders_[order].lines.begin(),
                         orders_[order].lines.end());
    std::ranges::sort(mover.lines);
    return mover;
  }

  void tellOfTooMany() {
    for (std::size_t i = 0; i < orders_.size(); ++i)
      refuse(i, orders_[i].sectors.front(), kTooMany);
  }

  // --- Report ------------------------------------------------------------------------------------

  void tell() {
    std::map<std::size_t, std::string_view> reasons;
    for (const auto& [key, reason] : refused_) {
      const auto& [order, sector] = key;
      if (!moving_.contains(order))
        reasons.try_emplace(order, reason);
      else
        result_.findings.push_back({Outcome::Dropped, Part::Sector, sector,
                                    fmt::format("line {}, which moves others, does not move it: {}",
                                                orders_[order].lines.front(), reason)});
    }
    for (std::size_t i = 0; i < orders_.size(); ++i)
      for (const std::uint32_t line : orders_[i].lines)
        settle(line, orders_[i].type->kind,
               moving_.contains(i) ? std::string_view{} : reasons.at(i));
    std::ranges::sort(result_.lines, {}, &LineFate::line);
  }

  const Map& map_;
  const std::vector<Heights>& heights_;
  Destinations destinations_;
  std::vector<Order> orders_;
  std::map<std::pair<std::uint16_t, std::uint32_t>, std::size_t>
      known_;  ///< by type, tag or sector
  std::map<Flat, std::vector<Wish>> wishes_;
  std::map<std::pair<std::size_t, std::uint32_t>, std::string_view> refused_;  ///< by order, sector
  std::map<Flat, Choice> choices_;
  std::set<std::size_t> moving_;  ///< orders that start movers
  std::set<std::uint32_t> isStep_;
  std::vector<std::vector<std::uint32_t>> behind_;  ///< by sector
  MapMovers result_;
};

}  // namespace

std::set<std::uint32_t> MapMovers::starters() const {
  std::set<std::uint32_t> starters;
  for (const MapMover& mover : movers) starters.insert(mover.lines.begin(), mover.lines.end());
  return starters;
}

void MapMovers::keep(const std::function<std::size_t(std::uint32_t line)>& countWalls,
                     const std::function<bool(std::uint32_t sector)>& isSpace) {
  std::size_t starts = 0;
  std::erase_if(movers, [&](MapMover& mover) {
    std::erase_if(mover.sectors, [&](std::uint32_t sector) { return !isSpace(sector); });
    std::erase_if(mover.lines, [&](std::uint32_t line) { return countWalls(line) == 0; });
    if (mover.sectors.empty() || mover.lines.empty()) return true;
    for (const std::uint32_t line : mover.lines) starts += countWalls(line);
    return starts > kMaxStarts;
  });
  const std::set<std::uint32_t> left = starters();
  for (LineFate& fate : lines)
    if (fate.isImported() && !left.contains(fate.line))
      fate.reason = countWalls(fate.line) == 0 ? "no player can reach it"
                    : starts > kMaxStarts      ? kTooMany
                                               : "what it moves has no space";
}

MapMovers moversOf(const Map& map, const std::vector<Heights>& heights) {
  return MoverFinder(map, heights).find();
}

}  // namespace hearth::doom
