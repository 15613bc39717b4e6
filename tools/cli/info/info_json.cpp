#include "cli/info/info_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/info/engine_features.h"
#include "light/geometry_hash.h"

namespace hearth {

namespace {

nlohmann::ordered_json toJson(Vec3 v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json toJson(const SurfaceReport& report) {
  return {{"surfaces", report.surfaces()},
          {"bare", report.bare},
          {"unfaced", report.unfaced},
          {"unreached", report.unreached},
          {"oneChannel", report.white},
          {"threeChannels", report.colored},
          {"even", report.even},
          {"texels", report.whiteTexels + report.coloredTexels},
          {"skippedTexels", report.skippedTexels},
          {"bytes", report.bytes},
          {"sparedBytes", report.sparedBytes()},
          {"rays", report.rays}};
}

nlohmann::ordered_json toJson(const LightKindReport& report) {
  return {{"lights", report.lights},
          {"samples", report.samples},
          {"rays", report.rays},
          {"raysPerSample", report.raysPerSample()}};
}

nlohmann::ordered_json lightToJson(const BakeSettings& settings, const LightReport& report) {
  nlohmann::ordered_json object;
  object["texelMetres"] = settings.texel;
  if (settings.samples)
    object["samples"] = *settings.samples;
  else
    object["samples"] = "auto";
  object["lambert"] = settings.lambert;
  object["all"] = toJson(report.all);
  for (std::size_t i = 0; i < kSurfaceKindCount; ++i)
    object["kinds"][std::string(name(static_cast<SurfaceKind>(i)))] = toJson(report.kinds[i]);
  object["points"] = toJson(report.points);
  object["balls"] = toJson(report.spheres);
  object["suns"] = toJson(report.suns);
  object["skies"] = toJson(report.skies);
  object["emitters"] = toJson(report.emitters);
  object["bounced"] = toJson(report.bounced);
  object["coloredLights"] = report.coloredLights;
  object["uselessLights"] = report.uselessLights;
  return object;
}

nlohmann::ordered_json toJson(const MoverContents& contents) {
  const auto& [mover, from, share, hasSwitch] = contents;
  nlohmann::ordered_json object{{"name", mover.name},
                                {"part", name(mover.part)},
                                {"from", from},
                                {"to", mover.to},
                                {"speed", mover.speed},
                                {"trigger", name(mover.trigger)},
                                {"startedByWalls", hasSwitch},
                                {"sectors", mover.sectors.size()},
                                {"share", share}};
  if (mover.wait) object["wait"] = *mover.wait;
  return object;
}

nlohmann::ordered_json toJson(const LightDifference& difference) {
  return {{"texels", difference.texels},
          {"rmsLevels", difference.rms},
          {"texelsOff", difference.visible},
          {"mostLevels", difference.most}};
}

}  // namespace

nlohmann::ordered_json infoToJson(const LoadedLevel& loaded, const Contents& contents) {
  const Level& level = loaded.level;
  nlohmann::ordered_json object;
  object["name"] = level.name;
  object["sectors"] = level.sectors.size();
  object["loops"] = contents.loops;
  object["segments"] = level.segments.size();
  object["interfaces"] = level.flatPortals.size();  // scripts know them by this name
  object["movers"] = nlohmann::ordered_json::array();
  for (const MoverContents& mover : contents.movers) object["movers"].push_back(toJson(mover));
  if (contents.blend) object["blendedLight"] = toJson(*contents.blend);
  object["lights"] = level.lights.size();
  object["shots"] = level.shots.size();
  object["sprites"] = level.sprites.size();
  object["meshes"] = level.meshes.size();
  object["meshFaces"] = level.meshFaces.size();
  for (std::size_t i = 0; i < kSurfaceKindCount; ++i)
    object["surfaces"][std::string(name(static_cast<SurfaceKind>(i)))] =
        contents.light.kinds[i].surfaces();
  object["textures"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < level.textures.size(); ++i)
    object["textures"].push_back({{"name", level.textures[i]},
                                  {"width", loaded.textures[i].width()},
                                  {"height", loaded.textures[i].height()}});
  object["requires"] = {{"textureBytes", contents.textureBytes},
                        {"lightmapBytes", contents.light.all.bytes},
                        {"rays", contents.light.all.rays}};
  object["light"] = lightToJson(contents.settings, contents.light);
  for (const auto& [name, used, of, rest] : engineFeatureUses(loaded, contents.light))
    object["models"][std::string(name)] = {{"used", used}, {"of", of}, {"rest", rest}};
  object["bake"] = {
      {"texelMetres", contents.settings.texel},
      {"geometry", fmt::format("{:016x}", geometryHash(loaded.scene(), contents.settings.texel))}};
  for (const auto& [feature, name] : kFormatFeatures)
    object["features"][std::string(name)] = contents.features[feature];
  return object;
}

namespace {

nlohmann::ordered_json toJson(const TexelRect& rect) {
  return {rect.i0, rect.j0, rect.width, rect.height};
}

nlohmann::ordered_json placesOnLightmap(const Scene& scene, std::size_t number, SurfaceId id,
                                        const LitMesh& mesh) {
  auto faces = nlohmann::ordered_json::array();
  for (const auto& [a, b, c] : mesh.places) faces.push_back({a.x, a.y, b.x, b.y, c.x, c.y});
  return {{"surface", number},
          {"kind", name(SurfaceKind::Mesh)},
          {"sector", scene[scene[id].sector].name},
          {"texels", toJson(mesh.texels)},
          {"faces", std::move(faces)}};
}

}  // namespace

nlohmann::ordered_json texelGridsToJson(const Scene& scene, const BakedLight& light) {
  auto list = nlohmann::ordered_json::array();
  const std::vector<SurfaceId> shown = scene.shownSurfaces();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const SurfaceId id = shown[i];
    if (scene[id].kind == SurfaceKind::Mesh)
      list.push_back(placesOnLightmap(scene, i, id, light.meshes[scene.level().meshIndexOf(id)]));
    if (!light.surfaces[id.index()]) continue;
    const LitSurface& lit = *light.surfaces[id.index()];
    auto outlines = nlohmann::ordered_json::array();
    for (const std::vector<Vec2>& polygon : lit.outline.loops()) {
      auto& points = outlines.emplace_back(nlohmann::ordered_json::array());
      for (const Vec2 p : polygon) points.push_back({p.x, p.y});
    }
    list.push_back({{"surface", i},
                    {"kind", name(scene[id].kind)},
                    {"sector", scene[scene[id].sector].name},
                    {"origin", toJson(lit.grid.origin)},
                    {"axisS", toJson(lit.grid.axisS)},
                    {"axisT", toJson(lit.grid.axisT)},
                    {"normal", toJson(lit.normal)},
                    {"texels", toJson(lit.texels)},
                    {"outlines", std::move(outlines)}});
  }
  return list;
}

}  // namespace hearth
