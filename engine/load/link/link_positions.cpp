#include "load/link/link.h"
#include "load/positions.h"

namespace hearth {

namespace {

class PositionLinker {
 public:
  explicit PositionLinker(Linking& linking) : linking_(linking), locator_(linking.scene()) {
    for (const bool isDoubtful : linking.isDoubtful) anyDoubtful_ |= isDoubtful;
  }

  void linkPlayer(const PlayerDescription& described) {
    const auto sector =
        locate(described.place, described.eye, described.sector, PositionOf::Camera);
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
        locate(described.cameraPlace, described.eye, described.sector, PositionOf::Camera);
    if (!sector) return;
    linking_.level.shots.push_back({described.name, *sector, described.eye, described.angle,
                                    described.pitch, described.fov, described.width,
                                    described.height});
  }

  void linkSprite(const SpriteDescription& described) {
    std::vector<std::vector<SpriteView>> frames;
    for (const std::vector<NameReference>& views : described.frames) {
      std::vector<SpriteView>& frame = frames.emplace_back();
      for (const NameReference& image : views)
        frame.push_back({linking_.textures.idOf(image), described.size.value_or(Vec2{})});
    }
    const auto sector = locateSprite(described);
    if (!sector) return;
    Sprite& sprite = linking_.level.sprites.emplace_back(described.sprite);
    const Vec2 xy = described.position;
    const double z = described.z.value_or(linking_.scene().airBottom(linking_.level[*sector], xy));
    sprite.position = {xy.x, xy.y, z};
    sprite.sector = *sector;
    sprite.frames = std::move(frames);
  }

  void linkLights(const LightsDescription& lights) {
    for (const LightDescription& light : lights.lights) linkLight(light);
    linking_.level.bake = lights.bake;
  }

 private:
  void linkLight(const LightDescription& described) {
    const auto sector =
        locate(described.place, described.source.position, described.sector, PositionOf::Light);
    if (!sector) return;
    linking_.level.lights.push_back(described.source);
    linking_.level.lights.back().sector = *sector;
    validateLight(linking_.report, linking_.scene(), described.place, linking_.level.lights.back());
  }

  std::optional<SectorId> locateSprite(const SpriteDescription& described) {
    const Vec2 xy = described.position;
    return locate(described.place, described.sector, [&](std::optional<SectorId> sector) {
      return described.z ? locator_.locate({xy.x, xy.y, *described.z}, sector, PositionOf::Camera)
                         : locator_.locateOnFloor(xy, sector);
    });
  }

  std::optional<SectorId> locate(Place place, Vec3 p, const std::optional<NameReference>& name,
                                 PositionOf what) {
    return locate(place, name,
                  [&](std::optional<SectorId> sector) { return locator_.locate(p, sector, what); });
  }

  /// `find(sector)` looks in the sector that the author names, or in all.
  template <typename Find>
  std::optional<SectorId> locate(Place place, const std::optional<NameReference>& name,
                                 Find&& find) {
    std::optional<SectorId> sector;
    if (name) {
      sector = linking_.names.link(linking_.report, *name);
      if (!sector) return std::nullopt;
    }
    // It may be in a sector about which a mistake has been reported.
    if (sector ? linking_.isDoubtful[sector->index()] : anyDoubtful_) return std::nullopt;
    if (linking_.report.isFull()) return std::nullopt;
    const auto found = find(sector);
    if (found) return *found;
    linking_.report.error(place, found.error().message, found.error().advice);
    return std::nullopt;
  }

  Linking& linking_;
  Locator locator_;
  bool anyDoubtful_ = false;
};

}  // namespace

void linkSprites(Linking& linking) {
  PositionLinker linker(linking);
  for (const SpriteDescription& sprite : linking.description.sprites) linker.linkSprite(sprite);
}

void linkPositions(Linking& linking, const LightsDescription& lights) {
  PositionLinker linker(linking);
  if (linking.description.player) linker.linkPlayer(*linking.description.player);
  for (const ShotDescription& shot : linking.description.shots) linker.linkShot(shot);
  linker.linkLights(lights);
}

void linkLights(Linking& linking, const LightsDescription& lights) {
  PositionLinker(linking).linkLights(lights);
}

bool saysNothingOfLight(const LevelDescription& description, const LightsDescription& lights) {
  if (!lights.lights.empty() || description.light) return false;
  for (const SectorDescription& sector : description.sectors)
    if (sector.light) return false;
  return true;
}

}  // namespace hearth
