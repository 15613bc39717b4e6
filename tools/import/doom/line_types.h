#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace hearth::doom {

/// What lines of a type do.
enum class LineKind : std::uint8_t {
  Door,
  Lift,
  Floor,
  Ceiling,
  Stairs,
  Crusher,
  Stop,  ///< of a platform or a crusher that goes on for ever
  Light,
  Teleport,
  Exit,
  Scroll,
};

/// How a player starts it, in the letters of Doom's tables.
enum class Activation : std::uint8_t {
  Push,    ///< D: the use key in front of the line; what moves is the sector behind it
  Switch,  ///< S: the use key in front of the line
  Walk,    ///< W: crossing the line, from either side
  Shot,    ///< G: shooting at it
  Always,  ///< nothing: it begins with the map
};

/// Where the flat stops, from the heights around as the map begins.
enum class Destination : std::uint8_t {
  None,
  // Ceilings
  DoorTop,  ///< a little below the lowest ceiling around
  OwnFloor,
  AboveOwnFloor,  ///< 8 units
  HighestCeiling,
  // Floors
  LowestFloor,
  HighestFloor,
  AboveHighestFloor,   ///< 8 units
  NextFloor,           ///< the lowest of those above its own
  LowestCeiling,       ///< but no higher than its own
  BelowLowestCeiling,  ///< 8 units below that
  Up24,
  Up32,
  Up512,
  // Of floors that Hearth cannot move
  LowestAndHighestFloor,  ///< up and down for ever
  LowerTexture,           ///< up by the lowest texture around
  Ring,                   ///< with the sectors around it, to the floor beyond
  // Stairs
  Steps8,
  Steps16,
};

/// A type of lines (https://doomwiki.org/wiki/Linedef_type).
struct LineType {
  std::uint16_t number;  ///< by which maps name the type
  LineKind kind;
  Activation activation;
  Destination destination = Destination::None;
  double speed = 0;                 ///< metres a second
  std::optional<double> wait = {};  ///< seconds until it returns; none: it stays
};

/// All types of Doom and Doom II.
std::span<const LineType> lineTypes();
/// Null if there is no such type.
const LineType* findLineType(std::uint16_t number);

}  // namespace hearth::doom
