#include <fmt/format.h>

#include <array>
#include <map>

#include "load/json/fields.h"
#include "load/read/read.h"

namespace hearth {

namespace {

constexpr NumberRange kPitch{-60, 60};
constexpr NumberRange kFov{1, 179};
constexpr NumberRange kPixels{1, 16384};  // of a picture's side

constexpr std::array<std::string_view, 11> kLevelKeys{"version", "name",   "textures", "lights",
                                                      "light",   "player", "shots",    "things",
                                                      "sectors", "grid",   "movers"};
constexpr std::array<std::string_view, 9> kPlayerKeys{"sector", "x",   "y",      "z",   "angle",
                                                      "height", "eye", "radius", "step"};
constexpr std::array<std::string_view, 6> kShotKeys{"name", "camera", "fov",
                                                    "size", "sector", "movers"};

void checkBody(Report& report, JsonValue value, const PlayerDescription& player) {
  if (player.eyeHeight > player.height)
    report.error(value.place(),
                 fmt::format("the eye is {} m above the feet of a body of {} m", player.eyeHeight,
                             player.height),
                 "lower \"eye\" or raise \"height\"");
}

std::optional<PlayerDescription> readPlayer(Report& report, JsonValue value) {
  constexpr NumberRange kBody{1e-6, kWorldLimit};
  const Fields fields(report, value, kPlayerKeys);
  PlayerDescription player;
  player.place = value.place();
  bool isGood = fields.isObject() && readSectorName(report, fields, player.sector);
  for (const std::string_view key : {"x", "y", "z"})
    isGood &= fields.require(key, "give the position of the eye").has_value();
  isGood &= fields.read("x", kCoordinate, player.eye.x);
  isGood &= fields.read("y", kCoordinate, player.eye.y);
  isGood &= fields.read("z", kCoordinate, player.eye.z);
  fields.read("angle", kAngle, player.angle);
  bool isBodyGood = fields.read("height", kBody, player.height);
  isBodyGood &= fields.read("eye", kBody, player.eyeHeight);
  fields.read("radius", kBody, player.radius);
  fields.read("step", kLength, player.stepHeight);
  if (isBodyGood) checkBody(report, value, player);
  return isGood ? std::optional(player) : std::nullopt;
}

bool readCamera(Report& report, JsonValue value, ShotDescription& shot) {
  shot.cameraPlace = value.place();
  const auto numbers = readNumbers(report, value, 5, {-kWorldLimit, kWorldLimit});
  if (!numbers) return false;
  shot.eye = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  shot.angle = (*numbers)[3];
  shot.pitch = (*numbers)[4];
  return readNumber(report, value.elements()[4], kPitch).has_value();
}

void readSize(Report& report, JsonValue value, ShotDescription& shot) {
  if (!readNumbers(report, value, 2, kPixels)) return;
  const std::vector<JsonValue> sides = value.elements();
  shot.width = readInteger(report, sides[0], kPixels).value_or(shot.width);
  shot.height = readInteger(report, sides[1], kPixels).value_or(shot.height);
}

void readShotMovers(Report& report, JsonValue value, ShotDescription& shot) {
  if (!value.isObject())
    return reportWrongType(report, value, "an object: the share (0..1) of each mover by its name");
  for (const JsonValue::Member& member : value.members())
    if (const auto share = readNumber(report, member.value, {0, 1}))
      shot.movers.push_back({{std::string(member.key.text()), member.key.place()}, *share});
}

std::optional<ShotDescription> readShot(Report& report, JsonValue value) {
  const Fields fields(report, value, kShotKeys);
  ShotDescription shot;
  shot.place = value.place();
  bool isGood = fields.isObject() && readSectorName(report, fields, shot.sector);
  fields.read("fov", kFov, shot.fov);
  if (const auto size = fields.find("size")) readSize(report, *size, shot);
  if (const auto movers = fields.find("movers")) readShotMovers(report, *movers, shot);
  if (const auto name = fields.require("name", "name the shot"))
    shot.name = readName(report, *name).value_or("");
  const auto camera = fields.require("camera", "give [x, y, z, angle, pitch]");
  isGood &= camera && readCamera(report, *camera, shot);
  return isGood ? std::optional(shot) : std::nullopt;
}

void readShots(Report& report, JsonValue value, LevelDescription& level) {
  if (!value.isArray()) return reportWrongType(report, value, "an array of shots");
  std::map<std::string, std::size_t> seen;
  for (const JsonValue element : value.elements()) {
    const std::optional<ShotDescription> shot = readShot(report, element);
    if (!shot) continue;
    if (!shot->name.empty() && !seen.emplace(shot->name, level.shots.size()).second)
      report.error(element.place(), fmt::format("two shots are named \"{}\"", shot->name),
                   "rename one of them");
    level.shots.push_back(*shot);
  }
}

void readSectors(Report& report, JsonValue value, const LoadLimits& limits,
                 LevelDescription& level) {
  VertexBudget budget{limits.vertices};
  for (const JsonValue::Member& child : namedChildren(report, value, "sectors"))
    level.sectors.push_back(readSector(report, {std::string(child.key.text()), child.key.place()},
                                       child.value, budget));
}

bool isEmpty(JsonValue value) {
  return (value.isObject() && value.members().empty()) || (value.isArray() && value.size() == 0);
}

/// A level names its lights, if it does, and has sectors.
bool isLightsFile(JsonValue root) {
  bool hasLights = false;
  bool hasSectors = false;
  if (root.isObject())
    for (const JsonValue::Member& member : root.members()) {
      hasLights |= member.key.text() == "lights" && member.value.isArray();
      hasSectors |= member.key.text() == "sectors" || member.key.text() == "grid";
    }
  return hasLights && !hasSectors;
}

std::optional<NameReference> readLightsFile(Report& report, JsonValue value) {
  if (!value.isArray()) return readReference(report, value);
  report.error(value.place(), "lights in the level instead of the name of their file",
               "write them into a file of their own, LEVEL.lights.json, and remove this");
  return std::nullopt;
}

}  // namespace

LevelDescription readLevel(Report& report, JsonValue root, const LoadLimits& limits) {
  if (isLightsFile(root)) {
    report.error(root.place(), "a lights file instead of a level",
                 "name the level that it belongs to");
    return {};
  }
  const Fields fields(report, root, kLevelKeys);
  LevelDescription level;
  level.place = root.place();
  checkVersion(report, fields);
  if (const auto name = fields.find("name")) level.name = readName(report, *name).value_or("");
  if (const auto textures = fields.find("textures"))
    level.textures = readReference(report, *textures);
  if (const auto lights = fields.find("lights")) level.lights = readLightsFile(report, *lights);
  fields.read("light", {0, 1}, level.light);
  if (const auto player = fields.find("player")) level.player = readPlayer(report, *player);
  if (const auto shots = fields.find("shots")) readShots(report, *shots, level);
  if (const auto things = fields.find("things")) readThings(report, *things, limits, level);
  const std::optional<JsonValue> grid = fields.find("grid");
  const auto sectors = grid ? fields.find("sectors")
                            : fields.require("sectors", "give at least one sector, or a \"grid\"");
  if (sectors && isEmpty(*sectors) && !grid)
    report.error(sectors->place(), "a level without sectors", "give at least one, or a \"grid\"");
  if (sectors) readSectors(report, *sectors, limits, level);
  if (grid) level.grid = readGrid(report, *grid, limits);
  if (const auto movers = fields.find("movers")) readMovers(report, *movers, level);
  level.isReadable = !grid || level.grid;
  return level;
}

}  // namespace hearth
