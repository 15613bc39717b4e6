#include "explorer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <tuple>

namespace hearth::test {

namespace {

constexpr int kMaxTries = 60000;  // for each new sector

/// A walker in one of the places that the search tells apart, and how it came there.
struct Visit {
  Walker walker;
  std::size_t from = 0;           ///< index of the visit before
  std::vector<WalkInput> inputs;  ///< from there
  int tries = 0;
};

/// Places are cubes of half a metre, each sector with its own.
using Cell = std::tuple<std::uint32_t, int, int, int>;

Cell cellOf(const Walker& walker) {
  const auto index = [](double metres) { return static_cast<int>(std::floor(2 * metres)); };
  return {walker.sector.value, index(walker.feet.x), index(walker.feet.y), index(walker.feet.z)};
}

class Search {
 public:
  Search(const Scene& scene, const Walker& start, Gait gait, std::mt19937& random)
      : scene_(scene), gait_(gait), random_(random) {
    add({start, 0, {}});
  }

  /// The way to where `isThere` holds, through none of the sectors forbidden; nothing where none is
  /// found.
  std::optional<std::vector<WalkInput>> wayTo(const std::function<bool(const Walker&)>& isThere,
                                              const std::vector<SectorId>& forbidden) {
    for (int i = 0; i < kMaxTries; ++i) {
      Visit visit = stretchFrom(seldomTried());
      if (std::ranges::find(forbidden, visit.walker.sector) != forbidden.end()) continue;
      if (isThere(visit.walker)) return wayTo(visit);
      add(std::move(visit));
    }
    return std::nullopt;
  }

 private:
  int upTo(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  void add(Visit visit) {
    if (cells_.emplace(cellOf(visit.walker), visits_.size()).second)
      visits_.push_back(std::move(visit));
  }

  std::size_t seldomTried() {
    std::size_t best = random_() % visits_.size();
    for (int i = 0; i < 3; ++i) {
      const std::size_t other = random_() % visits_.size();
      if (visits_[other].tries < visits_[best].tries) best = other;
    }
    ++visits_[best].tries;
    return best;
  }

  /// Turns, then goes straight on for a while.
  Visit stretchFrom(std::size_t from) {
    WalkInput input{.forward = kFullSpeed, .turn = 15000 * (upTo(24) - 12)};
    input.run = upTo(3) == 0;
    input.jump = upTo(3) == 0;
    input.crouch = upTo(6) == 0;
    const bool flies = gait_ == Gait::Flying;
    if (flies) input.up = kFullSpeed * (upTo(3) - 1);
    input.toggleFlight = flies && !visits_[from].walker.isFlying;
    Visit visit{visits_[from].walker, from, {}};
    const SectorId before = visit.walker.sector;
    for (int ticks = 8 + upTo(40); ticks > 0 && visit.walker.sector == before; --ticks) {
      visit.walker = walked(scene_, visit.walker, input);
      visit.inputs.push_back(input);
      input.turn = 0;
      input.toggleFlight = false;
    }
    return visit;
  }

  std::vector<WalkInput> wayTo(const Visit& last) const {
    std::vector<const Visit*> visits{&last};
    for (std::size_t i = last.from; i != 0; i = visits_[i].from) visits.push_back(&visits_[i]);
    std::vector<WalkInput> way;
    for (auto it = visits.rbegin(); it != visits.rend(); ++it)
      way.insert(way.end(), (*it)->inputs.begin(), (*it)->inputs.end());
    return way;
  }

  Scene scene_;
  Gait gait_;
  std::mt19937& random_;
  std::vector<Visit> visits_;
  std::map<Cell, std::size_t> cells_;
};

Walker walkedBy(const Scene& scene, Walker walker, const std::vector<WalkInput>& inputs) {
  for (const WalkInput& input : inputs) walker = walked(scene, walker, input);
  return walker;
}

}  // namespace

std::vector<WalkInput> exploration(const Scene& scene, const Walker& start, Gait gait,
                                   const std::vector<SectorId>& noReturn) {
  std::mt19937 random(1);
  std::vector<WalkInput> inputs;
  Walker walker = start;
  std::vector<SectorId> forbidden = noReturn;
  for (;;) {
    const std::vector<bool> isVisited = visitedSectors(scene, start, inputs);
    const auto isNew = [&](const Walker& there) { return !isVisited[there.sector.index()]; };
    const auto way = Search(scene, walker, gait, random).wayTo(isNew, forbidden);
    if (!way && forbidden.empty()) return inputs;
    if (!way) {
      forbidden.clear();
      continue;
    }
    inputs.insert(inputs.end(), way->begin(), way->end());
    walker = walkedBy(scene, walker, *way);
  }
}

std::vector<bool> visitedSectors(const Scene& scene, Walker walker,
                                 const std::vector<WalkInput>& inputs) {
  std::vector<bool> isVisited(scene.level().sectors.size(), false);
  isVisited[walker.sector.index()] = true;
  for (const WalkInput& input : inputs) {
    walker = walked(scene, walker, input);
    isVisited[walker.sector.index()] = true;
  }
  return isVisited;
}

}  // namespace hearth::test
