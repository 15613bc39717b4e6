#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "level/bake_settings.h"
#include "level/light_source.h"
#include "level/mesh.h"
#include "level/mover.h"
#include "level/sprite.h"
#include "load/json/document.h"
#include "math/vec.h"

/// The contents of the files, each key with its type and default, and with names instead of ids.
/// Values that could not be read are already reported; a stand-in (`Unreadable`, an empty optional)
/// takes their place, so that later stages can find mistakes in the rest.
namespace hearth {

struct NameReference {
  std::string name;
  Place place;
};

struct TextureDescription {
  NameReference name;
  Vec2 scale = {1, 1};         ///< metres of one repeat
  Vec2 offset = {0, 0};        ///< texels
  double along = 0;            ///< metres
  std::optional<double> zRef;  ///< absolute, metres
};

struct Unreadable {};

struct SolidDescription {
  TextureDescription texture;
};

struct PortalDescription {
  NameReference next;
  std::optional<TextureDescription> upper;
  std::optional<TextureDescription> lower;
  std::optional<TextureDescription> maskedMiddle;
};

/// One texture of a switch, and the one in its place while the switch is on.
struct SwitchTextureDescription {
  NameReference off;
  NameReference on;
};

/// How a wall starts movers.
struct SwitchDescription {
  std::vector<NameReference> cross;          ///< of these, a player who walks through it
  std::vector<NameReference> use;            ///< of these, the use key in front of it
  std::vector<SwitchTextureDescription> on;  ///< textures while these are on their way
};

struct SubWallDescription {
  Place place;
  std::optional<double> z;  ///< its top, above the sector's floor
  Place zPlace;             ///< of `z`, else of the sub-wall
  std::variant<Unreadable, SolidDescription, PortalDescription> kind;
  std::shared_ptr<const SwitchDescription> switched{};  ///< null for most walls, which are many
};

struct StackDescription {
  std::vector<SubWallDescription> subWalls;  ///< bottom to top
};

struct WallDescription {
  Place place;
  std::variant<Unreadable, SolidDescription, PortalDescription, StackDescription> kind;
  std::shared_ptr<const SwitchDescription> switched{};  ///< null for most walls, which are many
};

struct LoopDescription {
  std::string name;
  Place place;
  std::vector<Vec2> vertices;          ///< empty when unreadable
  std::vector<Place> vertexPlaces;     ///< of each vertex' x
  std::vector<WallDescription> walls;  ///< one per vertex, or a single one for all

  const WallDescription& wall(std::size_t i) const {
    return walls.size() == 1 ? walls[0] : walls[i];
  }
  /// Of a wall, in words, as the file lists them.
  std::string ends(std::size_t wall) const;
};

/// Names the two sides of a flat portal.
struct FlatPortalDescription {
  NameReference up;
  NameReference down;
  Place place;
};

struct FlatDescription {
  Place place;
  Place zPlace;  ///< of `z`, else of the flat
  double z = 0;
  std::optional<TextureDescription> texture;
  bool isRelative = false;
  bool isSky = false;
  std::optional<FlatPortalDescription> next;
  bool isReadable = true;  ///< else a missing texture or height has been reported
};

struct SlopeDescription {
  Place place;
  std::vector<std::optional<double>> heights;  ///< of the wedge above each border vertex; metres
  std::vector<Place> heightPlaces;
  std::optional<TextureDescription> sidewall;
  bool isRelative = false;
};

struct SectorDescription {
  std::string name;
  Place place;  ///< of its key; in an array, of its `name`; in a grid, of its first cell
  std::optional<double> light;
  FlatDescription floor;
  FlatDescription ceiling;
  std::optional<SlopeDescription> slopeFloor;
  std::optional<SlopeDescription> slopeCeil;
  std::vector<LoopDescription> loops;
  bool hasReadableLoops = true;
  bool isOfGrid = false;  ///< places of its walls are in the legend
};

/// A face of a cell's square.
enum class GridSide : std::uint8_t { North, East, South, West };  // towards -y, +x, +y, -x
inline constexpr std::array<std::string_view, 4> kGridSideKeys{"n", "e", "s", "w"};

struct GridSolidDescription {
  TextureDescription wall;
  std::array<std::optional<TextureDescription>, 4> sides;  ///< by GridSide; wins over `wall`
};

/// Cells of a sector that the grid makes.
struct GridAirDescription {
  FlatDescription floor;
  FlatDescription ceiling;
  std::optional<double> light;
  // Of the steps of neighbours with a lower floor or a higher ceiling.
  std::optional<TextureDescription> upper;
  std::optional<TextureDescription> lower;
};

/// Cells of a sector that is written out; it is a portal with the steps' textures.
using GridNextDescription = PortalDescription;

/// What a character in the rows of a grid stands for.
struct LegendEntryDescription {
  std::string character;  ///< one code point in UTF-8
  Place place;            ///< of its value
  std::variant<Unreadable, GridSolidDescription, GridAirDescription, GridNextDescription> kind;

  bool isAir() const { return std::holds_alternative<GridAirDescription>(kind); }
};

struct GridDescription {
  static constexpr std::uint32_t kBlank = ~std::uint32_t{0};

  Place place;
  double cell = 1;  ///< metres
  Vec2 origin;
  std::vector<LegendEntryDescription> legend;
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<std::uint32_t> cells;  ///< index into `legend`, or kBlank; row by row
  std::vector<Place> places;         ///< of the cells' characters
};

struct PlayerDescription {
  Place place;
  std::optional<NameReference> sector;
  Vec3 eye;
  double angle = 0;     ///< degrees
  double height = 1.8;  ///< metres, as all that follow
  double eyeHeight = 1.6;
  double radius = 0.3;
  double stepHeight = 0.4;
};

/// Flats that move together.
struct MoverDescription {
  std::string name;
  Place place;  ///< of its key
  std::vector<NameReference> sectors;
  FlatPart part = FlatPart::Ceiling;
  double to = 0;
  Place toPlace;
  double speed = 1.5;
  std::optional<double> wait;
  MoverTrigger trigger = MoverTrigger::None;
  std::vector<NameReference> zones;
  bool isReadable = true;  ///< else a mistake has been reported
};

struct MoverShareDescription {
  NameReference mover;
  double share = 0;
};

struct ShotDescription {
  Place place;
  Place cameraPlace;
  std::string name;
  std::optional<NameReference> sector;
  Vec3 eye;
  double angle = 0;  ///< degrees, as all that follow
  double pitch = 0;
  double fov = 90;
  int width = 320;
  int height = 200;
  std::vector<MoverShareDescription> movers;
};

/// Where a thing stands.
struct ThingDescription {
  Place place;
  std::optional<NameReference> sector;
  Vec2 position;
  std::optional<double> z;  ///< absolute; else it stands on what is below it
};

struct SpriteDescription : ThingDescription {
  std::optional<Vec2> size;                        ///< metres; else 64 texels a metre
  std::vector<std::vector<NameReference>> frames;  ///< images, from each side
  Sprite sprite;                                   ///< all else
};

struct MeshDescription : ThingDescription {
  NameReference file;                    ///< OBJ, relative to the level file
  double angle = 0;                      ///< degrees
  Vec3 scale = {1, 1, 1};                ///< along the level's axes, before it is turned
  std::optional<NameReference> texture;  ///< of faces without a material
  Mesh mesh;                             ///< all else
};

/// Of a light with a place, of a sun, of the sky, or of an emitter.
struct LightDescription {
  Place place;
  std::optional<NameReference> sector;
  LightSource source;  ///< all but its sector
};

struct LevelDescription {
  Place place;
  std::string name;
  std::optional<NameReference> textures;  ///< folder
  std::optional<NameReference> lights;    ///< file
  std::optional<double> light;
  std::optional<PlayerDescription> player;
  std::vector<ShotDescription> shots;
  std::vector<SpriteDescription> sprites;
  std::vector<MeshDescription> meshes;
  std::vector<SectorDescription> sectors;
  std::optional<GridDescription> grid;
  std::vector<MoverDescription> movers;
  bool isReadable = true;  ///< else there is a grid that could not be read
};

struct LightsDescription {
  std::vector<LightDescription> lights;
  std::vector<LightDescription> suns;
  std::optional<LightDescription> sky;
  std::vector<LightDescription> emitters;
  BakeSettings bake;

  // Of all, in the order of the level's lights: those with a place, the suns, the sky, the
  // emitters.
  std::size_t firstSun() const { return lights.size(); }
  std::size_t firstSky() const { return firstSun() + suns.size(); }
  std::size_t firstEmitter() const { return firstSky() + (sky ? 1 : 0); }
  std::size_t count() const { return firstEmitter() + emitters.size(); }
  const LightDescription& at(std::size_t light) const {
    if (light < firstSun()) return lights[light];
    if (light < firstSky()) return suns[light - firstSun()];
    return light < firstEmitter() ? *sky : emitters[light - firstEmitter()];
  }
};

}  // namespace hearth
