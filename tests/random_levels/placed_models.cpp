#include "random_levels/placed_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/trig.h"
#include "random_levels/thing_places.h"

namespace hearth::random_levels {
namespace {

constexpr std::size_t kAttempts = 60;
constexpr double kFromEyePlane = 0.001;  // m
constexpr double kHuge = 4;              // m, as the next
constexpr double kTiny = 0.05;

class ModelPlacer {
 public:
  ModelPlacer(Random& random, const Model& model, const std::vector<RandomView>& views,
              const std::vector<RandomSprite>& sprites, std::set<Feature>& features)
      : random_(random),
        model_(model),
        views_(views),
        sprites_(sprites),
        features_(features),
        places_(random, model, views) {}

  /// Each in another kind of place, as far as there are such.
  std::vector<PlacedModel> make(std::size_t count) {
    const std::vector<Placing> placings = chosenPlacings();
    for (std::size_t i = 0; i < kAttempts && placed_.size() < count; ++i) {
      const bool isRepeated = !placed_.empty() && random_.chance(0.15);
      PlacedModel next = looks();
      const Placing placing = isRepeated ? &ModelPlacer::atLast : placings[i % placings.size()];
      if (attempt(next, placing)) keep(std::move(next));
    }
    return placed_;
  }

 private:
  using Placing = std::optional<Feature> (ModelPlacer::*)(PlacedModel&);

  /// Those for which few levels have a place mostly come first.
  std::vector<Placing> chosenPlacings() {
    std::vector<Placing> placings{&ModelPlacer::acrossPortal, &ModelPlacer::halfInWall,
                                  &ModelPlacer::onWall,       &ModelPlacer::onTwoFloors,
                                  &ModelPlacer::aroundEye,    &ModelPlacer::beforeEye};
    random_.shuffle(placings);
    for (const Placing rare :
         {&ModelPlacer::acrossFlatPortal, &ModelPlacer::behindMiddle, &ModelPlacer::atSprite})
      placings.insert(random_.chance(0.6) ? placings.begin() : placings.end(), rare);
    return placings;
  }

  // ---- what they look like

  PlacedModel looks() {
    PlacedModel placed;
    wear(placed, random_.below(models_.size()));
    setScale(placed, size());
    const bool isAligned = random_.chance(0.35);
    placed.angle =
        isAligned ? 45.0 * static_cast<double>(random_.below(8)) : rounded(random_.real(0, 360));
    placed.isTwoSided = random_.chance(models_[placed.model].isClosed ? 0.25 : 0.6);
    return placed;
  }

  void wear(PlacedModel& placed, std::size_t model) {
    placed.model = model;
    placed.texture = models_[model].skin == ObjSkin::OfThing ? texture() : "";
  }

  /// Some of them with holes, which are to be ignored.
  std::string texture() {
    if (random_.chance(0.2)) return fmt::format("#{:06x}", random_.below(0x1000000));
    if (random_.chance(0.2)) return std::string(random_.pickFrom(kRandomLevelMiddles).name);
    return std::string(random_.pickFrom(kRandomLevelTextures).name);
  }

  double size() {
    const double dice = random_.unit();
    if (dice < 0.25) return random_.pick({5.0, 7.5, 10.0});
    if (dice < 0.45) return random_.pick({0.01, 0.03});
    return random_.pick({0.1, 0.25, 0.5, 0.8, 1.25, 2.0, 3.0});
  }

  void setScale(PlacedModel& placed, double size) {
    const bool isUneven = random_.chance(0.35);
    for (double& factor : placed.scale)
      factor = isUneven ? rounded(size * random_.pick({0.5, 0.75, 1.0, 1.6})) : size;
  }

  // ---- where their corners are

  /// From its position to a vertex of its file.
  static Vec3 fromPosition(const PlacedModel& placed, Vec3 vertex) {
    const Vec2 plan{placed.scale[0] * vertex.x, placed.scale[1] * vertex.z};
    const Vec2 x = along(placed.angle);
    const Vec2 turned = plan.x * x + plan.y * turned90(x);
    return {turned.x, turned.y, placed.scale[2] * vertex.y};
  }

  /// Of the corners, from the position up.
  Interval heightsOf(const PlacedModel& placed) const {
    const auto [low, high] = std::ranges::minmax(models_[placed.model].vertices, {}, &Vec3::y);
    return {placed.scale[2] * low.y, placed.scale[2] * high.y};
  }

  /// A point in the box around it.
  Vec3 inBoxOf(const PlacedModel& placed) {
    const auto axisPlace = [&](double Vec3::*axis) {
      const auto [low, high] = std::ranges::minmax(models_[placed.model].vertices, {}, axis);
      return low.*axis + random_.real(0.2, 0.8) * (high.*axis - low.*axis);
    };
    Vec3 p;
    p.x = axisPlace(&Vec3::x);
    p.y = axisPlace(&Vec3::y);
    p.z = axisPlace(&Vec3::z);
    return fromPosition(placed, p);
  }

  // ---- where they are

  /// True if it is placed.
  bool attempt(PlacedModel& placed, Placing placing) {
    for (std::size_t i = 0; i < kAttempts; ++i) {
      PlacedModel next = placed;
      const std::optional<Feature> feature = (this->*placing)(next);
      if (!feature || isEdgeOn(next)) continue;
      features_.insert(*feature);
      placed = next;
      return true;
    }
    return false;
  }

  bool isEdgeOn(const PlacedModel& placed) const {
    const auto corner = [&](std::size_t vertex) {
      return placed.place.position + fromPosition(placed, models_[placed.model].vertices[vertex]);
    };
    const auto isInPlane = [&](Vec3 a, Vec3 b, Vec3 c) {
      const Vec3 normal = cross(b - a, c - a);
      return std::ranges::any_of(views_, [&](const RandomView& view) {
        const double above = dot(normal, Vec3{view.x, view.y, view.z} - a);
        return std::abs(above) < kFromEyePlane * length(normal);
      });
    };
    for (const auto& polygon : models_[placed.model].polygons)
      for (std::size_t k = 2; k < polygon.size(); ++k)
        if (isInPlane(corner(polygon[0]), corner(polygon[k - 1]), corner(polygon[k]))) return true;
    return false;
  }

  static bool setPlace(PlacedModel& placed, const std::optional<Place>& found) {
    if (found) placed.place = *found;
    return found.has_value();
  }

  std::optional<Feature> atLast(PlacedModel& placed) {
    placed.place = placed_.back().place;
    if (random_.chance(0.5)) placed.angle = placed_.back().angle;
    return Feature::MeshesAtOnePlace;
  }

  std::optional<Feature> beforeEye(PlacedModel& placed) {
    const Interval heights = heightsOf(placed);
    if (!setPlace(placed, places_.beforeEye((heights.low + heights.high) / 2))) return std::nullopt;
    return Feature::MeshBeforeEye;
  }

  /// So that a view's eye is in its box.
  std::optional<Feature> aroundEye(PlacedModel& placed) {
    const RandomView& view = random_.pickFrom(views_);
    const auto sector = std::ranges::find(model_.sectors, view.sector, &Sector::name);
    if (random_.chance(0.7)) setScale(placed, random_.pick({0.5, 1.25, 3.0}));
    const Vec3 inside = inBoxOf(placed);
    const Vec2 p = rounded(Vec2{view.x, view.y} - inside.xy());
    if (!model_.coversMap(*sector, p)) return std::nullopt;
    const auto s = static_cast<SectorIndex>(sector - model_.sectors.begin());
    if (!setPlace(placed, places_.put(s, p, view.z - inside.z))) return std::nullopt;
    const Interval heights = heightsOf(placed);
    const double above = view.z - placed.place.position.z;
    if (above < heights.low || above > heights.high) return std::nullopt;
    return Feature::MeshAroundEye;
  }

  /// In the opening, or up to 0.3 m before it; at times with faces parallel to its plane.
  std::optional<Feature> acrossPortal(PlacedModel& placed) {
    const auto wall = places_.wallNear(isPortal);
    if (!wall) return std::nullopt;
    const Sector& next = model_.sectors[onlyPortal(*wall->wall)->next];
    std::optional<Vec2> p = lerp(wall->a, wall->b, random_.pick({0.5, 0.25, 0.75}));
    const double low =
        std::max(model_.floorAt(model_.sectors[wall->sector], *p), model_.floorAt(next, *p));
    if (random_.chance(0.4)) p = places_.before(*wall, {0.2, 0.8}, {0.02, 0.3});
    if (!p) return std::nullopt;
    if (random_.chance(0.4)) placed.angle = compassDegrees(wall->inward());
    const double z = random_.chance(0.5) ? low : low + random_.real(0, 0.8);
    if (!setPlace(placed, places_.put(wall->sector, *p, z))) return std::nullopt;
    return Feature::MeshAcrossPortal;
  }

  /// So near to a solid wall that a part of it is in the wall.
  std::optional<Feature> halfInWall(PlacedModel& placed) {
    const auto wall = places_.wallNear(isSolid);
    const auto p = wall ? places_.before(*wall, {0.1, 0.9}, {0.01, 0.1}) : std::nullopt;
    if (!p || placed.model == kObjPanel) return std::nullopt;
    setScale(placed, random_.pick({0.5, 1.25, 2.0}));
    const double z = model_.floorAt(model_.sectors[wall->sector], *p) + random_.pick({0.0, 0.4});
    if (!setPlace(placed, places_.put(wall->sector, *p, z))) return std::nullopt;
    return Feature::MeshInWall;
  }

  /// Exactly in the plane of a solid wall, like a poster.
  std::optional<Feature> onWall(PlacedModel& placed) {
    const auto wall = places_.wallNear(isSolid);
    if (!wall) return std::nullopt;
    const Vec2 p = lerp(wall->a, wall->b, random_.pick({0.5, 0.25, 0.75}));
    wear(placed, kObjPanel);
    placed.angle = compassDegrees(wall->inward());
    setScale(placed, random_.pick({0.25, 0.5, 1.25}));
    const double z = model_.floorAt(model_.sectors[wall->sector], p) + random_.real(0.1, 1);
    if (!setPlace(placed, places_.put(wall->sector, p, z))) return std::nullopt;
    return Feature::MeshOnWall;
  }

  /// Exactly on the floors on both sides of a portal, or over the edge of the higher one.
  std::optional<Feature> onTwoFloors(PlacedModel& placed) {
    const auto wall = places_.wallNear(isPortal);
    if (!wall || model_.sectors[wall->sector].floor.wedge) return std::nullopt;
    const auto p = places_.before(*wall, {0.2, 0.8}, {0.01, 0.2});
    if (!p) return std::nullopt;
    if (random_.chance(0.5)) wear(placed, kObjTile);
    setScale(placed, random_.pick({0.5, 1.25, 2.0}));
    const double z = metres(model_.sectors[wall->sector].floor.z);
    if (!setPlace(placed, places_.put(wall->sector, *p, z))) return std::nullopt;
    return Feature::MeshOnFloors;
  }

  /// Through an opening upwards, or in its plane.
  std::optional<Feature> acrossFlatPortal(PlacedModel& placed) {
    const auto at = places_.atFlatPortal();
    if (!at) return std::nullopt;
    if (random_.chance(0.25)) wear(placed, kObjTile);
    if (random_.chance(0.5)) setScale(placed, random_.pick({0.5, 0.8, 1.25, 2.0}));
    const Interval heights = heightsOf(placed);
    const double below = heights.low + random_.real(0.2, 0.8) * (heights.high - heights.low);
    if (!setPlace(placed, places_.put(at->sector, at->p, at->plane - below))) return std::nullopt;
    return Feature::MeshAcrossFlatPortal;
  }

  std::optional<Feature> behindMiddle(PlacedModel& placed) {
    if (!setPlace(placed, places_.behindMiddle())) return std::nullopt;
    return Feature::MeshBehindMiddle;
  }

  /// At the place of a sprite, and in its plane if that does not turn with the eye.
  std::optional<Feature> atSprite(PlacedModel& placed) {
    if (sprites_.empty()) return std::nullopt;
    const RandomSprite& sprite = random_.pickFrom(sprites_);
    if (sprite.facing == SpriteFacing::Flat) wear(placed, kObjTile);
    if (sprite.facing == SpriteFacing::Angle) wear(placed, kObjPanel);
    placed.angle = sprite.angle;
    setScale(placed, random_.pick({0.25, 0.5, 0.8, 1.25}));
    placed.place = sprite.place;
    return Feature::MeshAtSprite;
  }

  // ---- how they are written

  void keep(PlacedModel placed) {
    placed.saysHeight = !places_.isOnFloor(placed.place) || random_.chance(0.4);
    const bool isUnique = model_.sectorsAround(placed.place.position, 0.002).size() == 1;
    placed.namesSector = !isUnique || !placed.saysHeight || random_.chance(0.4);
    placed.spritesBefore = random_.below(sprites_.size() + 1);
    placed.castsShadow = placed_.size() % 4 != 2;
    note(placed);
    placed_.push_back(std::move(placed));
  }

  void note(const PlacedModel& placed) {
    const ObjModel& model = models_[placed.model];
    const double size = std::ranges::max(placed.scale);
    constexpr std::array kSkins{Feature::MeshOfColors, Feature::MeshOfImages,
                                Feature::MeshWithTexture};
    features_.insert(kSkins[static_cast<std::size_t>(model.skin)]);
    features_.insert(model.isClosed ? Feature::ClosedMesh : Feature::OpenMesh);
    if (placed.isTwoSided) features_.insert(Feature::TwoSidedMesh);
    if (!placed.castsShadow) features_.insert(Feature::MeshWithoutShadow);
    if (std::ranges::min(placed.scale) < size) features_.insert(Feature::UnevenMesh);
    if (size > kHuge) features_.insert(Feature::HugeMesh);
    if (size < kTiny) features_.insert(Feature::TinyMesh);
    if (!placed.saysHeight) features_.insert(Feature::MeshWithoutHeight);
    if (!placed.namesSector) features_.insert(Feature::MeshWithoutSector);
  }

  Random& random_;
  const Model& model_;
  const std::vector<RandomView>& views_;
  const std::vector<RandomSprite>& sprites_;
  std::set<Feature>& features_;
  ThingPlaces places_;
  const std::vector<ObjModel> models_ = objModels();
  std::vector<PlacedModel> placed_;
};

}  // namespace

std::vector<PlacedModel> placeModels(Random& random, const Model& model,
                                     const std::vector<RandomView>& views,
                                     const std::vector<RandomSprite>& sprites,
                                     std::set<Feature>& features) {
  const std::int64_t count = random.between(1, 4);
  return ModelPlacer(random, model, views, sprites, features).make(static_cast<std::size_t>(count));
}

}  // namespace hearth::random_levels
