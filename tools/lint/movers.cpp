#include <fmt/format.h>

#include <algorithm>

#include "lint/lint.h"

namespace hearth {

void findIdleMovers(const LintedLevel& linted, Findings& findings) {
  const Level& level = linted.level();
  if (level.movers.empty()) return;
  const std::vector<SectorId> beyond = outOfReach(linted.scene());
  for (std::size_t i = 0; i < level.movers.size(); ++i) {
    const Mover& mover = level.movers[i];
    const MoverDescription& described = linted.source.level.movers[i];
    if (mover.trigger == MoverTrigger::None && !level.hasSwitch(i))
      findings.add(FindingKind::IdleMover, described.place,
                   fmt::format("nothing starts mover \"{}\"", mover.name),
                   "give it a \"trigger\", or name it in \"use\" or \"cross\" of a wall");
    for (std::size_t zone = 0; zone < mover.zones.size(); ++zone)
      if (std::ranges::find(beyond, mover.zones[zone]) != beyond.end())
        findings.add(FindingKind::UnenteredZone, described.zones[zone].place,
                     fmt::format("the player cannot get to zone \"{}\" of mover \"{}\"",
                                 level[mover.zones[zone]].name, mover.name),
                     "name a sector that the player can enter, or open a way there");
  }
}

}  // namespace hearth
