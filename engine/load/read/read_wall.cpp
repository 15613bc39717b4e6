#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <utility>

#include "load/json/fields.h"
#include "load/read/read.h"

namespace hearth {

namespace {

constexpr std::array<std::string_view, 9> kWallKeys{"texture", "next", "upper", "lower", "middle",
                                                    "walls",   "use",  "on",    "cross"};
constexpr std::array<std::string_view, 10> kSubWallKeys{
    "texture", "next", "upper", "lower", "middle", "walls", "use", "on", "cross", "z"};
/// Those that only a wall that leads somewhere has.
constexpr std::array<std::string_view, 3> kPortalTextures{"upper", "lower", "middle"};
constexpr std::array<std::string_view, 4> kPortalKeys{"upper", "lower", "middle", "cross"};

constexpr MisplacedKeys kOfTextures{
    kTextureKeys, "give it to a texture: {{ \"texture\": {{ .., \"{}\": .. }} }}"};

std::optional<PortalDescription> readPortal(Report& report, const Fields& fields, JsonValue next) {
  PortalDescription portal;
  std::optional<TextureDescription> both;
  bool isGood = readOptionalTexture(report, fields, "texture", both);
  isGood &= readOptionalTexture(report, fields, "upper", portal.upper);
  isGood &= readOptionalTexture(report, fields, "lower", portal.lower);
  isGood &= readOptionalTexture(report, fields, "middle", portal.maskedMiddle);
  if (fields.find("texture") && (fields.find("upper") || fields.find("lower"))) {
    report.error(fields.find("texture")->place(), "\"texture\" beside \"upper\" or \"lower\"",
                 "give either one texture for both steps or one for each");
    isGood = false;
  }
  isGood &= !fields.isMisspelled("texture") &&
            std::ranges::none_of(kPortalTextures,
                                 [&](std::string_view key) { return fields.isMisspelled(key); });
  const std::optional<NameReference> reference = readReference(report, next);
  if (!isGood || !reference) return std::nullopt;
  portal.next = *reference;
  if (both) portal.upper = portal.lower = both;
  return portal;
}

/// Whether there are any.
bool refusePortalKeys(Report& report, const Fields& fields) {
  bool areThere = false;
  for (const std::string_view key : kPortalKeys)
    if (const std::optional<JsonValue> value = fields.find(key)) {
      areThere = true;
      report.error(value->place(), fmt::format("\"{}\" on a wall that leads nowhere", key),
                   "give \"next\" for a portal, or \"texture\" for a solid wall");
    }
  return areThere;
}

/// The solid or portal that `fields` describe, as one of the alternatives of `Kind`.
template <typename Kind>
Kind readSolidOrPortal(Report& report, const Fields& fields) {
  if (!fields.isObject()) return Unreadable{};
  if (const std::optional<JsonValue> next = fields.find("next")) {
    if (auto portal = readPortal(report, fields, *next)) return *std::move(portal);
    return Unreadable{};
  }
  if (refusePortalKeys(report, fields)) return Unreadable{};
  const auto value = fields.require("texture", "give a wall \"texture\", \"next\" or \"walls\"");
  const auto texture = value ? readTexture(report, *value, TextureUse::OnWall) : std::nullopt;
  if (!texture) return Unreadable{};
  return SolidDescription{*texture};
}

std::vector<SwitchTextureDescription> readSwitchTextures(Report& report, JsonValue on) {
  std::vector<SwitchTextureDescription> textures;
  if (!on.isObject()) {
    reportWrongType(report, on, "an object of textures by texture");
    return textures;
  }
  for (const JsonValue::Member& member : on.members()) {
    const NameReference off{std::string(member.key.text()), member.key.place()};
    if (auto shown = readReference(report, member.value)) textures.push_back({off, *shown});
  }
  return textures;
}

/// Null where it starts none.
std::shared_ptr<const SwitchDescription> readSwitch(Report& report, const Fields& fields) {
  const auto cross = fields.find("cross");
  const auto use = fields.find("use");
  const auto on = fields.find("on");
  if (on && !use)
    report.error(on->place(), "\"on\" on a wall without \"use\"",
                 "name the movers that the wall starts");
  if (!cross && !use) return nullptr;
  SwitchDescription description;
  if (cross) description.cross = readReferences(report, *cross);
  if (use) description.use = readReferences(report, *use);
  if (use && on) description.on = readSwitchTextures(report, *on);
  return std::make_shared<const SwitchDescription>(std::move(description));
}

SubWallDescription readSubWall(Report& report, JsonValue value) {
  const Fields fields(report, value, kSubWallKeys, kOfTextures);
  SubWallDescription subWall{value.place(), std::nullopt, value.place(), {}};
  bool isGood = true;
  if (const std::optional<JsonValue> z = fields.find("z")) {
    subWall.zPlace = z->place();
    isGood = fields.read("z", kCoordinate, subWall.z);
  }
  if (const std::optional<JsonValue> walls = fields.find("walls")) {
    report.error(walls->place(), "a stack inside a stack", "put its walls into the outer one");
    return subWall;
  }
  subWall.kind = readSolidOrPortal<decltype(subWall.kind)>(report, fields);
  if (!isGood) subWall.kind = Unreadable{};
  subWall.switched = readSwitch(report, fields);
  return subWall;
}

std::optional<StackDescription> readStack(Report& report, const Fields& fields, JsonValue walls) {
  for (const std::string_view key : {"texture", "next", "upper", "lower", "middle", "cross"})
    if (const std::optional<JsonValue> value = fields.find(key))
      report.error(value->place(), fmt::format("\"{}\" beside \"walls\"", key),
                   "give it to the walls of the stack");
  if (!walls.isArray()) {
    reportWrongType(report, walls, "an array of walls");
    return std::nullopt;
  }
  StackDescription stack;
  for (const JsonValue wall : walls.elements()) stack.subWalls.push_back(readSubWall(report, wall));
  if (!stack.subWalls.empty()) return stack;
  report.error(walls.place(), "a stack without walls", "give at least one");
  return std::nullopt;
}

}  // namespace

bool readOptionalTexture(Report& report, const Fields& fields, std::string_view key,
                         std::optional<TextureDescription>& target) {
  const std::optional<JsonValue> value = fields.find(key);
  if (!value) return true;
  target = readTexture(report, *value, TextureUse::OnWall);
  return target.has_value();
}

std::optional<NameReference> readReference(Report& report, JsonValue value) {
  std::optional<std::string> name = readName(report, value);
  if (!name) return std::nullopt;
  return NameReference{*std::move(name), value.place()};
}

std::vector<NameReference> readReferences(Report& report, JsonValue value) {
  if (!value.isString() && !value.isArray()) {
    reportWrongType(report, value, "a name, or an array of names");
    return {};
  }
  std::vector<NameReference> names;
  std::set<std::string> seen;
  for (const JsonValue element :
       value.isArray() ? value.elements() : std::vector<JsonValue>{value}) {
    std::optional<NameReference> name = readReference(report, element);
    if (!name) continue;
    if (seen.insert(name->name).second)
      names.push_back(*std::move(name));
    else
      report.error(name->place, fmt::format("\"{}\" is named twice", name->name), "name it once");
  }
  return names;
}

bool readSectorName(Report& report, const Fields& fields, std::optional<NameReference>& target) {
  const std::optional<JsonValue> value = fields.find("sector");
  if (!value) return true;
  target = readReference(report, *value);
  return target.has_value();
}

WallDescription readWall(Report& report, JsonValue value) {
  const Fields fields(report, value, kWallKeys, kOfTextures);
  WallDescription wall{value.place(), {}};
  if (const std::optional<JsonValue> walls = fields.find("walls")) {
    if (auto stack = readStack(report, fields, *walls)) wall.kind = *std::move(stack);
  } else {
    wall.kind = readSolidOrPortal<decltype(wall.kind)>(report, fields);
  }
  wall.switched = readSwitch(report, fields);
  return wall;
}

}  // namespace hearth
