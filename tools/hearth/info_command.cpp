#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hearth/command.h"
#include "hearth/format_features.h"
#include "hearth/session.h"
#include "light/geometry_hash.h"
#include "light/lit_surface.h"

namespace hearth {

namespace {

/// What a level holds, and what drawing it needs.
struct Contents {
  std::array<std::int64_t, kSurfaceKinds> surfaces{};
  std::int64_t loops = 0;
  std::int64_t textureBytes = 0;
  LitSurfaces litSurfaces;
  std::int64_t lightmapTexels = 0;  ///< at most: surfaces that no light reaches need none
  FeatureCounts features;
};

std::string textOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Contents contentsOf(const LoadedLevel& loaded, const BakeSettings& settings) {
  const Level& level = loaded.level;
  Contents contents;
  for (const Surface& surface : level.surfaces)
    ++contents.surfaces[static_cast<std::size_t>(surface.kind)];
  for (const Sector& sector : level.sectors) contents.loops += std::ssize(sector.loops);
  for (const Image& image : loaded.textures)
    contents.textureBytes += std::int64_t{3} * image.width() * image.height();
  contents.litSurfaces = makeLitSurfaces(level, settings.texel);
  for (const auto& surface : contents.litSurfaces)
    if (surface)
      contents.lightmapTexels += std::int64_t{surface->texels.width} * surface->texels.height;

  const std::string levelText = textOf(loaded.path);
  const std::string lights = lightsPath(loaded.path, levelText);
  countGeometry(level, contents.features);
  countSpellings(levelText, lights.empty() ? std::string() : textOf(lights), contents.features);
  return contents;
}

nlohmann::ordered_json toJson(Vec3 v) { return {v.x, v.y, v.z}; }

/// The texel grids that a saved bake must have: engine/light/saved_bake.md describes the keys.
nlohmann::ordered_json toJson(const Level& level, const LitSurfaces& surfaces) {
  auto list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i]) continue;
    const LitSurface& lit = *surfaces[i];
    const TexelRect& rect = lit.texels;
    auto outlines = nlohmann::ordered_json::array();
    for (const std::vector<Vec2>& outline : lit.outlines) {
      auto& points = outlines.emplace_back(nlohmann::ordered_json::array());
      for (const Vec2 p : outline) points.push_back({p.x, p.y});
    }
    list.push_back({{"surface", i},
                    {"kind", name(level.surfaces[i].kind)},
                    {"sector", level[level.surfaces[i].sector].name},
                    {"origin", toJson(lit.grid.origin)},
                    {"axisS", toJson(lit.grid.axisS)},
                    {"axisT", toJson(lit.grid.axisT)},
                    {"normal", toJson(lit.normal)},
                    {"texels", {rect.i0, rect.j0, rect.width, rect.height}},
                    {"outlines", std::move(outlines)}});
  }
  return list;
}

/// The counts of what there is; in an order that does not change.
nlohmann::ordered_json toJson(const LoadedLevel& loaded, const Contents& contents,
                              const BakeSettings& settings) {
  const Level& level = loaded.level;
  nlohmann::ordered_json json;
  json["name"] = level.name;
  json["sectors"] = level.sectors.size();
  json["loops"] = contents.loops;
  json["segments"] = level.segments.size();
  json["interfaces"] = level.interfaces.size();
  json["lights"] = level.lights.size();
  json["shots"] = level.shots.size();
  for (std::size_t i = 0; i < kSurfaceKinds; ++i)
    json["surfaces"][std::string(name(static_cast<SurfaceKind>(i)))] = contents.surfaces[i];
  json["textures"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < level.textures.size(); ++i)
    json["textures"].push_back({{"name", level.textures[i]},
                                {"width", loaded.textures[i].width()},
                                {"height", loaded.textures[i].height()}});
  json["requires"] = {{"textureBytes", contents.textureBytes},
                      {"lightmapBytesAtMost", contents.lightmapTexels},
                      {"texelMetres", settings.texel}};
  json["bake"] = {{"texelMetres", settings.texel},
                  {"geometry", fmt::format("{:016x}", geometryHash(level, settings.texel))}};
  for (const auto& [feature, name] : kFormatFeatures)
    json["features"][std::string(name)] = contents.features[feature];
  return json;
}

void print(const LoadedLevel& loaded, const Contents& contents, const BakeSettings& settings) {
  const Level& level = loaded.level;
  fmt::print("{}\n\nholds\n", level.name);
  const auto line = [](std::string_view what, std::int64_t count) {
    if (count > 0) fmt::print("{:>9}  {}\n", count, what);
  };
  line("sectors", std::ssize(level.sectors));
  line("loops", contents.loops);
  line("segments", std::ssize(level.segments));
  line("interfaces", std::ssize(level.interfaces));
  line("lights", std::ssize(level.lights));
  line("shots", std::ssize(level.shots));
  line("textures", std::ssize(level.textures));
  line("surfaces", std::ssize(level.surfaces));
  for (std::size_t i = 0; i < kSurfaceKinds; ++i)
    line(fmt::format("  {}", name(static_cast<SurfaceKind>(i))), contents.surfaces[i]);
  fmt::print("\nrequires\n");
  line("bytes of textures", contents.textureBytes);
  line(fmt::format("bytes of lightmaps at most, with texels of {} m", settings.texel),
       contents.lightmapTexels);
  fmt::print("\nuses\n");
  for (const auto& [feature, name] : kFormatFeatures) line(name, contents.features[feature]);
}

ExitStatus run(const OptionValues& values) {
  if (values.has(Option::Surfaces) && !values.has(Option::Json))
    return fail("--surfaces: they are printed as JSON only; give --json, too");
  const std::optional<LoadedLevel> loaded = openLevel(values);
  if (!loaded) return ExitStatus::BadInput;
  const auto settings = bakeSettingsFor(loaded->level, values);
  if (!settings) return fail(settings.error());
  const Contents contents = contentsOf(*loaded, *settings);
  if (!values.has(Option::Json)) {
    print(*loaded, contents, *settings);
    return ExitStatus::Done;
  }
  nlohmann::ordered_json json = toJson(*loaded, contents, *settings);
  if (values.has(Option::Surfaces))
    json["bake"]["surfaces"] = toJson(loaded->level, contents.litSurfaces);
  fmt::print("{}\n", json.dump(2));
  return ExitStatus::Done;
}

}  // namespace

Command infoCommand() {
  return {"info",
          "prints what the level holds and what it requires",
          std::vector<Option>{Option::Json, Option::Surfaces, Option::Texel} + limitOptions(),
          {},
          run};
}

}  // namespace hearth
