#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace hearth::doom {

/// The light of something that shines.
struct Glow {
  std::string color = "#ffffff";
  double intensity = 255;  ///< levels
  double falloff = 0;      ///< per metre
  double reach = 10;       ///< metres, where it ends
  double height = 1;       ///< metres above the floor, of a thing
  double every = 2;        ///< metres between those of a surface
};

/// What shines in maps, and how.
struct LightTable {
  std::map<std::uint16_t, Glow> things;  ///< by type
  std::map<std::string, Glow> walls;     ///< by texture
  std::map<std::string, Glow> flats;
};

/// light_table.json, which says what the format is. Errors are one sentence that begins with the
/// JSON pointer.
tl::expected<LightTable, std::string> parseLightTable(std::string_view json);

/// The one that the program comes with.
std::string_view ownLightTable();

}  // namespace hearth::doom
