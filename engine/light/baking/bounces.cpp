#include "light/baking/bounces.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "light/baking/irradiance_bake.h"
#include "math/check.h"

namespace hearth {

namespace {

bool isGrey(const Level& level) {
  return std::ranges::none_of(level.lights, &LightSource::isColored) &&
         std::ranges::all_of(level.reflectances,
                             [](Vec3 of) { return of.x == of.y && of.y == of.z; });
}

/// Those of the level and, last, light that bounces: one for each channel, unless all is grey.
std::vector<LightSource> withBounced(const Level& level) {
  std::vector<LightSource> lights = level.lights;
  LightSource bounced;
  bounced.intensity = 1;
  bounced.isBounced = true;
  if (isGrey(level)) {
    lights.push_back(bounced);
    return lights;
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::ranges::fill(bounced.color, std::uint8_t{0});
    bounced.color[channel] = 255;
    lights.push_back(bounced);
  }
  return lights;
}

}  // namespace

Bounces::Bounces(const Scene& scene, const BakeSettings& settings, int threads)
    : scene_(scene),
      settings_(settings),
      threads_(threads),
      lights_(settings.bounces > 0 && !scene.level().lights.empty() ? withBounced(scene.level())
                                                                    : scene.level().lights) {}

bool Bounces::find(BakeProgress& progress, const std::stop_token& stop) {
  if (!haveLight() || irradiance_) return true;
  const std::vector<LightSource> bounced(lights_.begin() + std::ssize(scene_.level().lights),
                                         lights_.end());
  const IrradianceBake bake(scene_, settings_, threads_);
  progress.extend(bake.texels() * settings_.bounces);
  auto last = bake.lightOf(scene_, nullptr, progress, stop);
  if (!last) return false;
  LightOfPieces sum = *last;
  // Of each bounce alone: it is dimmer and more even than the one before, and so found faster.
  for (int bounce = 1; bounce < settings_.bounces; ++bounce) {
    const Irradiance reflected = bake.irradiance(*last);
    last = bake.lightOf(scene_.litBy(bounced), &reflected, progress, stop);
    if (!last) return false;
    // White light can be added to coloured light, which what bounces may be.
    LightOfPieces all = *last;
    all.add(sum);
    sum = std::move(all);
  }
  irradiance_.emplace(bake.irradiance(sum));
  return true;
}

const Irradiance* Bounces::irradiance() const {
  if (!haveLight()) return nullptr;
  CHECK(irradiance_.has_value(), settings_.bounces);
  return &*irradiance_;
}

}  // namespace hearth
