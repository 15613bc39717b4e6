#include "load/link/link.h"
#include "load/link/position_finder.h"

namespace hearth {

namespace {

class PositionLinker {
 public:
  explicit PositionLinker(Linking& linking)
      : linking_(linking), finder_(linking), movers_(linking.description) {}

  void linkPlayer(const PlayerDescription& described) {
    const auto sector =
        finder_.find(described.place, described.eye, described.sector, PositionOf::Camera);
    if (!sector) return;
    linking_.level.player = Player{*sector,
                                   described.eye,
                                   described.angle,
                                   described.height,
                                   described.eyeHeight,
                                   described.radius,
                                   described.stepHeight};
  }

  void linkShot(const ShotDescription& described) {
    const auto sector =
        finder_.find(described.cameraPlace, described.eye, described.sector, PositionOf::Camera);
    if (!sector) return;
    Shot shot{described.name,  *sector,          described.eye,
              described.angle, described.pitch,  described.fov,
              described.width, described.height, {}};
    for (const auto& [name, share] : described.movers)
      if (const auto mover = movers_.link(linking_.report, name))
        shot.movers.push_back({*mover, share});
    linking_.level.shots.push_back(std::move(shot));
  }

  void linkLights(const LightsDescription& lights) {
    for (const LightDescription& light : lights.lights) linkLight(light);
    for (const LightDescription& sun : lights.suns) linking_.level.lights.push_back(sun.source);
    if (lights.sky) linking_.level.lights.push_back(lights.sky->source);
    for (const LightDescription& emitter : lights.emitters) {
      linking_.level.lights.push_back(emitter.source);
      validateEmitter(linking_.report, linking_.level, emitter.place, emitter.source.texture);
    }
    linking_.level.bake = lights.bake;
  }

 private:
  void linkLight(const LightDescription& described) {
    const auto sector = finder_.find(described.place, described.source.position, described.sector,
                                     PositionOf::Light);
    if (!sector) return;
    linking_.level.lights.push_back(described.source);
    linking_.level.lights.back().sector = *sector;
    validateLight(linking_.report, linking_.scene(), described.place, linking_.level.lights.back());
  }

  Linking& linking_;
  PositionFinder finder_;
  MoverNames movers_;
};

}  // namespace

void linkPositions(Linking& linking, const LightsDescription& lights) {
  PositionLinker linker(linking);
  if (linking.description.player) linker.linkPlayer(*linking.description.player);
  for (const ShotDescription& shot : linking.description.shots) linker.linkShot(shot);
  linker.linkLights(lights);
}

void validateMeshPositions(Linking& linking) {
  if (linking.description.meshes.empty()) return;
  const PositionFinder finder(linking);
  for (const MeshDescription& mesh : linking.description.meshes) (void)finder.find(mesh);
}

void linkLights(Linking& linking, const LightsDescription& lights) {
  PositionLinker(linking).linkLights(lights);
}

bool saysNothingOfLight(const LevelDescription& description, const LightsDescription& lights) {
  const bool isSkyDark = !lights.sky || lights.sky->source.intensity == 0;
  if (!lights.lights.empty() || !lights.suns.empty() || !isSkyDark || !lights.emitters.empty() ||
      description.light)
    return false;
  for (const SectorDescription& sector : description.sectors)
    if (sector.light) return false;
  return true;
}

}  // namespace hearth
