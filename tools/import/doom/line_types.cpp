#include "import/doom/line_types.h"

#include <algorithm>
#include <array>

namespace hearth::doom {

namespace {

constexpr double kTic = 1.0 / 35;         // seconds
constexpr double kUnitSpeed = 35.0 / 32;  // a unit, 1/32 m, in each tic: metres a second

constexpr double kDoorSpeed = 2 * kUnitSpeed;
constexpr double kFastDoorSpeed = 8 * kUnitSpeed;
constexpr double kDoorWait = 150 * kTic;
constexpr double kClosedWait = 30;
constexpr double kLiftSpeed = 4 * kUnitSpeed;
constexpr double kFastLiftSpeed = 8 * kUnitSpeed;
constexpr double kLiftWait = 105 * kTic;
constexpr double kFlatSpeed = kUnitSpeed;
constexpr double kFastFlatSpeed = 4 * kUnitSpeed;
constexpr double kPlatformSpeed = kUnitSpeed / 2;

constexpr LineType opens(std::uint16_t number, Activation activation,
                         std::optional<double> wait = {}) {
  return {number, LineKind::Door, activation, Destination::DoorTop, kDoorSpeed, wait};
}
constexpr LineType opensFast(std::uint16_t number, Activation activation,
                             std::optional<double> wait = {}) {
  return {number, LineKind::Door, activation, Destination::DoorTop, kFastDoorSpeed, wait};
}
constexpr LineType shuts(std::uint16_t number, Activation activation, double speed,
                         std::optional<double> wait = {}) {
  return {number, LineKind::Door, activation, Destination::OwnFloor, speed, wait};
}
constexpr LineType lowersLift(std::uint16_t number, Activation activation, double speed) {
  return {number, LineKind::Lift, activation, Destination::LowestFloor, speed, kLiftWait};
}
constexpr LineType movesFloor(std::uint16_t number, Activation activation, Destination destination,
                              double speed = kFlatSpeed) {
  return {number, LineKind::Floor, activation, destination, speed};
}
constexpr LineType buildsStairs(std::uint16_t number, Activation activation,
                                Destination destination, double speed) {
  return {number, LineKind::Stairs, activation, destination, speed};
}
constexpr LineType movesCeiling(std::uint16_t number, Activation activation,
                                Destination destination) {
  return {number, LineKind::Ceiling, activation, destination, kFlatSpeed};
}

/// A struct, so that the enumerators have their short names in the table alone.
struct LineTable {
  using enum LineKind;
  using enum Activation;
  using enum Destination;
  static constexpr std::array kAll{
      opens(1, Push, kDoorWait),  // the others of these need a key
      opens(26, Push, kDoorWait),
      opens(27, Push, kDoorWait),
      opens(28, Push, kDoorWait),
      opens(31, Push),
      opens(32, Push),
      opens(33, Push),
      opens(34, Push),
      opensFast(117, Push, kDoorWait),
      opensFast(118, Push),

      opens(2, Walk),
      opens(86, Walk),
      opens(4, Walk, kDoorWait),
      opens(90, Walk, kDoorWait),
      opens(103, Switch),
      opens(61, Switch),
      opens(29, Switch, kDoorWait),
      opens(63, Switch, kDoorWait),
      opens(46, Shot),
      opensFast(109, Walk),
      opensFast(106, Walk),
      opensFast(108, Walk, kDoorWait),
      opensFast(105, Walk, kDoorWait),
      opensFast(112, Switch),
      opensFast(115, Switch),
      opensFast(111, Switch, kDoorWait),
      opensFast(114, Switch, kDoorWait),
      // With a key
      opensFast(99, Switch),
      opensFast(133, Switch),
      opensFast(134, Switch),
      opensFast(135, Switch),
      opensFast(136, Switch),
      opensFast(137, Switch),

      shuts(3, Walk, kDoorSpeed),
      shuts(75, Walk, kDoorSpeed),
      shuts(50, Switch, kDoorSpeed),
      shuts(42, Switch, kDoorSpeed),
      shuts(110, Walk, kFastDoorSpeed),
      shuts(107, Walk, kFastDoorSpeed),
      shuts(113, Switch, kFastDoorSpeed),
      shuts(116, Switch, kFastDoorSpeed),
      shuts(16, Walk, kDoorSpeed, kClosedWait),
      shuts(76, Walk, kDoorSpeed, kClosedWait),

      lowersLift(10, Walk, kLiftSpeed),
      lowersLift(88, Walk, kLiftSpeed),
      lowersLift(21, Switch, kLiftSpeed),
      lowersLift(62, Switch, kLiftSpeed),
      lowersLift(121, Walk, kFastLiftSpeed),
      lowersLift(120, Walk, kFastLiftSpeed),
      lowersLift(122, Switch, kFastLiftSpeed),
      lowersLift(123, Switch, kFastLiftSpeed),

      movesFloor(38, Walk, LowestFloor),
      movesFloor(82, Walk, LowestFloor),
      movesFloor(23, Switch, LowestFloor),
      movesFloor(60, Switch, LowestFloor),
      movesFloor(37, Walk, LowestFloor),
      movesFloor(84, Walk, LowestFloor),
      movesFloor(19, Walk, HighestFloor),
      movesFloor(83, Walk, HighestFloor),
      movesFloor(102, Switch, HighestFloor),
      movesFloor(45, Switch, HighestFloor),
      movesFloor(36, Walk, AboveHighestFloor, kFastFlatSpeed),
      movesFloor(98, Walk, AboveHighestFloor, kFastFlatSpeed),
      movesFloor(71, Switch, AboveHighestFloor, kFastFlatSpeed),
      movesFloor(70, Switch, AboveHighestFloor, kFastFlatSpeed),
      movesFloor(119, Walk, NextFloor),
      movesFloor(128, Walk, NextFloor),
      movesFloor(18, Switch, NextFloor),
      movesFloor(69, Switch, NextFloor),
      movesFloor(130, Walk, NextFloor, kFastFlatSpeed),
      movesFloor(129, Walk, NextFloor, kFastFlatSpeed),
      movesFloor(131, Switch, NextFloor, kFastFlatSpeed),
      movesFloor(132, Switch, NextFloor, kFastFlatSpeed),
      movesFloor(22, Walk, NextFloor, kPlatformSpeed),
      movesFloor(95, Walk, NextFloor, kPlatformSpeed),
      movesFloor(20, Switch, NextFloor, kPlatformSpeed),
      movesFloor(68, Switch, NextFloor, kPlatformSpeed),
      movesFloor(47, Shot, NextFloor, kPlatformSpeed),
      movesFloor(5, Walk, LowestCeiling),
      movesFloor(91, Walk, LowestCeiling),
      movesFloor(101, Switch, LowestCeiling),
      movesFloor(64, Switch, LowestCeiling),
      movesFloor(24, Shot, LowestCeiling),
      movesFloor(56, Walk, BelowLowestCeiling),
      movesFloor(94, Walk, BelowLowestCeiling),
      movesFloor(55, Switch, BelowLowestCeiling),
      movesFloor(65, Switch, BelowLowestCeiling),
      movesFloor(58, Walk, Up24),
      movesFloor(92, Walk, Up24),
      movesFloor(59, Walk, Up24),
      movesFloor(93, Walk, Up24),
      movesFloor(15, Switch, Up24, kPlatformSpeed),
      movesFloor(66, Switch, Up24, kPlatformSpeed),
      movesFloor(14, Switch, Up32, kPlatformSpeed),
      movesFloor(67, Switch, Up32, kPlatformSpeed),
      movesFloor(140, Switch, Up512),
      movesFloor(53, Walk, LowestAndHighestFloor),
      movesFloor(87, Walk, LowestAndHighestFloor),
      movesFloor(30, Walk, LowerTexture),
      movesFloor(96, Walk, LowerTexture),
      movesFloor(9, Switch, Ring),

      movesCeiling(40, Walk, HighestCeiling),
      movesCeiling(41, Switch, OwnFloor),
      movesCeiling(43, Switch, OwnFloor),
      movesCeiling(44, Walk, AboveOwnFloor),
      movesCeiling(72, Walk, AboveOwnFloor),

      buildsStairs(8, Walk, Steps8, kUnitSpeed / 4),
      buildsStairs(7, Switch, Steps8, kUnitSpeed / 4),
      buildsStairs(100, Walk, Steps16, kFastFlatSpeed),
      buildsStairs(127, Switch, Steps16, kFastFlatSpeed),

      LineType{6, Crusher, Walk},
      LineType{25, Crusher, Walk},
      LineType{73, Crusher, Walk},
      LineType{77, Crusher, Walk},
      LineType{141, Crusher, Walk},
      LineType{49, Crusher, Switch},
      LineType{54, Stop, Walk},
      LineType{57, Stop, Walk},
      LineType{74, Stop, Walk},
      LineType{89, Stop, Walk},

      LineType{12, Light, Walk},
      LineType{13, Light, Walk},
      LineType{17, Light, Walk},
      LineType{35, Light, Walk},
      LineType{79, Light, Walk},
      LineType{80, Light, Walk},
      LineType{81, Light, Walk},
      LineType{104, Light, Walk},
      LineType{138, Light, Switch},
      LineType{139, Light, Switch},
      LineType{39, Teleport, Walk},
      LineType{97, Teleport, Walk},
      LineType{125, Teleport, Walk},
      LineType{126, Teleport, Walk},
      LineType{11, Exit, Switch},
      LineType{51, Exit, Switch},
      LineType{52, Exit, Walk},
      LineType{124, Exit, Walk},
      LineType{48, Scroll, Always},
  };
};

}  // namespace

std::span<const LineType> lineTypes() { return LineTable::kAll; }

const LineType* findLineType(std::uint16_t number) {
  const auto* found = std::ranges::find(LineTable::kAll, number, &LineType::number);
  return found == LineTable::kAll.end() ? nullptr : found;
}

}  // namespace hearth::doom
