#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace hearth::doom {

/// The light of something that shines, as lights at points; ...
struct Glow {
  std::string color = "#ffffff";
  double intensity = 255;  ///< levels
  double falloff = 0;      ///< per metre
  double reach = 10;       ///< metres, where it ends
  double height = 1;       ///< metres above the floor, of a thing
  double every = 2;        ///< metres between those of a surface
  double emit = 0;         ///< ... and as an emitter, in levels; 0: it is none
};

/// As lights files have them.
struct SkyGlow {
  std::optional<std::string> color;  ///< none: that of its image
  double intensity = 0;
};
struct SunGlow {
  double angle = 0;
  double pitch = 90;
  std::string color = "#ffffff";
  double intensity = 255;
  double size = 0;
};

/// What shines in maps, and how.
struct LightTable {
  std::map<std::uint16_t, Glow> things;  ///< by type
  std::map<std::string, Glow> walls;     ///< by texture
  std::map<std::string, Glow> flats;
  /// Of maps with a sky, where light comes from areas.
  SkyGlow sky;
  std::optional<SunGlow> sun;
};

/// light_table.json, which says what the format is. Errors are one sentence that begins with the
/// JSON pointer.
tl::expected<LightTable, std::string> parseLightTable(std::string_view json);

/// The one that the program comes with.
std::string_view ownLightTable();

}  // namespace hearth::doom
