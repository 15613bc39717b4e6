#include "light/light_hash.h"

#include "light/gather/area_lights.h"
#include "light/geometry_hash.h"
#include "math/hash.h"

namespace hearth {

namespace {

void add(Hash& hash, const BakeSettings& settings, bool haveAreas) {
  // By name, so that no new member is forgotten.
  const auto& [texel, samples, softSamples, cutOff, lambert, bounces, reflectance, gatherError,
               solidMaskedMiddles] = settings;
  hash.addReal(texel);
  hash.addReal(cutOff);
  for (const int number :
       {samples.value_or(0), softSamples, lambert ? 1 : 0, bounces, solidMaskedMiddles ? 1 : 0})
    hash.addWhole(static_cast<std::uint64_t>(number));
  if (bounces > 0) hash.addReal(reflectance);
  if (haveAreas) hash.addReal(gatherError);
}

}  // namespace

std::uint64_t lightHash(const Scene& scene, const BakeSettings& settings) {
  Hash hash;
  hash.addWhole(geometryHash(scene, settings.texel));
  const Level& level = scene.level();
  const AreaLights areas(scene);
  for (const std::uint64_t shining : hashesOfShining(level, areas)) hash.addWhole(shining);
  for (const Mesh& mesh : level.meshes) addShining(hash, level, areas, mesh);
  hash.addWhole(level.lights.size());
  for (const LightSource& light : level.lights) addLight(hash, light, light.sector.value);
  add(hash, settings, settings.bounces > 0 || !areas.lights().empty());
  if (settings.bounces > 0) addReflectances(hash, level);
  return hash.value();
}

}  // namespace hearth
