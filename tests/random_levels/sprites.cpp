#include "random_levels/sprites.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/trig.h"
#include "random_levels/thing_places.h"

namespace hearth::random_levels {
namespace {

constexpr std::size_t kAttempts = 60;
constexpr double kFromEyePlane = 0.001;  // m
constexpr double kTexelsPerMetre = 64;   // of sprites that say no size

class SpriteMaker {
 public:
  SpriteMaker(Random& random, const Model& model, const std::vector<RandomView>& views,
              std::set<Feature>& features)
      : random_(random),
        model_(model),
        views_(views),
        features_(features),
        places_(random, model, views) {}

  std::vector<RandomSprite> make(std::size_t count) {
    for (std::size_t i = 0; i < kAttempts * count && sprites_.size() < count; ++i) {
      const bool isRepeated = !sprites_.empty() && random_.chance(0.25);
      RandomSprite sprite = isRepeated ? repeated(sprites_.back()) : looks();
      if (!isRepeated && !place(sprite)) continue;
      keep(std::move(sprite));
    }
    return sprites_;
  }

 private:
  // ---- what they look like

  RandomSprite looks() {
    RandomSprite sprite;
    sprite.facing = random_.pick({SpriteFacing::Camera, SpriteFacing::Angle, SpriteFacing::Flat});
    sprite.angle = rounded(random_.real(0, 360));
    sprite.images = images();
    if (random_.chance(0.65)) {
      const double width = random_.pick({0.25, 0.5, 0.8, 1.25, 2.0});
      sprite.size = {width, random_.pick({0.25, 0.5, 0.8, 1.25, 2.0})};
    }
    if (random_.chance(0.35)) {
      const double right = random_.pick({0.0, 0.25, -0.4, 0.125});
      sprite.offset = {right, random_.pick({-0.2, 0.1, -0.05, 0.3})};
    }
    sprite.isBright = random_.chance(0.25);
    return sprite;
  }

  /// At the same place with other images, which hide those of the first.
  RandomSprite repeated(RandomSprite sprite) {
    sprite.images = images();
    features_.insert(Feature::SpritesAtOnePlace);
    return sprite;
  }

  std::vector<std::string> images() {
    std::vector<std::string> images;
    const std::int64_t count = random_.chance(0.4) ? random_.between(2, 8) : 1;
    for (std::int64_t i = 0; i < count; ++i) images.push_back(image());
    return images;
  }

  std::string image() {
    if (random_.chance(0.05)) return fmt::format("#{:06x}", random_.below(0x1000000));
    if (random_.chance(0.6)) return std::string(random_.pickFrom(kRandomLevelMiddles).name);
    return std::string(random_.pickFrom(kRandomLevelTextures).name);
  }

  static double heightOf(const RandomSprite& sprite) {
    if (sprite.size) return (*sprite.size)[1];
    const auto rows = [&](const auto& textures) {
      for (const RandomTexture& texture : textures)
        if (texture.name == sprite.images[0]) return texture.height;
      return 0;
    };
    const int found = rows(kRandomLevelTextures) + rows(kRandomLevelMiddles);
    return std::max(1, found) / kTexelsPerMetre;
  }

  // ---- where they are

  /// True if it is placed; most often where few levels have such a place.
  bool place(RandomSprite& sprite) {
    if (sprites_.empty() && attempt(sprite, &SpriteMaker::behindMiddle)) return true;
    if (random_.chance(0.25) && attempt(sprite, &SpriteMaker::acrossFlatPortal)) return true;
    if (random_.chance(0.2) && attempt(sprite, &SpriteMaker::onWall)) return true;
    const double dice = random_.unit();
    if (dice < 0.2) return attempt(sprite, &SpriteMaker::acrossPortal);
    if (dice < 0.45) return attempt(sprite, &SpriteMaker::halfInWall);
    if (dice < 0.65) return attempt(sprite, &SpriteMaker::onTwoFloors);
    return attempt(sprite, &SpriteMaker::beforeEye);
  }

  using Placing = std::optional<Feature> (SpriteMaker::*)(RandomSprite&);
  bool attempt(RandomSprite& sprite, Placing placing) {
    for (std::size_t i = 0; i < kAttempts; ++i) {
      RandomSprite placed = sprite;
      const std::optional<Feature> feature = (this->*placing)(placed);
      if (!feature || isEdgeOn(placed)) continue;
      features_.insert(*feature);
      sprite = placed;
      return true;
    }
    return false;
  }

  bool isEdgeOn(const RandomSprite& sprite) const {
    return std::ranges::any_of(views_, [&](const RandomView& view) {
      const Vec3 eye{view.x, view.y, view.z};
      const Vec3 toEye = eye - sprite.place.position;
      if (sprite.facing == SpriteFacing::Flat) return std::abs(toEye.z) < kFromEyePlane;
      const double angle = sprite.facing == SpriteFacing::Camera ? view.angle : sprite.angle;
      return std::abs(dot(along(angle), toEye.xy())) < kFromEyePlane;
    });
  }

  static bool setPlace(RandomSprite& sprite, const std::optional<Place>& found) {
    if (found) sprite.place = *found;
    return found.has_value();
  }

  std::optional<Feature> beforeEye(RandomSprite& sprite) {
    const double middle = sprite.facing == SpriteFacing::Flat ? 0 : heightOf(sprite) / 2;
    if (!setPlace(sprite, places_.beforeEye(middle))) return std::nullopt;
    return Feature::SpriteBeforeEye;
  }

  /// In the opening, or up to 0.3 m before it; at times in its plane.
  std::optional<Feature> acrossPortal(RandomSprite& sprite) {
    const auto wall = places_.wallNear(isPortal);
    if (!wall) return std::nullopt;
    const Sector& next = model_.sectors[onlyPortal(*wall->wall)->next];
    Vec2 p = lerp(wall->a, wall->b, random_.pick({0.5, 0.25, 0.75}));
    const double low =
        std::max(model_.floorAt(model_.sectors[wall->sector], p), model_.floorAt(next, p));
    const bool isInside = random_.chance(0.4);
    if (isInside) p = rounded(p + random_.real(0.02, 0.3) * wall->inward());
    if (isInside && !model_.coversMap(model_.sectors[wall->sector], p)) return std::nullopt;
    if (!isInside && random_.chance(0.4)) {
      sprite.facing = SpriteFacing::Angle;
      sprite.angle = compassDegrees(wall->inward());
    }
    const double z = random_.chance(0.5) ? low : low + random_.real(0, 0.8);
    if (!setPlace(sprite, places_.put(wall->sector, p, z))) return std::nullopt;
    return Feature::SpriteAcrossPortal;
  }

  /// So near to a solid wall that a part of it is in the wall.
  std::optional<Feature> halfInWall(RandomSprite& sprite) {
    const auto wall = places_.wallNear(isSolid);
    const auto p = wall ? places_.before(*wall, {0.1, 0.9}, {0.02, 0.15}) : std::nullopt;
    if (!p) return std::nullopt;
    sprite.size = {1.25, random_.pick({0.5, 1.25, 2.0})};
    const double z = model_.floorAt(model_.sectors[wall->sector], *p) + random_.pick({0.0, 0.4});
    if (!setPlace(sprite, places_.put(wall->sector, *p, z))) return std::nullopt;
    return Feature::SpriteInWall;
  }

  /// Exactly in the plane of a solid wall, like a poster.
  std::optional<Feature> onWall(RandomSprite& sprite) {
    const auto wall = places_.wallNear(isSolid);
    if (!wall) return std::nullopt;
    const Vec2 p = lerp(wall->a, wall->b, random_.pick({0.5, 0.25, 0.75}));
    sprite.facing = SpriteFacing::Angle;
    sprite.angle = compassDegrees(wall->inward());
    const double z = model_.floorAt(model_.sectors[wall->sector], p) + random_.real(0.1, 1);
    if (!setPlace(sprite, places_.put(wall->sector, p, z))) return std::nullopt;
    return Feature::SpriteOnWall;
  }

  /// Exactly on the floors on both sides of a portal, or over the edge of the higher one.
  std::optional<Feature> onTwoFloors(RandomSprite& sprite) {
    const auto wall = places_.wallNear(isPortal);
    if (!wall || model_.sectors[wall->sector].floor.wedge) return std::nullopt;
    const auto p = places_.before(*wall, {0.2, 0.8}, {0.01, 0.2});
    if (!p) return std::nullopt;
    sprite.facing = SpriteFacing::Flat;
    sprite.size = {1.25, random_.pick({0.5, 0.8, 2.0})};
    const double z = metres(model_.sectors[wall->sector].floor.z);
    if (!setPlace(sprite, places_.put(wall->sector, *p, z))) return std::nullopt;
    return Feature::SpriteOnFloors;
  }

  /// Below an opening upwards and through it, or in its plane.
  std::optional<Feature> acrossFlatPortal(RandomSprite& sprite) {
    const auto at = places_.atFlatPortal();
    if (!at) return std::nullopt;
    sprite.size = {random_.pick({0.5, 1.25}), random_.pick({0.8, 1.25, 2.0})};
    const bool isLying = sprite.facing == SpriteFacing::Flat;
    const double below = isLying ? 0 : random_.real(0.2, 0.8) * heightOf(sprite);
    if (!setPlace(sprite, places_.put(at->sector, at->p, at->plane - below))) return std::nullopt;
    return Feature::SpriteAcrossFlatPortal;
  }

  std::optional<Feature> behindMiddle(RandomSprite& sprite) {
    if (!setPlace(sprite, places_.behindMiddle())) return std::nullopt;
    return Feature::SpriteBehindMiddle;
  }

  // ---- how they are written

  void keep(RandomSprite sprite) {
    sprite.saysHeight = !places_.isOnFloor(sprite.place) || random_.chance(0.4);
    const bool isUnique = model_.sectorsAround(sprite.place.position, 0.002).size() == 1;
    sprite.namesSector = !isUnique || !sprite.saysHeight || random_.chance(0.4);
    note(sprite);
    sprites_.push_back(std::move(sprite));
  }

  void note(const RandomSprite& sprite) {
    constexpr std::array kFacings{Feature::CameraSprite, Feature::FixedSprite, Feature::FlatSprite};
    features_.insert(kFacings[static_cast<std::size_t>(sprite.facing)]);
    if (sprite.images.size() > 1) features_.insert(Feature::SpriteOfSeveralViews);
    if (!sprite.size) features_.insert(Feature::SpriteWithoutSize);
    if (sprite.offset) features_.insert(Feature::SpriteWithOffset);
    if (sprite.isBright) features_.insert(Feature::BrightSprite);
    if (!sprite.saysHeight) features_.insert(Feature::SpriteWithoutHeight);
    if (!sprite.namesSector) features_.insert(Feature::SpriteWithoutSector);
  }

  Random& random_;
  const Model& model_;
  const std::vector<RandomView>& views_;
  std::set<Feature>& features_;
  ThingPlaces places_;
  std::vector<RandomSprite> sprites_;
};

}  // namespace

std::vector<RandomSprite> makeSprites(Random& random, const Model& model,
                                      const std::vector<RandomView>& views,
                                      std::set<Feature>& features) {
  const std::int64_t count = random.between(1, 6);
  return SpriteMaker(random, model, views, features).make(static_cast<std::size_t>(count));
}

}  // namespace hearth::random_levels
