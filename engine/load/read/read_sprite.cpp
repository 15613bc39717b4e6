#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "load/json/fields.h"
#include "load/read/read.h"
#include "load/suggest.h"

namespace hearth {

namespace {

constexpr NumberRange kSize{1e-6, kWorldLimit};  // metres
constexpr NumberRange kFramesPerSecond{1e-6, 1000};

constexpr std::array<std::string_view, 15> kSpriteKeys{
    "name",  "sprite", "frames", "fps",    "x",      "y",      "z",     "sector",
    "angle", "size",   "offset", "facing", "bright", "radius", "height"};
/// Found in a sprite, and of meshes.
constexpr std::array<std::string_view, 5> kMeshKeysAlone{"scale", "texture", "twoSided", "solid",
                                                         "shadow"};
constexpr MisplacedKeys kOfMeshes{kMeshKeysAlone, "remove it, only meshes have \"{}\""};

/// The images of one frame: a name, or one for each side from which it can be seen.
std::vector<NameReference> readViews(Report& report, JsonValue value, ImageBudget& budget) {
  if (!value.isString() && !value.isArray()) {
    reportWrongType(report, value, "an image's name, or a list of them");
    return {};
  }
  const std::size_t count = value.isArray() ? value.size() : 1;
  if (!allowsImages(report, value, count, budget)) return {};
  budget.left -= count;
  std::vector<NameReference> views;
  const std::vector<JsonValue> names =
      value.isArray() ? value.elements() : std::vector<JsonValue>{value};
  bool isGood = true;
  for (const JsonValue name : names) {
    const std::optional<NameReference> view = readReference(report, name);
    isGood &= view.has_value();
    if (view) views.push_back(*view);
  }
  if (names.empty()) report.error(value.place(), "no image", "name at least one");
  return isGood ? views : std::vector<NameReference>{};
}

void readFrames(Report& report, JsonValue value, ImageBudget& budget, const Fields& fields,
                SpriteDescription& sprite) {
  if (!value.isArray()) return reportWrongType(report, value, "a list of frames");
  if (!allowsImages(report, value, value.size(), budget)) return;
  for (const JsonValue frame : value.elements())
    sprite.frames.push_back(readViews(report, frame, budget));
  if (sprite.frames.empty()) report.error(value.place(), "no frame", "give at least one");
  if (fields.require("fps", "say how many frames a second show"))
    fields.read("fps", kFramesPerSecond, sprite.sprite.framesPerSecond);
}

/// Reads `sprite` or, in its place, `frames` and `fps`. False after a mistake.
bool readImages(Report& report, const Fields& fields, ImageBudget& budget,
                SpriteDescription& sprite) {
  const std::optional<JsonValue> frames = fields.find("frames");
  if (frames) {
    if (const std::optional<JsonValue> still = fields.find("sprite"))
      report.error(still->place(), "\"sprite\" beside \"frames\"", "give one of them");
    readFrames(report, *frames, budget, fields, sprite);
  } else {
    if (const std::optional<JsonValue> rate = fields.find("fps"))
      report.error(rate->place(), "\"fps\" without \"frames\"",
                   "give the images as \"frames\", or remove it");
    const std::optional<JsonValue> still =
        fields.require("sprite", "name its image, or its model as \"mesh\"");
    if (!still) return false;
    sprite.frames.push_back(readViews(report, *still, budget));
  }
  for (const std::vector<NameReference>& views : sprite.frames)
    if (views.empty()) return false;
  return !sprite.frames.empty();
}

void readFacing(Report& report, JsonValue value, Facing& facing) {
  constexpr std::array<std::string_view, 3> kNames{"camera", "angle", "flat"};  // by Facing
  if (!value.isString()) return reportWrongType(report, value, "\"camera\", \"angle\" or \"flat\"");
  const auto found = std::ranges::find(kNames, value.text());
  if (found == kNames.end())
    report.error(value.place(), fmt::format("\"{}\" is no facing", value.text()),
                 suggest(value.text(), kNames, ""));
  else
    facing = static_cast<Facing>(found - kNames.begin());
}

void readBody(Report& report, const Fields& fields, Sprite& sprite) {
  const std::optional<JsonValue> radius = fields.find("radius");
  const std::optional<JsonValue> height = fields.find("height");
  if (radius && height) {
    sprite.body.emplace();
    fields.read("radius", kSize, sprite.body->radius);
    fields.read("height", kSize, sprite.body->height);
  } else if (radius || height) {
    report.error((radius ? radius : height)->place(),
                 radius ? "\"radius\" without \"height\"" : "\"height\" without \"radius\"",
                 "give both, or neither");
  }
}

}  // namespace

bool allowsImages(Report& report, JsonValue value, std::size_t images, ImageBudget& budget) {
  if (budget.isExceeded) return false;
  budget.isExceeded = images > budget.left;
  if (budget.isExceeded)
    report.error(value.place(), fmt::format("more than {} images of sprites", budget.limit),
                 "raise the limit with --max-sprite-images");
  return !budget.isExceeded;
}

std::optional<SpriteDescription> readSprite(Report& report, JsonValue value, ImageBudget& budget) {
  const Fields fields(report, value, kSpriteKeys, kOfMeshes);
  SpriteDescription sprite;
  bool isGood = readThingPosition(report, fields, sprite);
  isGood &= fields.isObject() && readImages(report, fields, budget, sprite);
  if (const auto name = fields.find("name"))
    sprite.sprite.name = readName(report, *name).value_or("");
  fields.read("angle", kAngle, sprite.sprite.angle);
  if (const auto size = fields.find("size")) {
    Vec2 metres;
    if (fields.read("size", kSize, metres)) sprite.size = metres;
  }
  fields.read("offset", kCoordinate, sprite.sprite.offset);
  if (const auto facing = fields.find("facing")) readFacing(report, *facing, sprite.sprite.facing);
  fields.read("bright", sprite.sprite.isBright);
  readBody(report, fields, sprite.sprite);
  return isGood ? std::optional(std::move(sprite)) : std::nullopt;
}

}  // namespace hearth
