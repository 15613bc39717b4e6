#include "cli/state_bakes.h"

#include <span>
#include <vector>

#include "inputs/bake_file.h"
#include "inputs/moved_light.h"
#include "settings/mover_light.h"

namespace hearth {

StateBakes::StateBakes(const OpenedLevel& opened, const BakeSettings& settings,
                       const OptionValues& values, bool areSaved)
    : opened_(opened),
      settings_(settings),
      values_(values),
      areSaved_(areSaved),
      states_(statesToKeep(authored().level.movers.size(), moverLightFrom(values))) {
  memory_.keepBakes(states_.size());
}

Bake StateBakes::bakeAuthored() { return add(authored().scene()); }

std::optional<std::string> StateBakes::bakeOthers() {
  for (const std::vector<double>& shares : std::span(states_).subspan(1)) {
    const auto level = loadedAt(authored(), opened_.source, shares, values_);
    if (!level) return level.error();
    const Bake bake = add((*level)->scene());
    ++figures_.count;
    figures_.seconds += bake.seconds;
    figures_.bytes += bake.light.stats.bytes;
  }
  return std::nullopt;
}

StateFigures StateBakes::figures() const {
  StateFigures figures = figures_;
  figures.movers = authored().level.movers.size();
  figures.keptBytes = memory_.bytes();
  return figures;
}

/// Nothing is kept for a next time where there is none.
Bake StateBakes::add(const Scene& scene) {
  LightMemory* const memory = states_.size() > 1 ? &memory_ : nullptr;
  Bake bake = bakeWith(scene, settings_, values_, ProgressStyle::Lines, memory);
  if (areSaved_) bytes_ += bytesOf(scene, bake);
  return bake;
}

}  // namespace hearth
