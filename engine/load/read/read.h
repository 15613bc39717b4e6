#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "load/json/document.h"
#include "load/json/fields.h"
#include "load/json/report.h"
#include "load/limits.h"
#include "load/read/description.h"

namespace hearth {

/// Documents -> descriptions. All mistakes in keys, types and ranges of single values are reported
/// here, those that need more than one value later.
LevelDescription readLevel(Report& report, JsonValue root, const LoadLimits& limits);
LightsDescription readLights(Report& report, JsonValue root, const LoadLimits& limits);

/// Parts of the above, a file each.
enum class TextureUse { OnWall, OnFlat };
inline constexpr std::array<std::string_view, 5> kTextureKeys{"name", "scale", "offset", "along",
                                                              "zref"};  ///< of an object
std::optional<TextureDescription> readTexture(Report& report, JsonValue value, TextureUse use);
/// Reads the texture of a wall under `key` into `target`; false after a mistake.
bool readOptionalTexture(Report& report, const Fields& fields, std::string_view key,
                         std::optional<TextureDescription>& target);
WallDescription readWall(Report& report, JsonValue value);
/// The floor or ceiling under `key`.
FlatDescription readFlat(Report& report, const Fields& sector, std::string_view key,
                         double defaultZ);
inline constexpr double kFloorZ = 0;    ///< where a floor gives no "z"; metres
inline constexpr double kCeilingZ = 4;  ///< likewise
void reportTooManyVertices(Report& report, Place place, std::size_t limit);
/// What the limit of vertices still allows.
struct VertexBudget {
  std::size_t limit;
  std::size_t left = limit;
  bool isExceeded = false;  ///< reported once; the loops that follow are left out
};
SectorDescription readSector(Report& report, NameReference name, JsonValue value,
                             VertexBudget& budget);
/// None after a mistake that leaves cells without an entry.
std::optional<GridDescription> readGrid(Report& report, JsonValue value, const LoadLimits& limits);
void readThings(Report& report, JsonValue value, const LoadLimits& limits, LevelDescription& level);
/// What the limit of sprites' images still allows.
struct ImageBudget {
  std::size_t limit;
  std::size_t left = limit;
  bool isExceeded = false;  ///< reported once; the sprites that follow are left out
};
/// Whether a budget has room for so many images; reported at `value` if it has not.
bool allowsImages(Report& report, JsonValue value, std::size_t images, ImageBudget& budget);
std::optional<SpriteDescription> readSprite(Report& report, JsonValue value, ImageBudget& budget);
std::optional<MeshDescription> readMesh(Report& report, JsonValue value);
/// Reads where a thing stands. False after a mistake.
bool readThingPosition(Report& report, const Fields& fields, ThingDescription& thing);
std::optional<NameReference> readReference(Report& report, JsonValue value);
/// A name, or an array of names, each once.
std::vector<NameReference> readReferences(Report& report, JsonValue value);
void readMovers(Report& report, JsonValue value, LevelDescription& level);
/// Reads `sector`, if it is given. False after a mistake.
bool readSectorName(Report& report, const Fields& fields, std::optional<NameReference>& target);
inline constexpr NumberRange kAngle{-1e6, 1e6};  ///< degrees

}  // namespace hearth
