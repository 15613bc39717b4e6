#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "level/ids.h"

namespace hearth {

/// The flat of a sector that moves.
enum class FlatPart : std::uint8_t { Floor, Ceiling };

/// What starts a mover, apart from walls that name it.
enum class MoverTrigger : std::uint8_t {
  None,
  Use,    ///< the player's use key, in one of its sectors or at their walls
  Enter,  ///< the player's feet in one of its zones
  Loop,   ///< nothing: it never rests
};

// By the enumerations, as files and messages name them.
inline constexpr std::array<std::string_view, 2> kFlatPartNames{"floor", "ceiling"};
inline constexpr std::array<std::string_view, 4> kMoverTriggerNames{"none", "use", "enter", "loop"};
std::string_view name(FlatPart part);
std::string_view name(MoverTrigger trigger);

/// Flats that move together between two heights: a door, a lift, a gate. Its share is 0 where the
/// flats are authored, and 1 at `to`.
struct Mover {
  std::string name;
  std::vector<SectorId> sectors;  ///< at least one; their flats are authored at one height
  FlatPart part = FlatPart::Ceiling;
  double to = 0;               ///< absolute height
  double speed = 1.5;          ///< metres a second
  std::optional<double> wait;  ///< seconds until it returns; none: it stays
  MoverTrigger trigger = MoverTrigger::None;
  std::vector<SectorId> zones;  ///< of MoverTrigger::Enter
};

/// Where one mover stands.
struct MoverShare {
  std::size_t mover;  ///< index into Level::movers
  double share;       ///< 0..1

  friend bool operator==(const MoverShare&, const MoverShare&) = default;
};

/// All movers at one of their ends each, and how much the light of this state counts.
struct RestState {
  std::vector<double> shares;  ///< by mover: 0 or 1
  double weight;               ///< > 0; those of all states sum up to 1
};

/// The states whose light together is that with movers at these shares (0..1): sorted by falling
/// share s1 >= s2 >= .., the state with the first i movers at `to` counts s_i - s_(i+1), with s_0
/// = 1 and 0 after the last. One state where all movers are at an end.
std::vector<RestState> restStatesAround(std::span<const double> shares);

}  // namespace hearth
