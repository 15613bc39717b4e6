#include "model/model_air.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "load/json/fields.h"
#include "load/link/place_model.h"

namespace hearth {

namespace {

using AirJson = nlohmann::ordered_json;

/// Twice as far as a camera goes: the model may be tall, and the camera high.
constexpr double kAirRadii = 2 * kFarthestRadii;

/// Metres. Texels of light are at least kSmallestTexel long: a smaller model would have too few.
constexpr double kSmallestRadius = 1e-5;

/// Pale: dark models and white ones in the light stand out.
constexpr const char* kSkyColor = "#c8d0d8";

/// All faces have this at least. In shares of full brightness.
constexpr double kAmbient = 0.22;

/// A light, so far away that its rays are nearly parallel.
struct Lamp {
  Vec3 direction;    ///< from the model to it; the front is the side of +y
  double intensity;  ///< in levels
};
/// The first is the sun: high, and to the left of a camera in front. The other one lightens the
/// shade.
constexpr Lamp kLamps[] = {{{-0.5, 0.55, 0.67}, 200}, {{0.85, -0.1, -0.52}, 60}};
constexpr double kLampRadii = 15;

/// Texels along the diagonal of the model's box.
constexpr double kTexelsAcross = 200;
constexpr double kSmallestTexel = 1e-6;  // metres, what a lights file may say

AirJson sky(double z) { return {{"z", z}, {"texture", kSkyColor}, {"parallax", true}}; }

std::vector<double> corners(const Box3& box) {
  return {box.min.x, box.min.y, box.max.x, box.min.y, box.max.x, box.max.y, box.min.x, box.max.y};
}

/// As a hole has them.
std::vector<double> cornersTurnedRound(const Box3& box) {
  return {box.min.x, box.min.y, box.min.x, box.max.y, box.max.x, box.max.y, box.max.x, box.min.y};
}

/// Round the air lies a sector without height. So the air's walls are steps between two skies,
/// which show the sky: no wall is seen anywhere.
AirJson sectorsRound(const Box3& air, double thickness) {
  Box3 outside = air;
  outside.min = outside.min - Vec3{thickness, thickness, 0};
  outside.max = outside.max + Vec3{thickness, thickness, 0};
  const double middle = (air.min.z + air.max.z) / 2;
  return {{kAirName,
           {{"floor", sky(air.min.z)},
            {"ceiling", sky(air.max.z)},
            {"loops", {{"border", {{"v", corners(air)}, {"walls", {{"next", "rim"}}}}}}}}},
          {"rim",
           {{"floor", sky(middle)},
            {"ceiling", sky(middle)},
            {"loops",
             {{"border", {{"v", corners(outside)}, {"walls", {{"texture", kSkyColor}}}}},
              {"hole", {{"v", cornersTurnedRound(air)}, {"walls", {{"next", kAirName}}}}}}}}}};
}

AirJson shotOf(const OrbitView& view) {
  const Vec3 eye = view.eye();
  return {{"name", kFrontName},
          {"sector", kAirName},
          {"camera", {eye.x, eye.y, eye.z, view.angle, view.pitch}},
          {"fov", kModelFov},
          {"size", {kFrontSize.width, kFrontSize.height}}};
}

AirJson lightsRound(const Box3& box) {
  AirJson lights = AirJson::array();
  for (const Lamp& lamp : kLamps) {
    const Vec3 at = centreOf(box) + kLampRadii * radiusOf(box) * lamp.direction;
    lights.push_back({{"x", at.x},
                      {"y", at.y},
                      {"z", at.z},
                      {"sector", kAirName},
                      {"intensity", lamp.intensity}});
  }
  const double texel = std::max(kSmallestTexel, 2 * radiusOf(box) / kTexelsAcross);
  return {{"lights", lights}, {"bake", {{"texel", texel}, {"lambert", true}}}};
}

}  // namespace

Vec3 centreOf(const Box3& box) { return box.min + 0.5 * (box.max - box.min); }

double radiusOf(const Box3& box) { return length(box.max - box.min) / 2; }

Box3 airRound(const Box3& model) {
  const double reach = kAirRadii * radiusOf(model);
  const Vec3 margin{reach, reach, reach};
  Box3 air{model.min - margin, model.max + margin};
  air.add(margin);
  air.add(-1 * margin);
  return air;
}

std::optional<SizeMistake> mistakeInSize(const Box3& model) {
  const double radius = radiusOf(model);
  if (radius < kSmallestRadius)
    return SizeMistake{fmt::format("the model is only {:.3g} m large", 2 * radius),
                       "scale it up in the program that made it: a unit is a metre"};
  const Box3 air = airRound(model);
  const double reach = 2 * radius + std::max(length(air.min), length(air.max));
  if (reach <= kWorldLimit) return std::nullopt;
  const Vec3 farthest = inOtherAxes(model.farthest(centreOf(model)));
  return SizeMistake{
      fmt::format("the model is {:.3g} m large, and reaches to ({:.6g}, {:.6g}, {:.6g}): with the "
                  "air round it that is beyond {:g} m",
                  2 * radius, farthest.x, farthest.y, farthest.z, kWorldLimit),
      "scale it down in the program that made it, or move it to its origin: a unit is a metre"};
}

std::optional<AirFiles> airFiles(const std::filesystem::path& model, const Box3& box,
                                 const OrbitView& front) {
  const std::string name = model.filename().string();
  AirFiles files;
  files.level = model.parent_path() / (name + ".air.json");
  files.lights = model.parent_path() / (name + ".air.lights.json");
  const AirJson level{{"name", name},
                      {"lights", files.lights.filename().string()},
                      {"light", kAmbient},
                      {"shots", AirJson::array({shotOf(front)})},
                      {"sectors", sectorsRound(airRound(box), radiusOf(box))},
                      {"things", AirJson::array({{{"mesh", name},
                                                  {"sector", kAirName},
                                                  {"x", 0},
                                                  {"y", 0},
                                                  {"z", 0},
                                                  {"solid", false}}})}};
  try {
    files.levelText = level.dump();
  } catch (const AirJson::type_error&) {
    return std::nullopt;
  }
  files.lightsText = lightsRound(box).dump();
  return files;
}

}  // namespace hearth
