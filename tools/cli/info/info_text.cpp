#include "cli/info/info_text.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "cli/info/engine_features.h"
#include "settings/settings.h"

namespace hearth {

namespace {

void printLine(std::string_view what, std::int64_t count) {
  if (count > 0) fmt::print("{:>11}  {}\n", count, what);
}

void printRow(std::string_view name, const SurfaceReport& row) {
  if (row.surfaces() == 0) return;
  fmt::print("{:<16} {:>8} {:>6} {:>8} {:>10} {:>6} {:>7} {:>6} {:>11} {:>13}\n", name,
             row.surfaces(), row.bare, row.unfaced, row.unreached, row.white, row.colored, row.even,
             row.bytes, row.rays);
}

std::string numberOrDash(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "-";
}

/// What starts it.
std::string_view startOf(const Mover& mover, bool hasSwitch) {
  return mover.trigger == MoverTrigger::None && hasSwitch ? "wall" : name(mover.trigger);
}

void printMovers(const Contents& contents) {
  if (contents.movers.empty()) return;
  fmt::print("\n{:<24} {:>8} {:>8} {:>8} {:>8} {:>8} {:>6} {:>8} {:>6}\n", "movers", "moves",
             "from, m", "to, m", "m/s", "wait, s", "starts", "sectors", "share");
  for (const auto& [mover, from, share, hasSwitch] : contents.movers)
    fmt::print("{:<24} {:>8} {:>8} {:>8} {:>8} {:>8} {:>6} {:>8} {:>6}\n", mover.name,
               name(mover.part), from, mover.to, mover.speed, numberOrDash(mover.wait),
               startOf(mover, hasSwitch), mover.sectors.size(), share);
  if (!contents.blend) return;
  const LightDifference& blend = *contents.blend;
  const double percent = blend.texels == 0 ? 0
                                           : 100 * static_cast<double>(blend.visible) /
                                                 static_cast<double>(blend.texels);
  fmt::print(
      "light is blended from the movers' ends: {:.2f} levels RMS from a bake at these heights,\n"
      "{:.1f} % of {} texels more than {} levels off, the farthest {}\n",
      blend.rms, percent, blend.texels, LightDifference::kVisible, blend.most);
}

void printLight(const Contents& contents) {
  const LightReport& light = contents.light;
  fmt::print("\nlight, with texels of {} m, {}\n", contents.settings.texel,
             samplesInWords(contents.settings));
  fmt::print("{:<16} {:>8} {:>26} {:>14}\n", "", "", "without a lightmap", "of channels");
  fmt::print("{:<16} {:>8} {:>6} {:>8} {:>10} {:>6} {:>7} {:>6} {:>11} {:>13}\n", "", "surfaces",
             "bare", "unfaced", "unreached", "one", "three", "even", "bytes", "rays");
  for (std::size_t i = 0; i < kSurfaceKindCount; ++i)
    printRow(name(static_cast<SurfaceKind>(i)), light.kinds[i]);
  printRow("all", light.all);
  fmt::print(
      "bare: sky, meshes, sprites in the dark, or none of it bounds air; unfaced: no light within "
      "reach is "
      "in front of it; "
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
  printLights("suns", light.suns);
  printLights("skies", light.skies);
  printLights("emitters", light.emitters);
  printLights("light that bounces", light.bounced);
  printLine("lights that reach nothing", light.uselessLights);
}

}  // namespace

void printInfo(const LoadedLevel& loaded, const Contents& contents) {
  const Level& level = loaded.level;
  fmt::print("{}\n\nholds\n", level.name);
  printLine("sectors", std::ssize(level.sectors));
  printLine("loops", contents.loops);
  printLine("segments", std::ssize(level.segments));
  printLine("flat portals", std::ssize(level.flatPortals));
  printLine("movers", std::ssize(level.movers));
  printLine("lights", std::ssize(level.lights));
  printLine("shots", std::ssize(level.shots));
  printLine("sprites", std::ssize(level.sprites));
  printLine("meshes", std::ssize(level.meshes));
  printLine("faces of meshes", std::ssize(level.meshFaces));
  printLine("textures", std::ssize(level.textures));
  printLine("surfaces", contents.light.all.surfaces());
  fmt::print("\nrequires\n");
  printLine("bytes of textures", contents.textureBytes);
  printLine("bytes of lightmaps", contents.light.all.bytes);
  printLine("rays to bake them", contents.light.all.rays);
  printMovers(contents);
  printLight(contents);
  fmt::print("\n{:<55}{}\n", "pays for", "and of the rest");
  for (const EngineFeatureUse& use : engineFeatureUses(loaded, contents.light)) {
    const std::string what = fmt::format("of {} {}", use.of, use.name);
    const std::string rest =
        use.used < use.of ? fmt::format("{:>5} {}", use.of - use.used, use.rest) : "";
    fmt::print("{:>11}  {:{}}{}\n", use.used, what, rest.empty() ? 0 : 42, rest);
  }
  fmt::print("\nuses\n");
  for (const auto& [feature, name] : kFormatFeatures) printLine(name, contents.features[feature]);
}

}  // namespace hearth
