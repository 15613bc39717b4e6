#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "import/doom/wad.h"

namespace hearth::doom {

// The records of a map as its lumps hold them (https://doomwiki.org/wiki/Linedef and its
// neighbours). Lengths are in map units, y grows up, and angles turn left. All indices are valid.

struct Vertex {
  int x;
  int y;
};

/// In the place of a texture's name where there is none.
inline constexpr const char* kNoTexture = "-";

/// The flat that stands for the sky.
inline constexpr const char* kSkyFlat = "F_SKY1";

/// One side of a line: what it wears.
struct Side {
  int xOffset;
  int yOffset;
  std::string upper;
  std::string lower;
  std::string middle;
  std::uint32_t sector;
};

struct Line {
  std::uint32_t from;
  std::uint32_t to;
  std::uint16_t flags;
  std::uint16_t special;
  std::uint16_t tag;
  /// By index into the map's sides: on the right, as seen from its beginning, and on the left.
  std::array<std::optional<std::uint32_t>, 2> sides;

  /// The upper texture hangs from the ceiling instead of standing on its lower edge.
  bool isUpperUnpegged() const { return (flags & 0x08) != 0; }
  /// The lower texture hangs from the ceiling, the middle one stands on the floor.
  bool isLowerUnpegged() const { return (flags & 0x10) != 0; }
};

struct Sector {
  int floor;
  int ceiling;
  std::string floorFlat;
  std::string ceilingFlat;
  int light;  ///< 0..255
  std::uint16_t special;
  std::uint16_t tag;
};

struct Thing {
  int x;
  int y;
  int angle;  ///< degrees, 0 to the east
  std::uint16_t type;
  std::uint16_t flags;
};

struct Map {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<Line> lines;
  std::vector<Side> sides;
  std::vector<Sector> sectors;
  std::vector<Thing> things;
};

/// What is wrong with a WAD in which there are none.
inline constexpr std::string_view kNoMaps = "there are no maps of Doom's own format in it";

/// The maps of a WAD, in its order.
std::vector<std::string> mapNames(const Wad& wad);

/// Errors are one sentence; it names what must be mended.
tl::expected<Map, std::string> readMap(const Wad& wad, std::string_view name);

}  // namespace hearth::doom
