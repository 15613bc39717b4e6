#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "cli/command.h"
#include "cli/info/engine_features.h"
#include "cli/info/format_features.h"
#include "cli/info/light_report.h"
#include "inputs/inputs.h"
#include "light/geometry_hash.h"
#include "render/texture.h"

namespace hearth {

namespace {

/// What a level holds, and what drawing it needs.
struct Contents {
  std::int64_t loops = 0;
  std::int64_t textureBytes = 0;  ///< as frames read them
  BakeSettings settings;          ///< of the light
  LightReport light;
  FeatureCounts features;
};

Contents contentsOf(const LoadedLevel& loaded, const LevelSource& source, const Bake& bake) {
  const Level& level = loaded.level;
  Contents contents;
  contents.settings = bake.settings;
  contents.light = lightReport(loaded.scene(), bake.light);
  for (const Sector& sector : level.sectors) contents.loops += std::ssize(sector.loops);
  for (const Image& image : loaded.textures)
    contents.textureBytes +=
        static_cast<std::int64_t>(sizeof(Texture::Texel)) * image.width() * image.height();

  countGeometry(loaded.scene(), contents.features);
  std::vector<std::string_view> texts;
  for (const Document& document : source.documents) texts.push_back(document.text);
  countSpellings(texts, contents.features);
  return contents;
}

nlohmann::ordered_json toJson(Vec3 v) { return {v.x, v.y, v.z}; }

/// The texel grids that a saved bake must have: engine/light/saved_bake.md describes the keys.
nlohmann::ordered_json toJson(const Scene& scene, const LitSurfaces& surfaces) {
  auto list = nlohmann::ordered_json::array();
  const std::vector<SurfaceId> shown = scene.shownSurfaces();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const SurfaceId id = shown[i];
    if (!surfaces[id.index()]) continue;
    const LitSurface& lit = *surfaces[id.index()];
    const TexelRect& rect = lit.texels;
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
                    {"texels", {rect.i0, rect.j0, rect.width, rect.height}},
                    {"outlines", std::move(outlines)}});
  }
  return list;
}

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
  object["coloredLights"] = report.coloredLights;
  object["uselessLights"] = report.uselessLights;
  return object;
}

/// The counts of what there is; in an order that does not change.
nlohmann::ordered_json toJson(const LoadedLevel& loaded, const Contents& contents) {
  const Level& level = loaded.level;
  nlohmann::ordered_json object;
  object["name"] = level.name;
  object["sectors"] = level.sectors.size();
  object["loops"] = contents.loops;
  object["segments"] = level.segments.size();
  object["interfaces"] = level.flatPortals.size();  // scripts know them by this name
  object["lights"] = level.lights.size();
  object["shots"] = level.shots.size();
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

void printLine(std::string_view what, std::int64_t count) {
  if (count > 0) fmt::print("{:>11}  {}\n", count, what);
}

void printRow(std::string_view name, const SurfaceReport& row) {
  if (row.surfaces() == 0) return;
  fmt::print("{:<16} {:>8} {:>6} {:>8} {:>10} {:>6} {:>7} {:>6} {:>11} {:>13}\n", name,
             row.surfaces(), row.bare, row.unfaced, row.unreached, row.white, row.colored, row.even,
             row.bytes, row.rays);
}

void printLight(const Contents& contents) {
  const auto& [settings, light] = std::tie(contents.settings, contents.light);
  fmt::print("\nlight, with texels of {} m, {}\n", settings.texel, samplesInWords(settings));
  fmt::print("{:<16} {:>8} {:>26} {:>14}\n", "", "", "without a lightmap", "of channels");
  fmt::print("{:<16} {:>8} {:>6} {:>8} {:>10} {:>6} {:>7} {:>6} {:>11} {:>13}\n", "", "surfaces",
             "bare", "unfaced", "unreached", "one", "three", "even", "bytes", "rays");
  for (std::size_t i = 0; i < kSurfaceKindCount; ++i)
    printRow(name(static_cast<SurfaceKind>(i)), light.kinds[i]);
  printRow("all", light.all);
  fmt::print(
      "bare: sky, or none of it bounds air; unfaced: no light within reach is in front of it; "
      "unreached: none arrives\n");
  const auto printLights = [](std::string_view what, const LightKindReport& kind) {
    if (kind.lights > 0)
      fmt::print("{:>11}  {}: {:.2f} rays a sample, {} rays\n", kind.lights, what,
                 kind.raysPerSample(), kind.rays);
  };
  printLine("texels of surfaces without a lightmap", light.all.skippedTexels);
  printLine("bytes that even lightmaps spare", light.all.sparedBytes());
  printLights("point lights", light.points);
  printLights("spherical lights", light.spheres);
  printLine("lights that reach nothing", light.uselessLights);
}

void print(const LoadedLevel& loaded, const Contents& contents) {
  const Level& level = loaded.level;
  fmt::print("{}\n\nholds\n", level.name);
  const auto line = printLine;
  line("sectors", std::ssize(level.sectors));
  line("loops", contents.loops);
  line("segments", std::ssize(level.segments));
  line("flat portals", std::ssize(level.flatPortals));
  line("lights", std::ssize(level.lights));
  line("shots", std::ssize(level.shots));
  line("textures", std::ssize(level.textures));
  line("surfaces", contents.light.all.surfaces());
  fmt::print("\nrequires\n");
  line("bytes of textures", contents.textureBytes);
  line("bytes of lightmaps", contents.light.all.bytes);
  line("rays to bake them", contents.light.all.rays);
  printLight(contents);
  fmt::print("\n{:<55}{}\n", "pays for", "and of the rest");
  for (const EngineFeatureUse& use : engineFeatureUses(loaded, contents.light)) {
    const std::string what = fmt::format("of {} {}", use.of, use.name);
    const std::string rest =
        use.used < use.of ? fmt::format("{:>5} {}", use.of - use.used, use.rest) : "";
    fmt::print("{:>11}  {:{}}{}\n", use.used, what, rest.empty() ? 0 : 42, rest);
  }
  fmt::print("\nuses\n");
  for (const auto& [feature, name] : kFormatFeatures) line(name, contents.features[feature]);
}

ExitStatus runInfo(const OptionValues& values) {
  if (values.has(Option::Surfaces) && !values.has(Option::Json))
    return fail("--surfaces: they are printed as JSON only; give --json, too");
  const auto [result, source] = loadAndReportWithSource(values);
  const std::optional<LoadedLevel>& loaded = result.loaded;
  if (!loaded) return ExitStatus::BadInput;
  const auto bake = bakeFor(loaded->scene(), values);
  if (!bake) return fail(bake.error());
  const Contents contents = contentsOf(*loaded, source, *bake);
  if (!values.has(Option::Json)) {
    print(*loaded, contents);
    return ExitStatus::Done;
  }
  nlohmann::ordered_json object = toJson(*loaded, contents);
  if (values.has(Option::Surfaces))
    object["bake"]["surfaces"] = toJson(loaded->scene(), bake->light.surfaces);
  fmt::print("{}\n", object.dump(2));
  return ExitStatus::Done;
}

}  // namespace

Command infoCommand() {
  return {"info",
          "bakes, and prints what the level holds, which features it requires and which engine "
          "features it pays for",
          std::vector<Option>{Option::Json, Option::Surfaces} + bakeOptions(),
          {},
          runInfo};
}

}  // namespace hearth
