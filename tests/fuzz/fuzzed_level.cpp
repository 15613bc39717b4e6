#include "fuzzed_level.h"

#include <algorithm>
#include <vector>

#include "level/locate.h"
#include "light/bakery.h"
#include "light/grid/texel_limits.h"
#include "math/check.h"
#include "math/tolerance.h"
#include "render/renderer.h"

namespace hearth::fuzz {

namespace {

constexpr std::size_t kPlaces = 6;  ///< from which a level is looked at, at most
constexpr int kWidth = 24;          ///< pixels
constexpr int kHeight = 16;
constexpr double kTexels = 24;      ///< across the level, at most
constexpr std::size_t kLights = 4;  ///< of those that a level has; more only take longer

/// The eyes of player and shots, and a place in the middle of some walls.
std::vector<Camera> placesOf(const Scene& scene) {
  const Level& level = scene.level();
  std::vector<Camera> cameras;
  if (level.player)
    cameras.push_back({level.player->sector, level.player->eye, level.player->angle});
  for (const Shot& shot : level.shots) cameras.push_back(cameraOf(shot));
  const std::size_t step = level.segments.size() / kPlaces + 1;
  for (std::size_t i = 0; i < level.segments.size(); i += step) {
    const Segment& segment = level.segments[i];
    const Vec2 p = lerp(segment.p0, segment.p1, 0.5);
    const Sector& sector = level[segment.sector];
    const double z = (scene.airBottom(sector, p) + scene.airTop(sector, p)) / 2;
    if (contains(scene, sector, Vec3{p.x, p.y, z}, kPositionSlack))  // else the wall is buried
      cameras.push_back({segment.sector, {p.x, p.y, z}, compassDegrees(segment.p1 - segment.p0)});
  }
  if (cameras.size() > kPlaces) cameras.resize(kPlaces);
  for (Camera& camera : cameras) camera.width = kWidth, camera.height = kHeight;
  return cameras;
}

/// Metres: a texel so coarse that a bake is short.
double coarseTexel(const Level& level) {
  double size = 0;
  for (const Sector& sector : level.sectors)
    size = std::max({size, sector.box.max.x - sector.box.min.x, sector.box.max.y - sector.box.min.y,
                     sector.ceiling.z - sector.floor.z});
  return std::max(level.bake.texel, size / kTexels);
}

BakedLight coarseLight(const LoadedLevel& loaded, const std::vector<Camera>& places) {
  Level level = loaded.level;
  if (level.lights.empty() && !places.empty()) {
    LightSource light;
    light.position = places.front().eye;
    light.sector = places.front().sector;
    level.lights.push_back(light);
  }
  if (level.lights.size() > kLights) level.lights.resize(kLights);
  BakeSettings settings = level.bake;
  settings.texel = coarseTexel(level);
  settings.softSamples = 16;
  if (settings.samples) settings.samples = std::min(*settings.samples, 4);
  settings.bounces = 0;  // which are found on many texels, however few the bake has
  BakedLight none;
  none.surfaces.resize(level.surfaces.size());
  none.lightmaps.resize(level.surfaces.size());
  const Scene scene(level, loaded.geometry);
  return mistakeInTexel(scene, settings.texel) ? none : bake(scene, settings, 1);
}

}  // namespace

void expectSaid(const LoadResult& result) {
  const bool hasErrors =
      std::ranges::any_of(result.diagnostics, [](const Diagnostic& d) { return d.isError; });
  CHECK(result.loaded.has_value() != hasErrors);
  for (const Diagnostic& diagnostic : result.diagnostics)
    CHECK(!diagnostic.message.empty() && !diagnostic.file.empty() && diagnostic.line >= 1 &&
              diagnostic.column >= 1,
          format(diagnostic));
}

void expectUsable(const LoadedLevel& loaded) {
  const std::vector<Camera> places = placesOf(loaded.scene());
  const BakedLight light = coarseLight(loaded, places);
  const Renderer renderer(loaded.scene(), loaded.textures, light);
  for (const Camera& camera : places) {
    const Image drawn = renderer.draw(camera, Channel::Overdraw);
    CHECK(std::ranges::find(drawn.pixels(), kHole) == drawn.pixels().end(), camera.eye.x,
          camera.eye.y, camera.eye.z, camera.angle);
    (void)renderer.draw(camera, LightMode::Both);
  }
}

}  // namespace hearth::fuzz
