#include <fmt/format.h>

#include <algorithm>

#include "level/twins.h"
#include "lint/lint.h"
#include "lint/sector_graph.h"
#include "load/link/link.h"

namespace hearth {

namespace {

/// Metres. What is nearer was meant for one point.
constexpr double kOneEnd = 0.25;

/// Finds where portals do not lead back, authored wall by authored wall.
class OneWayFinder {
 public:
  OneWayFinder(const LintedLevel& linted, Findings& findings)
      : level_(linted.level()), source_(linted.source), findings_(findings), twins_(level_) {}

  /// `first` to `last`: all segments of an authored wall.
  void lookAtWall(std::size_t first, std::size_t last) {
    for (const SectorId target : targetsOf(level_.segments[first].wall)) {
      std::vector<bool> leadsBack;
      for (std::size_t i = first; i <= last; ++i)
        leadsBack.push_back(isLedBack(level_.segments[i], target));
      if (std::ranges::find(leadsBack, true) == leadsBack.end()) continue;  // the loader warns
      for (std::size_t i = 0; i < leadsBack.size(); ++i) {
        if (leadsBack[i]) continue;
        const std::size_t from = i;
        while (i + 1 < leadsBack.size() && !leadsBack[i + 1]) ++i;
        report(first + from, first + i, target);
      }
    }
  }

 private:
  bool isLedBack(const Segment& segment, SectorId target) const {
    const SegmentId twin = twins_.find(segment, target).value();  // linking has made sure
    return std::ranges::binary_search(targetsOf(level_[twin].wall), segment.sector);
  }

  void report(std::size_t first, std::size_t last, SectorId target) {
    const Vec2 from = level_.segments[first].p0;
    const Vec2 to = level_.segments[last].p1;
    const std::string& name = level_[target].name;
    findings_.add(
        FindingKind::OneWayPortal, source_.wall(SegmentId(first)).place,
        fmt::format("the portal to sector \"{}\" does not lead back from ({}, {}) to ({}, {})",
                    name, from.x, from.y, to.x, to.y),
        adviceOn(from, to, name));
  }

  static std::string adviceOn(Vec2 from, Vec2 to, const std::string& name) {
    const double missing = length(to - from);
    if (missing > kOneEnd) return fmt::format("let sector \"{}\" lead back there, too", name);
    return fmt::format(
        "let the portals of both sectors end in one point: ({}, {}) misses ({}, {}) by {:.2g} m",
        from.x, from.y, to.x, to.y, missing);
  }

  const Level& level_;
  const LevelSource& source_;
  Findings& findings_;
  TwinIndex twins_;
};

std::string alsoInWords(std::size_t others) {
  if (others == 0) return "";
  return fmt::format(" and {} {} linked with it", others, others == 1 ? "other" : "others");
}

/// Where the player is or, without one, in the most sectors that hang together.
SectorId startOf(const Level& level, const std::vector<std::vector<SectorId>>& parts) {
  if (level.player) return level.player->sector;
  return std::ranges::max_element(parts, {}, &std::vector<SectorId>::size)->front();
}

}  // namespace

void findOneWayPortals(const LintedLevel& linted, Findings& findings) {
  OneWayFinder finder(linted, findings);
  const std::vector<std::uint32_t>& edgeOf = linted.source.edgeOf;
  for (std::size_t first = 0, last = 0; first < edgeOf.size(); first = last + 1) {
    last = first;
    while (last + 1 < edgeOf.size() && edgeOf[last + 1] == edgeOf[first]) ++last;
    finder.lookAtWall(first, last);
  }
}

/// One finding for each part that hangs together, so that a part that was forgotten is one mistake.
void findUnreachable(const LintedLevel& linted, Findings& findings) {
  const Level& level = linted.level();
  const std::vector<std::vector<SectorId>> links = sectorGraph(level);
  const std::vector<std::vector<SectorId>> linked = undirected(links);
  const SectorId start = startOf(level, connectedComponents(linked));
  // Without a player links count both ways: nothing says where the player would begin.
  const std::vector<bool> isReached = reachableFrom(level.player ? links : linked, start);
  std::vector<std::vector<SectorId>> unreached(links.size());
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!isReached[i])
      std::ranges::copy_if(linked[i], std::back_inserter(unreached[i]),
                           [&](SectorId next) { return !isReached[next.index()]; });
  for (const std::vector<SectorId>& part : connectedComponents(unreached)) {
    const SectorId first = part.front();
    if (isReached[first.index()]) continue;
    findings.add(
        FindingKind::Unreachable, linted.source.level.sectors[first.index()].place,
        fmt::format("no links lead from {} to sector \"{}\"{}",
                    level.player ? "the player" : fmt::format("sector \"{}\"", level[start].name),
                    level[first].name, alsoInWords(part.size() - 1)),
        "link it to its neighbours with \"next\"");
  }
}

}  // namespace hearth
