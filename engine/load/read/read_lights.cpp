#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "load/json/fields.h"
#include "load/read/read.h"

namespace hearth {

namespace {

constexpr std::array<std::string_view, 10> kLightKeys{
    "x", "y", "z", "sector", "intensity", "falloff", "curve", "color", "radius", "spot"};
constexpr std::array<std::string_view, 4> kSpotKeys{"angle", "pitch", "inner", "outer"};
constexpr std::array<std::string_view, 5> kSunKeys{"angle", "pitch", "intensity", "color", "size"};
constexpr std::array<std::string_view, 2> kSkyKeys{"intensity", "color"};
constexpr std::array<std::string_view, 2> kEmitterKeys{"intensity", "color"};
constexpr std::array<std::string_view, 6> kFileKeys{"version", "lights", "suns",
                                                    "sky",     "emit",   "bake"};
constexpr std::array<std::string_view, 5> kBakeKeys{"texel", "samples", "lambert", "bounces",
                                                    "reflectance"};

constexpr std::string_view kAutoSamples = "auto";

/// Light in levels, and falloff per metre: as far as a float reaches.
constexpr NumberRange kLevels{0, 1e38};

bool readColor(Report& report, const Fields& fields, LightSource& source) {
  const std::optional<JsonValue> value = fields.find("color");
  if (!value) return true;
  const auto color = value->isString() ? parseColor(value->text()) : std::nullopt;
  if (!color) {
    report.error(value->place(), "no colour", "write \"#rrggbb\" with hexadecimal digits");
    return false;
  }
  source.color[0] = color->r;
  source.color[1] = color->g;
  source.color[2] = color->b;
  return true;
}

/// One `[distance, light]` of a curve.
void readCurvePoint(Report& report, JsonValue element, std::vector<CurvePoint>& curve) {
  const auto numbers = readNumbers(report, element, 2, kLevels);
  if (!numbers) return;
  const CurvePoint point{(*numbers)[0], (*numbers)[1]};
  if (!curve.empty() && point.distance < curve.back().distance)
    report.error(element.place(),
                 fmt::format("distance {} comes after {}", point.distance, curve.back().distance),
                 "sort the curve by rising distance");
  else
    curve.push_back(point);
}

void readCurve(Report& report, const Fields& fields, LightSource& source) {
  const std::optional<JsonValue> value = fields.find("curve");
  if (!value) return;
  for (const std::string_view key : {"intensity", "falloff"})
    if (const auto other = fields.find(key))
      report.error(other->place(), fmt::format("\"{}\" beside \"curve\"", key),
                   "give either a curve or intensity and falloff");
  if (!value->isArray() || value->size() == 0) {
    report.error(value->place(), "no curve", "write [[distance, light], ...], at least one pair");
    return;
  }
  for (const JsonValue element : value->elements()) readCurvePoint(report, element, source.curve);
}

void readSpot(Report& report, const Fields& ofLight, LightSource& source) {
  const std::optional<JsonValue> value = ofLight.find("spot");
  if (!value) return;
  constexpr NumberRange kUpright{-90, 90};  // degrees
  constexpr NumberRange kOpening{0, 180};   // degrees
  const Fields fields(report, *value, kSpotKeys);
  double angle = 0;
  double pitch = 0;
  double inner = 0;
  double outer = 0;
  bool isGood = fields.isObject() &&
                fields.require("outer", "give the angle at which the light ends").has_value();
  isGood &= fields.read("angle", kAngle, angle);
  isGood &= fields.read("pitch", kUpright, pitch);
  isGood &= fields.read("inner", kOpening, inner);
  isGood &= fields.read("outer", kOpening, outer);
  if (!isGood) return;
  if (inner > outer)
    return report.error(value->place(),
                        fmt::format("\"inner\" {} is more than \"outer\" {}", inner, outer),
                        fmt::format("give \"inner\" {} at most, or a larger \"outer\"", outer));
  source.spot.emplace(angle, pitch, inner, outer);
}

std::optional<LightDescription> readLight(Report& report, JsonValue value) {
  const Fields fields(report, value, kLightKeys);
  LightDescription light;
  light.place = value.place();
  LightSource& source = light.source;
  bool isGood = fields.isObject();
  for (const std::string_view key : {"x", "y", "z"})
    isGood &= fields.require(key, "give the light's position").has_value();
  isGood &= fields.read("x", kCoordinate, source.position.x);
  isGood &= fields.read("y", kCoordinate, source.position.y);
  isGood &= fields.read("z", kCoordinate, source.position.z);
  isGood &= readSectorName(report, fields, light.sector);
  fields.read("intensity", kLevels, source.intensity);
  fields.read("falloff", kLevels, source.falloff);
  fields.read("radius", kLength, source.radius);
  readColor(report, fields, source);
  readCurve(report, fields, source);
  readSpot(report, fields, source);
  return isGood ? std::optional(light) : std::nullopt;
}

std::optional<LightDescription> readSun(Report& report, JsonValue value) {
  constexpr NumberRange kAboveHorizon{1, 90};  // degrees
  constexpr NumberRange kDiameter{0, 20};      // degrees
  const Fields fields(report, value, kSunKeys);
  LightDescription light;
  light.place = value.place();
  double angle = 0;
  double pitch = 0;
  double size = 0;
  bool isGood = fields.isObject();
  isGood &= fields.require("angle", "give the direction in which one sees the sun").has_value();
  isGood &= fields.require("pitch", "give the sun's height over the horizon").has_value();
  isGood &= fields.read("angle", kAngle, angle);
  isGood &= fields.read("pitch", kAboveHorizon, pitch);
  isGood &= fields.read("size", kDiameter, size);
  fields.read("intensity", kLevels, light.source.intensity);
  readColor(report, fields, light.source);
  if (!isGood) return std::nullopt;
  light.source.sun.emplace(angle, pitch, size);
  return light;
}

std::optional<LightDescription> readSky(Report& report, JsonValue value) {
  const Fields fields(report, value, kSkyKeys);
  LightDescription light;
  light.place = value.place();
  light.source.isSky = true;
  light.source.intensity = 0;
  if (!fields.isObject()) return std::nullopt;
  fields.read("intensity", kLevels, light.source.intensity);
  readColor(report, fields, light.source);
  return light;
}

std::optional<LightDescription> readEmitter(Report& report, const JsonValue::Member& member) {
  const Fields fields(report, member.value, kEmitterKeys);
  LightDescription light;
  light.place = member.value.place();
  light.source.texture = member.key.text();
  if (light.source.texture.empty())
    report.error(member.key.place(), "an emitter without a name",
                 "name the texture of the surfaces that shine");
  if (!fields.isObject() || light.source.texture.empty()) return std::nullopt;
  fields.read("intensity", kLevels, light.source.intensity);
  readColor(report, fields, light.source);
  return light;
}

bool isSquare(int number) {
  const int root = static_cast<int>(std::lround(std::sqrt(number)));
  return root * root == number;
}

void readSampleCount(Report& report, JsonValue value, BakeSettings& bake) {
  constexpr NumberRange kSamples{1, 1 << 20};
  const std::optional<int> count = readInteger(report, value, kSamples);
  if (count && !isSquare(*count))
    report.error(value.place(), fmt::format("{} samples are no square grid", *count),
                 fmt::format("give a square number, 1, 4, 9, 16, ..., or \"{}\"", kAutoSamples));
  bake.samples = count;
}

BakeSettings readBake(Report& report, JsonValue value) {
  constexpr NumberRange kTexel{1e-6, kWorldLimit};  // metres
  constexpr NumberRange kBounces{0, 16};
  constexpr NumberRange kReflectance{0, 1};
  const Fields fields(report, value, kBakeKeys);
  BakeSettings bake;
  fields.read("texel", kTexel, bake.texel);
  fields.read("lambert", bake.lambert);
  fields.read("reflectance", kReflectance, bake.reflectance);
  if (const auto bounces = fields.find("bounces"))
    bake.bounces = readInteger(report, *bounces, kBounces).value_or(bake.bounces);
  if (const auto samples = fields.find("samples")) {
    if (samples->isString() && samples->text() == kAutoSamples)
      bake.samples.reset();
    else
      readSampleCount(report, *samples, bake);
  }
  return bake;
}

/// Suns and emitters count as lights.
void checkCount(Report& report, JsonValue list, std::size_t count, const LoadLimits& limits) {
  if (count > limits.lights)
    report.error(list.place(), fmt::format("{} lights are more than {}", count, limits.lights),
                 "raise the limit with --max-lights");
}

void readLightList(Report& report, JsonValue value, const LoadLimits& limits,
                   LightsDescription& lights) {
  if (!value.isArray()) return reportWrongType(report, value, "an array of lights");
  checkCount(report, value, value.size(), limits);
  if (value.size() > limits.lights) return;
  for (const JsonValue element : value.elements())
    if (auto light = readLight(report, element)) lights.lights.push_back(*std::move(light));
}

void readSuns(Report& report, JsonValue value, const LoadLimits& limits,
              LightsDescription& lights) {
  if (!value.isArray()) return reportWrongType(report, value, "an array of suns");
  const std::size_t count = lights.lights.size() + value.size();
  checkCount(report, value, count, limits);
  if (count > limits.lights) return;
  for (const JsonValue element : value.elements())
    if (auto sun = readSun(report, element)) lights.suns.push_back(*std::move(sun));
}

void readEmitters(Report& report, JsonValue value, const LoadLimits& limits,
                  LightsDescription& lights) {
  if (!value.isObject()) return reportWrongType(report, value, "an object of emitters by texture");
  const std::vector<JsonValue::Member> members = value.members();
  const std::size_t count = lights.count() + members.size();
  checkCount(report, value, count, limits);
  if (count > limits.lights) return;
  for (const JsonValue::Member& member : members)
    if (auto emitter = readEmitter(report, member)) lights.emitters.push_back(*std::move(emitter));
}

bool isLevel(JsonValue root) {
  if (!root.isObject()) return false;
  const std::vector<JsonValue::Member> members = root.members();
  return std::ranges::any_of(
      members, [](const JsonValue::Member& member) { return member.key.text() == "sectors"; });
}

}  // namespace

LightsDescription readLights(Report& report, JsonValue root, const LoadLimits& limits) {
  LightsDescription lights;
  if (root.isArray()) {
    readLightList(report, root, limits, lights);
    return lights;
  }
  if (isLevel(root)) {
    report.error(root.place(), "a level instead of a lights file",
                 "write { \"lights\": [ .. ] } here, and the level into another file");
    return lights;
  }
  const Fields fields(report, root, kFileKeys);
  checkVersion(report, fields);
  if (const auto list = fields.require("lights", "give an array of lights"))
    readLightList(report, *list, limits, lights);
  if (const auto suns = fields.find("suns")) readSuns(report, *suns, limits, lights);
  if (const auto sky = fields.find("sky")) lights.sky = readSky(report, *sky);
  if (const auto emit = fields.find("emit")) readEmitters(report, *emit, limits, lights);
  if (const auto bake = fields.find("bake")) lights.bake = readBake(report, *bake);
  return lights;
}

}  // namespace hearth
