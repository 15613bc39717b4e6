#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "load/json/fields.h"
#include "load/read/read.h"
#include "load/suggest.h"

namespace hearth {

namespace {

/// Says what a thing is.
constexpr std::array<std::string_view, 3> kKindKeys{"mesh", "sprite", "frames"};

bool hasKey(const std::vector<JsonValue::Member>& members, std::string_view key) {
  return std::ranges::any_of(
      members, [&](const JsonValue::Member& member) { return member.key.text() == key; });
}

/// By the key that says so. Where none does, by "model", which other formats have, or by a slip.
bool isMesh(JsonValue thing) {
  if (!thing.isObject()) return false;
  const std::vector<JsonValue::Member> members = thing.members();
  if (hasKey(members, "mesh")) return true;
  if (hasKey(members, "sprite") || hasKey(members, "frames")) return false;
  if (hasKey(members, "model")) return true;
  return std::ranges::any_of(members, [](const JsonValue::Member& member) {
    return nearestName(member.key.text(), kKindKeys) == "mesh";
  });
}

/// A mesh that is a sprite, too: which of its other keys are right depends on what is meant.
bool refuseTwoKinds(Report& report, JsonValue mesh) {
  for (const JsonValue::Member& member : mesh.members()) {
    const std::string_view key = member.key.text();
    if (key != "sprite" && key != "frames") continue;
    report.error(member.value.place(), fmt::format("\"{}\" beside \"mesh\"", key),
                 "give one of them");
    return true;
  }
  return false;
}

}  // namespace

bool readThingPosition(Report& report, const Fields& fields, ThingDescription& thing) {
  thing.place = fields.value().place();
  bool isGood = fields.isObject() && readSectorName(report, fields, thing.sector);
  for (const std::string_view key : {"x", "y"})
    isGood &= fields.require(key, "give the thing's position").has_value();
  isGood &= fields.read("x", kCoordinate, thing.position.x);
  isGood &= fields.read("y", kCoordinate, thing.position.y);
  isGood &= fields.read("z", kCoordinate, thing.z);
  return isGood;
}

void readThings(Report& report, JsonValue value, const LoadLimits& limits,
                LevelDescription& level) {
  if (!value.isArray()) return reportWrongType(report, value, "an array of things");
  const std::size_t most = limits.spriteImages + limits.meshFaces;
  if (value.size() > most)
    return report.error(value.place(), fmt::format("{} things, more than {}", value.size(), most),
                        "raise the limits with --max-sprite-images or --max-mesh-faces");
  const std::vector<JsonValue> things = value.elements();
  const auto meshes = static_cast<std::size_t>(std::ranges::count_if(things, isMesh));
  // Each has at least an image or a face.
  ImageBudget budget{limits.spriteImages};
  if (!allowsImages(report, value, things.size() - meshes, budget)) return;
  if (meshes > limits.meshFaces)
    return report.error(value.place(),
                        fmt::format("{} meshes, more than {}", meshes, limits.meshFaces),
                        "raise the limit with --max-mesh-faces");
  for (std::uint32_t i = 0; i < things.size(); ++i) {
    if (!isMesh(things[i])) {
      if (auto sprite = readSprite(report, things[i], budget)) {
        sprite->sprite.thing = i;
        level.sprites.push_back(*std::move(sprite));
      }
    } else if (!refuseTwoKinds(report, things[i])) {
      if (auto mesh = readMesh(report, things[i])) {
        mesh->mesh.thing = i;
        level.meshes.push_back(*std::move(mesh));
      }
    }
  }
}

}  // namespace hearth
