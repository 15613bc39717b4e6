#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "settings/options.h"

namespace hearth {

/// In which states of a level's movers its light is baked.
struct MoverLightSettings {
  static constexpr std::size_t kStates = 32;

  int stages = 0;                ///< heights between the ends of each mover: see RestStates
  std::size_t states = kStates;  ///< that are kept, the level as authored among them; at least one

  friend bool operator==(const MoverLightSettings&, const MoverLightSettings&) = default;
};

/// What the command line says of it.
MoverLightSettings moverLightFrom(const OptionValues& values);

/// The value with which an option of movers asks for these settings.
std::string valueOf(const MoverLightSettings& settings, Option option);

/// The shares of so many movers in as many states as the settings keep, or all if there are fewer:
/// first that of the level as authored, then those in which one mover stands elsewhere, then two,
/// and so on.
std::vector<std::vector<double>> statesToKeep(std::size_t movers,
                                              const MoverLightSettings& settings);

}  // namespace hearth
