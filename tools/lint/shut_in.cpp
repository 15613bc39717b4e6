#include <fmt/format.h>

#include <algorithm>

#include "lint/lint.h"
#include "lint/sector_graph.h"
#include "lint/sector_reach.h"
#include "walk/body.h"

namespace hearth {

namespace {

/// Metres by which a leap lifts the feet, rounded up.
constexpr double kLeap = 0.56;

/// Finds where a mover shuts the player in: with the mover as it comes to rest the player comes to
/// less than half of what can be reached at all, by area, and with the mover at either end to more.
/// Half, because a player that cannot go back to the smaller part of a level may be meant to go on.
class ShutInFinder {
 public:
  ShutInFinder(const LintedLevel& linted, Findings& findings)
      : linted_(linted),
        level_(linted.level()),
        findings_(findings),
        body_(bodyOf(level_, 1)),
        passages_(level_, body_.stepHeight + kLeap, body_.height),
        all_(level_, passages_),
        half_(areaOf(level_, all_.sectors()) / 2),
        isTold_(level_.sectors.size()) {}

  void lookAt(std::size_t mover) {
    if (level_.movers[mover].trigger == MoverTrigger::Loop || !mayMove(mover)) return;
    const std::vector<MoverEnds> ends = endsAtRest(mover);
    for (const SectorId sector : sectorsAt(mover)) {
      if (!all_.comesTo(sector) || isTold_[sector.index()]) continue;
      if (!passages_.hasRoom(sector, ends)) continue;
      const Reach within(level_, passages_, sector, ends);
      if (isShutIn(within, mover)) return report(within, mover);
    }
  }

 private:
  bool mayMove(std::size_t mover) const { return has(all_.ends()[mover], MoverEnds::To); }

  /// A player that a mover shuts in comes to one of these: its own, and those beside them.
  std::vector<SectorId> sectorsAt(std::size_t mover) const {
    std::vector<SectorId> sectors = level_.movers[mover].sectors;
    for (const SectorId own : level_.movers[mover].sectors)
      for (const SectorId next : passages_.next(own))
        if (std::ranges::find(sectors, next) == sectors.end()) sectors.push_back(next);
    return sectors;
  }

  bool isShutIn(const Reach& within, std::size_t mover) const {
    if (isLarge(within) || !isThereWith(within, mover) || mayClimb(within)) return false;
    std::vector<MoverEnds> ends = endsAtRest(mover);
    ends[mover] = MoverEnds::Both;
    return isLarge({level_, passages_, within.sectors().front(), ends});
  }

  /// A player that waits sees all movers come back that do. Those that stay may have been started
  /// or not, except the one that is looked at.
  std::vector<MoverEnds> endsAtRest(std::size_t mover) const {
    std::vector<MoverEnds> ends = all_.ends();
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (level_.movers[i].wait && level_.movers[i].trigger != MoverTrigger::Loop)
        ends[i] = MoverEnds::Authored;
    if (!level_.movers[mover].wait) ends[mover] = MoverEnds::To;
    return ends;
  }

  bool isLarge(const Reach& reach) const { return areaOf(level_, reach.sectors()) >= half_; }

  /// Whether the player can be there once the mover is at rest: a mover that stays must be started
  /// from within, or on the way in, or let the player in afterwards.
  bool isThereWith(const Reach& within, std::size_t mover) const {
    if (level_.movers[mover].wait) return true;
    const auto isWithin = [&](const MoverStart& start) {
      return start.mover == mover && within.comesTo(start.to.value_or(start.from));
    };
    if (std::ranges::any_of(passages_.starts(), isWithin)) return true;
    std::vector<MoverEnds> ends = all_.ends();
    ends[mover] = MoverEnds::To;
    const Reach later(level_, passages_, level_.player->sector, ends);
    return later.comesTo(within.sectors().front());
  }

  /// Things may serve as steps.
  bool mayClimb(const Reach& within) const {
    return std::ranges::any_of(within.sectors(), [&](SectorId sector) {
      return std::ranges::any_of(level_.bodiesIn(sector), [&](const BodyInSector& there) {
        return level_.bodies[there.body].zTop <= level_[sector].floor.z + body_.stepHeight + kLeap;
      });
    });
  }

  void report(const Reach& within, std::size_t mover) {
    for (const SectorId each : within.sectors()) isTold_[each.index()] = true;
    const Mover& moving = level_.movers[mover];
    const Place place = linted_.source.level.movers[mover].place;
    const std::string& name = level_[within.sectors().front()].name;
    if (moving.wait)
      findings_.add(FindingKind::ShutIn, place,
                    fmt::format("mover \"{}\" shuts the player in: once it is back, nothing leads "
                                "out of sector \"{}\"",
                                moving.name, name),
                    "let something in there start it, such as a wall with \"use\", or leave out "
                    "\"wait\"");
    else
      findings_.add(
          FindingKind::ShutIn, place,
          fmt::format("mover \"{}\" shuts the player in: once it has moved, nothing leads "
                      "out of sector \"{}\"",
                      moving.name, name),
          "give it a \"wait\", so that it returns, or open another way out");
  }

  const LintedLevel& linted_;
  const Level& level_;
  Findings& findings_;
  Body body_;
  Passages passages_;
  Reach all_;
  double half_;               ///< square metres
  std::vector<bool> isTold_;  ///< by sector
};

}  // namespace

void findShutIn(const LintedLevel& linted, Findings& findings) {
  const Level& level = linted.level();
  if (level.movers.empty() || !level.player) return;
  ShutInFinder finder(linted, findings);
  for (std::size_t i = 0; i < level.movers.size(); ++i) finder.lookAt(i);
}

}  // namespace hearth
