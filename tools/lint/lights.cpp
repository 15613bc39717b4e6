#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "level/shining_textures.h"
#include "light/gather/area_visibility.h"
#include "light/rays/raytracer.h"
#include "lint/authored_wall.h"

namespace hearth {

namespace {

/// Texels of a first, quick bake are so many times as wide: what sees a light in it, sees it.
constexpr double kCoarser = 8;

/// By which lights are multiplied for the bake that is looked at, so that lightmaps, which end at
/// full brightness, have up to four times as much.
constexpr double kDimmed = 0.25;

/// Levels. What brings no surface more than that is hardly seen, and was meant to be: its author
/// took an intensity of 1 for full light, which is 255.
constexpr double kWeak = 4;

/// Levels. Up to 255 all light shows, and somewhat more does no harm: full brightness is a texture
/// as it is. From twice as much on nothing is left of what light was to model.
constexpr double kLost = 2 * 255;

/// Fraction of a surface whose light may be lost: the neighbourhood of a lamp.
constexpr double kMaxLost = 0.25;

/// Square metres. Smaller surfaces may be black in a sector that is not: in the shadow of a pier,
/// or of a step, where light was to be scarce.
constexpr double kShadow = 4;

/// The lights of which no sample sees anything, of those given by their indices.
std::vector<std::size_t> unseenOf(const Scene& scene, const std::vector<std::size_t>& lights,
                                  const BakeSettings& settings, int threads) {
  if (lights.empty()) return {};
  Level only = scene.level();
  only.lights.clear();
  for (const std::size_t light : lights) only.lights.push_back(scene.level().lights[light]);
  BakeSettings direct = settings;
  direct.bounces = 0;
  const BakedLight baked = bake({only, scene.geometry()}, direct, threads);
  std::vector<std::size_t> unseen;
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (baked.lightCosts[i].seenSamples == 0) unseen.push_back(lights[i]);
  return unseen;
}

/// Likewise, with a coarse bake first, in which most of them are seen.
std::vector<std::size_t> dimOf(const Scene& scene, const std::vector<std::size_t>& lights,
                               const BakeSettings& settings, int threads) {
  BakeSettings coarse = settings;
  coarse.texel *= kCoarser;
  return unseenOf(scene, unseenOf(scene, lights, coarse, threads), settings, threads);
}

/// Of the texels of a surface that lie on it, those that `isSuch(i, j)`.
template <typename IsSuch>
std::int64_t countTexels(const LitSurface& surface, IsSuch&& isSuch) {
  std::int64_t count = 0;
  const TexelRect& rect = surface.texels;
  for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
    for (int i = rect.i0; i < rect.i0 + rect.width; ++i)
      count += surface.outline.contains({i + 0.5, j + 0.5}) && isSuch(i, j) ? 1 : 0;
  return count;
}

std::int64_t countTexels(const LitSurface& surface) {
  return countTexels(surface, [](int, int) { return true; });
}

/// Square metres, to a texel.
double areaOf(const LitSurface& surface) {
  return static_cast<double>(countTexels(surface)) * surface.grid.texel * surface.grid.texel;
}

/// Fraction of the surface. `sectorLevel`: 0 to 255, beside the dimmed light of the map.
double lostFraction(const LitSurface& surface, const Lightmap& map, double sectorLevel) {
  const std::int64_t lost = countTexels(surface, [&](int i, int j) {
    for (int channel = 0; channel < map.channels; ++channel)
      if (map.at(i, j, channel) / kDimmed + sectorLevel > kLost) return true;
    return false;
  });
  return lost == 0 ? 0 : static_cast<double>(lost) / static_cast<double>(countTexels(surface));
}

/// The point of the surface that has the most light of any channel.
Vec3 brightestOf(const LitSurface& surface, const Lightmap& map) {
  int most = -1;
  Vec2 brightest;
  countTexels(surface, [&](int i, int j) {
    for (int channel = 0; channel < map.channels; ++channel)
      if (map.at(i, j, channel) > most) {
        most = map.at(i, j, channel);
        brightest = {i + 0.5, j + 0.5};
      }
    return true;
  });
  return surface.toWorld(brightest);
}

bool sees(const Scene& scene, const Raytracer& raytracer, const LightSource& light, Vec3 p,
          SectorId sector) {
  if (light.sun) return raytracer.seesSky({p, sector}, light.sun->direction());
  return raytracer.sees(Raytracer::sourceOf(scene, light), p, sector);
}

/// The light that brings most to a point of a surface, of those that it sees. Balls of light, and
/// suns with a size, are taken for points.
std::size_t mostAt(const Scene& scene, Vec3 p, Vec3 normal, SectorId sector) {
  const Raytracer raytracer(scene);
  AreaVisibility areas(scene, false);
  std::vector<double> fractions(areas.lights().size());
  std::int64_t slices = 0;
  areas.findOnSurface(p, sector, normal, fractions, slices);
  std::size_t best = 0;
  std::pair most(false, 0.0);
  const std::vector<LightSource>& lights = scene.level().lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const LightSource& light = lights[i];
    const double fraction = light.isArea() ? fractions[areas.placeOf(i)] : 1;
    const double brought = fraction * light.brightnessAt(p);
    if (most.first && brought <= most.second) continue;
    const bool isSeen = light.isArea() ? fraction > 0 : sees(scene, raytracer, light, p, sector);
    const std::pair here(isSeen, brought);
    if (here > most) best = i, most = here;
  }
  return best;
}

bool isDark(const BakedLight& light, std::size_t surface) {
  const std::optional<Lightmap>& map = light.lightmaps[surface];
  const auto isZero = [](std::uint8_t level) { return level == 0; };
  return !map || std::ranges::all_of(map->levels, isZero);
}

std::string nameOf(const Level& level, const Surface& surface) {
  return fmt::format("{} of sector \"{}\"", name(surface.kind), level[surface.sector].name);
}

std::string nameOf(const Level& level, const LightSource& light) {
  if (light.isEmitter()) return fmt::format("the light of \"{}\"", light.texture);
  if (light.isSky) return "the sky";
  return light.sun ? "the sun"
                   : fmt::format("the light in sector \"{}\"", level[light.sector].name);
}

class BlackFinder {
 public:
  BlackFinder(const LintedLevel& linted, const BakedLight& light, Findings& findings)
      : linted_(linted),
        level_(linted.level()),
        light_(light),
        areas_(linted.scene()),
        findings_(findings) {}

  void look() {
    const std::vector<Counts> sectors = countSectors();
    for (std::size_t i = 0; i < sectors.size(); ++i)
      if (sectors[i].isBlack()) reportSector(i);
    for (std::size_t i = 0; i < level_.surfaces.size(); ++i)
      if (light_.surfaces[i] && isBlack(i) &&
          !sectors[level_.surfaces[i].sector.index()].isBlack() &&
          areaOf(*light_.surfaces[i]) >= kShadow)
        report(i);
  }

 private:
  /// Of a sector's surfaces that can be lit.
  struct Counts {
    int all = 0;
    int black = 0;
    bool isBlack() const { return all > 0 && black == all; }
  };

  std::vector<Counts> countSectors() const {
    std::vector<Counts> counts(level_.sectors.size());
    for (std::size_t i = 0; i < level_.surfaces.size(); ++i) {
      if (!light_.surfaces[i]) continue;
      Counts& sector = counts[level_.surfaces[i].sector.index()];
      ++sector.all;
      sector.black += isBlack(i) ? 1 : 0;
    }
    return counts;
  }

  bool isBlack(std::size_t surface) const {
    const Surface& of = level_.surfaces[surface];
    return level_[of.sector].light == 0 && isDark(light_, surface) && !shines(of);
  }

  bool shines(const Surface& surface) const {
    return canShine(surface.kind) && areas_.ofTexture(surface.mapping.texture);
  }

  void reportSector(std::size_t sector) {
    findings_.add(FindingKind::Black, linted_.source.level.sectors[sector].place,
                  fmt::format("all of sector \"{}\" is black: no light reaches it, and it has none",
                              level_.sectors[sector].name),
                  "give it a \"light\", or hang a lamp there");
  }

  void report(std::size_t surface) {
    findings_.add(FindingKind::Black, placeOf(linted_, SurfaceId(surface)),
                  fmt::format("{} is black: no light reaches it, and its sector has none",
                              nameOf(level_, level_.surfaces[surface])),
                  "give the sector a \"light\", or move a lamp");
  }

  const LintedLevel& linted_;
  const Level& level_;
  const BakedLight& light_;
  AreaLights areas_;
  Findings& findings_;
};

class OverexposedFinder {
 public:
  OverexposedFinder(const LintedLevel& linted, const BakedLight& dimmed, Findings& findings)
      : linted_(linted), level_(linted.level()), dimmed_(dimmed), findings_(findings) {}

  void look() {
    for (std::size_t i = 0; i < level_.surfaces.size(); ++i)
      // Who gives a sector all light there is wants its textures as they are.
      if (dimmed_.surfaces[i] && dimmed_.lightmaps[i] &&
          level_[level_.surfaces[i].sector].light < 1)
        lookAt(i);
    for (const auto& [light, glare] : glaring_) report(light, glare);
  }

 private:
  /// What one light overexposes, or most of it.
  struct Glare {
    int surfaces = 0;
    std::size_t worst = 0;  ///< surface
    double fraction = 0;    ///< of that
  };

  void lookAt(std::size_t surface) {
    const SectorId sector = level_.surfaces[surface].sector;
    const LitSurface& lit = *dimmed_.surfaces[surface];
    const Lightmap& map = *dimmed_.lightmaps[surface];
    const double fraction = lostFraction(lit, map, 255 * level_[sector].light);
    if (fraction <= kMaxLost) return;
    Glare& glare = glaring_[mostAt(linted_.scene(), brightestOf(lit, map), lit.normal, sector)];
    ++glare.surfaces;
    if (fraction <= glare.fraction) return;
    glare.worst = surface;
    glare.fraction = fraction;
  }

  void report(std::size_t light, const Glare& glare) {
    const int others = glare.surfaces - 1;
    findings_.add(
        FindingKind::Overexposed, linted_.source.lights.at(light).place,
        fmt::format("with this light {:.0f} % of {}{} has more than twice the light that can be "
                    "shown",
                    100 * glare.fraction, nameOf(level_, level_.surfaces[glare.worst]),
                    others == 0 ? "" : fmt::format(", and much of {} more,", others)),
        "lower its \"intensity\", or raise its \"falloff\"");
  }

  const LintedLevel& linted_;
  const Level& level_;
  const BakedLight& dimmed_;
  Findings& findings_;
  std::map<std::size_t, Glare> glaring_;  ///< by light
};

}  // namespace

Level dimmed(Level level) {
  for (LightSource& light : level.lights) {
    light.intensity *= kDimmed;
    for (CurvePoint& point : light.curve) point.level *= kDimmed;
  }
  return level;
}

std::string_view remedyOfUseless(const LightSource& light) {
  if (light.isEmitter())
    return "raise its intensity, give its texture to a surface that others see, or remove it";
  if (light.isSky) return "raise its intensity, open a way to some sky, or remove it";
  return light.sun ? "turn it to where some sky is seen, or remove it"
                   : "raise its intensity, move it or remove it";
}

/// Then the loader says so.
bool isUnworn(const Level& level, const LightSource& light) {
  const std::vector<std::string_view> names = texturesThatCanShine(level);
  return light.isEmitter() && std::ranges::find(names, light.texture) == names.end();
}

/// Bakes by itself, since light from a cache does not say which lamps it came from.
void findUselessLights(const LintedLevel& linted, const BakeSettings& settings, int threads,
                       Findings& findings) {
  const Level& level = linted.level();
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < level.lights.size(); ++i)
    if (!isUnworn(level, level.lights[i])) all.push_back(i);
  BakeSettings strong = settings;
  strong.cutOff = std::max(settings.cutOff, kWeak);
  const std::vector<std::size_t> dim = dimOf(linted.scene(), all, strong, threads);
  const std::vector<std::size_t> useless = dimOf(linted.scene(), dim, settings, threads);
  for (const std::size_t light : dim) {
    const bool isUseless = std::ranges::binary_search(useless, light);
    const std::string name = nameOf(level, level.lights[light]);
    findings.add(isUseless ? FindingKind::UselessLight : FindingKind::WeakLight,
                 linted.source.lights.at(light).place,
                 isUseless
                     ? fmt::format("{} reaches no surface", name)
                     : fmt::format("{} brings no surface more than {} of 255 levels", name, kWeak),
                 isUseless ? remedyOfUseless(level.lights[light])
                           : "raise its \"intensity\", of which 255 is full light");
  }
}

void findBlack(const LintedLevel& linted, const BakedLight& light, Findings& findings) {
  BlackFinder(linted, light, findings).look();
}

void findOverexposed(const LintedLevel& linted, const BakedLight& dimmed, Findings& findings) {
  OverexposedFinder(linted, dimmed, findings).look();
}

}  // namespace hearth
