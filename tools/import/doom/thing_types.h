#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hearth::doom {

/// A type of things, as Doom shows it while nothing happens to it
/// (https://doomwiki.org/wiki/Thing_types).
struct ThingType {
  std::uint16_t number;  ///< by which maps name the type
  const char* name;
  const char* sprite;  ///< the letters with which its images' names begin; empty: it is not seen
  /// The frames that it shows in turn: for each its letter, for how many tics it shows, and `*` if
  /// it has full brightness. A single frame has no tics.
  const char* idle;
  int radius = 0;  ///< map units
  int height = 0;  ///< map units
  bool isSolid = false;
  bool hangs = false;      ///< from the ceiling
  bool isMonster = false;  ///< games without monsters lack it
};

/// All types of Doom and Doom II.
std::span<const ThingType> thingTypes();
/// Null if there is no such type.
const ThingType* findThingType(std::uint16_t number);

/// What a type shows, in steps of equal time.
struct Animation {
  std::vector<char> frames;  ///< letters, at most `kMaxFrames`
  double framesPerSecond = 0;
  bool isBright = false;  ///< all of its frames are
};

inline constexpr int kMaxFrames = 16;

/// The steps last as long as fits all durations; if these were too many, the shortest time that
/// gives few enough, and durations are rounded to it.
Animation animationOf(const ThingType& type);

}  // namespace hearth::doom
