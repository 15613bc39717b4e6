#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "level/sprite_sectors.h"
#include "level/thing_name.h"
#include "lint/lint.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Metres. Smaller things are most likely in another unit, or plain colours without a size.
constexpr double kTiny = 0.02;

/// Reports one of which nothing, or as good as nothing, shows.
class UnseenThings {
 public:
  UnseenThings(const LintedLevel& linted, Findings& findings)
      : linted_(linted),
        level_(linted.level()),
        findings_(findings),
        isInSector_(level_.meshes.size()) {
    for (const MeshInSector& there : level_.meshesBySector)
      if (isNear(level_[there.sector], level_.faceTrees[there.mesh].box()))
        isInSector_[there.mesh] = true;
  }

  void lookAtSprite(std::size_t i) {
    const Sprite& sprite = level_.sprites[i];
    const SpriteView& view = sprite.frames.front().front();
    const double larger = std::max(view.size.x, view.size.y);
    const Place place = linted_.source.level.sprites[i].place;
    const std::string name = fmt::format("sprite \"{}\"", nameOf(level_, sprite));
    if (larger < kTiny)
      return addTiny(place, name, larger,
                     "give its \"size\" in metres; without one, 64 texels are a metre");
    if (sprite.facing != Facing::Flat && !isInAir(sprite, view))
      addUnseen(place, name, "its whole image is above the ceiling or below the floor",
                "correct its \"z\" or \"offset\"");
  }

  void lookAtMesh(std::size_t i) {
    const Box3 box = level_.faceTrees[i].box();
    const Vec3 size = box.max - box.min;
    const double largest = std::max({size.x, size.y, size.z});
    const Place place = linted_.source.level.meshes[i].place;
    const std::string name = fmt::format("mesh \"{}\"", linted_.source.level.meshes[i].file.name);
    if (largest < kTiny) return addTiny(place, name, largest, "correct its \"scale\"");
    if (!isInSector_[i])
      addUnseen(place, name,
                fmt::format("it reaches from ({:.3g}, {:.3g}, {:.3g}) to ({:.3g}, {:.3g}, {:.3g}), "
                            "where no sector has air",
                            box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z),
                "move it, or centre the model on its origin");
  }

 private:
  /// Whether something between these heights is between a sector's floor and ceiling. In a closed
  /// door it counts as such: that may be meant to open.
  bool isBetween(const Sector& sector, double zBottom, double zTop) const {
    const double zFloor = linted_.scene().zFloor(sector);
    const double zCeiling = linted_.scene().zCeiling(sector);
    return zCeiling - zFloor <= kAuthorNoise || (zBottom <= zCeiling && zFloor <= zTop);
  }

  /// Whether the smallest boxes around both meet.
  bool isNear(const Sector& sector, const Box3& box) const {
    return overlap(sector.box, {box.min.xy(), box.max.xy()}) &&
           isBetween(sector, box.min.z, box.max.z);
  }

  /// Whether it is between floor and ceiling in some sector that it stands in.
  bool isInAir(const Sprite& sprite, const SpriteView& view) {
    const SpriteRect rect = rectOf(sprite, view, {1, 0});
    return std::ranges::any_of(sectors_.find(linted_.scene(), sprite, rect), [&](SectorId sector) {
      return isBetween(level_[sector], rect.corner.z, rect.corner.z + rect.up.z);
    });
  }

  void addTiny(Place place, const std::string& name, double size, std::string_view advice) {
    findings_.add(FindingKind::UnseenThing, place,
                  fmt::format("the {} is {:.3g} m large", name, size), advice);
  }

  void addUnseen(Place place, const std::string& name, std::string_view reason,
                 std::string_view advice) {
    findings_.add(FindingKind::UnseenThing, place,
                  fmt::format("the {} never shows: {}", name, reason), advice);
  }

  const LintedLevel& linted_;
  const Level& level_;
  Findings& findings_;
  std::vector<bool> isInSector_;  ///< by mesh
  SpriteSectors sectors_;
};

}  // namespace

void findUnseenThings(const LintedLevel& linted, Findings& findings) {
  UnseenThings things(linted, findings);
  for (std::size_t i = 0; i < linted.level().sprites.size(); ++i) things.lookAtSprite(i);
  for (std::size_t i = 0; i < linted.level().meshes.size(); ++i) things.lookAtMesh(i);
}

}  // namespace hearth
