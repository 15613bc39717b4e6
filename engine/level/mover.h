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

/// Light between the ends of a mover is baked at so many heights at most. With no more of them, the
/// share of each, times the steps from end to end, is a whole number in a double.
inline constexpr int kMaxMoverStages = 15;

/// The states at rest whose light together is that of a level with movers at some shares (0..1). In
/// each of them every mover stands at a stage: at an end or, with `stages` > 0, at one of so many
/// heights evenly between the ends. Each mover is a part s of its way from one stage to the next.
/// With the parts sorted, s1 >= s2 >= .., the state with the first i movers at their next stage
/// counts s_i - s_(i+1), where s_0 is 1 and there is a 0 after the last. It is a single state where
/// all movers are at a stage.
class RestStates {
 public:
  RestStates() = default;
  explicit RestStates(std::span<const double> shares, int stages = 0) { find(shares, stages); }

  /// As many movers each time. Takes memory the first time only.
  void find(std::span<const double> shares, int stages = 0);

  std::size_t count() const { return weights_.size(); }
  /// How much the light of each state counts: > 0, with a sum of 1.
  std::span<const double> weights() const { return weights_; }
  /// The shares of all movers in a state.
  std::vector<double> shares(std::size_t state) const;

  /// Whether these are the same states, whatever their weights.
  bool areStatesOf(const RestStates& other) const {
    return falling_ == other.falling_ && below_ == other.below_ && atNext_ == other.atNext_ &&
           steps_ == other.steps_;
  }

 private:
  int steps_ = 1;                     ///< from end to end
  std::vector<int> below_;            ///< by mover: the stage before its share, from 0
  std::vector<double> parts_;         ///< ... and how far it is to the next
  std::vector<std::size_t> falling_;  ///< movers by falling part
  std::vector<std::size_t> atNext_;   ///< by state: so many of them are at their next stage
  std::vector<double> weights_;
};

}  // namespace hearth
