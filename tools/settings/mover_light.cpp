#include "settings/mover_light.h"

#include <fmt/format.h>

#include <utility>

#include "math/check.h"

namespace hearth {

namespace {

/// Adds states, while there is room, in which so many of the movers from `first` on stand elsewhere
/// than in `shares`, at a stage each.
class StateList {
 public:
  StateList(std::size_t movers, const MoverLightSettings& settings)
      : settings_(settings), shares_(movers) {}

  std::vector<std::vector<double>> all() {
    for (std::size_t moved = 0; moved <= shares_.size() && hasRoom(); ++moved) add(0, moved);
    return std::move(states_);
  }

 private:
  bool hasRoom() const { return states_.size() < settings_.states; }

  void add(std::size_t first, std::size_t moved) {
    if (moved == 0 && hasRoom()) states_.push_back(shares_);
    if (moved == 0) return;
    for (std::size_t i = first; i + moved <= shares_.size() && hasRoom(); ++i) {
      for (int stage = 1; stage <= settings_.stages + 1 && hasRoom(); ++stage) {
        shares_[i] = 1.0 * stage / (settings_.stages + 1);
        add(i + 1, moved - 1);
      }
      shares_[i] = 0;
    }
  }

  MoverLightSettings settings_;
  std::vector<double> shares_;
  std::vector<std::vector<double>> states_;
};

}  // namespace

MoverLightSettings moverLightFrom(const OptionValues& values) {
  MoverLightSettings settings;
  if (const auto stages = values.number(Option::MoverStages))
    settings.stages = static_cast<int>(*stages);
  if (const auto states = values.number(Option::MoverStates))
    settings.states = static_cast<std::size_t>(*states);
  return settings;
}

std::string valueOf(const MoverLightSettings& settings, Option option) {
  switch (option) {
    case Option::MoverStages:
      return fmt::to_string(settings.stages);
    case Option::MoverStates:
      return fmt::to_string(settings.states);
    default:
      CHECK(false, row(option).name);
      return "";
  }
}

std::vector<std::vector<double>> statesToKeep(std::size_t movers,
                                              const MoverLightSettings& settings) {
  return StateList(movers, settings).all();
}

}  // namespace hearth
