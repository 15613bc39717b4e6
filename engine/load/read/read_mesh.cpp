#include <array>
#include <utility>

#include "load/json/fields.h"
#include "load/read/read.h"

namespace hearth {

namespace {

constexpr NumberRange kMeshScale{1e-6, kWorldLimit};

constexpr std::array<std::string_view, 12> kMeshKeys{"name",    "mesh",     "x",     "y",
                                                     "z",       "sector",   "angle", "scale",
                                                     "texture", "twoSided", "solid", "shadow"};
/// Found in a mesh, and of sprites.
constexpr std::array<std::string_view, 7> kSpriteKeysAlone{"fps",    "size",   "offset", "facing",
                                                           "bright", "radius", "height"};
constexpr MisplacedKeys kOfSprites{kSpriteKeysAlone, "remove it, only sprites have \"{}\""};

/// A number for all axes, or one for each.
void readScale(Report& report, JsonValue value, Vec3& scale) {
  if (value.isArray()) {
    const auto numbers = readNumbers(report, value, 3, kMeshScale);
    if (numbers) scale = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  } else if (value.isNumber()) {
    const double factor = readNumber(report, value, kMeshScale).value_or(1);
    scale = {factor, factor, factor};
  } else {
    reportWrongType(report, value, "a number or [x, y, z]");
  }
}

}  // namespace

std::optional<MeshDescription> readMesh(Report& report, JsonValue value) {
  const Fields fields(report, value, kMeshKeys, kOfSprites);
  MeshDescription mesh;
  bool isGood = readThingPosition(report, fields, mesh);
  const auto file = fields.require("mesh", "name the OBJ file of its model");
  const auto reference = file ? readReference(report, *file) : std::nullopt;
  if (const auto name = fields.find("name")) mesh.mesh.name = readName(report, *name).value_or("");
  fields.read("angle", kAngle, mesh.angle);
  if (const auto scale = fields.find("scale")) readScale(report, *scale, mesh.scale);
  if (const auto texture = fields.find("texture")) mesh.texture = readReference(report, *texture);
  fields.read("twoSided", mesh.mesh.isTwoSided);
  fields.read("solid", mesh.mesh.isSolid);
  fields.read("shadow", mesh.mesh.castsShadow);
  if (!isGood || !reference) return std::nullopt;
  mesh.file = *reference;
  return mesh;
}

}  // namespace hearth
