#include "viewer/inspect/inspect.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "level/locate.h"
#include "light/gather/area_visibility.h"
#include "math/tolerance.h"
#include "truth/truth_light.h"
#include "truth/truth_meshes.h"
#include "viewer/inspect/hemisphere_sample.h"

namespace hearth {

namespace {

/// Of light, for one place: as many as are followed within some tens of milliseconds.
constexpr int kMaxRays = 10'000;

/// How far up and down a light is tried: in steps of so many metres.
constexpr double kLiftStep = 0.1;
constexpr int kLifts = 30;

/// Of a ball: to its points, and from there.
int raysOf(const LightSource& light) {
  const bool isSoft = light.sun ? light.sun->size() > 0 : light.radius > 0;
  return isSoft ? 2 * kInspectedBallPoints : 1;
}

/// Metres by which a height is off a range; 0 in it.
double missedBy(double z, double zBottom, double zTop) {
  return std::max({zBottom - z, z - zTop, 0.0});
}

/// The surface of that kind which the piece has, if any.
std::optional<SurfaceId> surfaceIn(const Scene& scene, const WallPiece& piece, SurfaceKind kind) {
  if (const SurfaceId* surface = std::get_if<SurfaceId>(&piece.content))
    return scene[*surface].kind == kind ? std::optional(*surface) : std::nullopt;
  const Opening& opening = std::get<Opening>(piece.content);
  if (kind == SurfaceKind::FloorSidewall) return opening.floorSidewall;
  if (kind == SurfaceKind::CeilingSidewall) return opening.ceilingSidewall;
  return kind == SurfaceKind::MaskedMiddle ? opening.maskedMiddle : std::nullopt;
}

/// The surface that a ray has hit. Of several of a kind, one above the other, it is the one nearest
/// to the height of the hit, which rounding may put beside it.
std::optional<SurfaceId> surfaceOf(const Scene& scene, const TruthHit& hit) {
  const Sector& sector = scene[hit.sector];
  if (!hit.segment) return facesDown(hit.kind) ? sector.ceilingSurface : sector.floorSurface;
  std::optional<SurfaceId> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const WallPiece& piece : scene.piecesOf(scene[*hit.segment])) {
    const auto surface = surfaceIn(scene, piece, hit.kind);
    const double miss = missedBy(hit.point.z, piece.zBottom, piece.zTop);
    if (!surface || miss >= least) continue;
    nearest = surface;
    least = miss;
  }
  return nearest;
}

std::optional<LightmapFinding> lightmapAt(const Scene& scene, const BakedLight& light,
                                          const TruthHit& hit) {
  const auto id = surfaceOf(scene, hit);
  if (!id || !light.surfaces[id->index()]) return std::nullopt;
  const LitSurface& surface = *light.surfaces[id->index()];
  const TexelRect& rect = surface.texels;
  const Vec2 texel = surface.grid.toTexels(hit.point);
  const auto within = [](double at, int first, int count) {
    return std::clamp(static_cast<int>(std::floor(at)) - first, 0, count - 1);
  };
  LightmapFinding found{within(texel.x, rect.i0, rect.width),
                        within(texel.y, rect.j0, rect.height),
                        rect.width,
                        rect.height,
                        surface.grid.texel,
                        {},
                        {}};
  const std::optional<Lightmap>& map = light.lightmaps[id->index()];
  if (!map) return found;
  const auto levels = [](const auto& of) { return Vec3{of(0), of(1), of(2)}; };
  found.texel = levels([&](int channel) -> double {
    return map->at(rect.i0 + found.column, rect.j0 + found.row, channel);
  });
  found.shown = levels([&](int channel) { return map->sample(texel.x, texel.y, channel); });
  return found;
}

/// The lights of a level, as one place of a surface has them.
class Follower {
 public:
  Follower(const Scene& scene, const BakeSettings& settings, const SurfacePoint& place)
      : scene_(scene),
        settings_(settings),
        place_(place),
        meshes_(scene.level()),
        hemisphere_(scene, meshes_, place),
        areas_(scene, settings.solidMaskedMiddles) {}

  /// What is known of a light without following it.
  LightFinding glance(std::size_t index) const {
    const LightSource& light = scene_.level().lights[index];
    const double distance = light.hasPlace() ? length(light.position - place_.point)
                                             : std::numeric_limits<double>::infinity();
    return {
        index, LightReason::NotReached, distance, light.brightnessAt(place_.point),
        light.isArea() ? light.intensity : TruthSource::unshaded(light, place_, settings_.lambert)};
  }

  /// Returns how many rays that took, at most.
  int follow(LightFinding& finding) {
    const LightSource& light = scene_.level().lights[finding.light];
    if (light.isArea()) return followArea(light, finding);
    followToPlace(finding);
    finding.comesNear = finding.seenFraction > 0 && finding.level > 0;
    if (finding.comesNear || finding.level * light.greatestFactor() < kVisibleLevel)
      return raysOf(light);
    finding.comesNear = hemisphere_.isLitBy(light);
    if (light.sun || !finding.comesNear || finding.reason != LightReason::Blocked)
      return raysOf(light) + kHemisphereRays;
    finding.lift = liftToSee(light);
    return raysOf(light) + kHemisphereRays + 2 * kLifts;
  }

 private:
  /// Returns how many slices that took: those of the first area serve all.
  int followArea(const LightSource& light, LightFinding& finding) {
    finding.reason = LightReason::TooWeak;
    if (light.reach(settings_.cutOff) == 0) return 0;
    std::int64_t slices = 0;
    if (fractions_.empty()) slices = findAreas();
    finding.seenFraction = fractions_[areas_.placeOf(finding.light)];
    finding.adds = finding.seenFraction * light.intensity *
                   Vec3{light.colorFactor(0), light.colorFactor(1), light.colorFactor(2)};
    finding.comesNear = finding.seenFraction > 0;
    finding.reason = finding.seenFraction > 0 ? LightReason::Lights : LightReason::NoneSeen;
    return static_cast<int>(slices);
  }

  /// Returns how many slices that took.
  std::int64_t findAreas() {
    fractions_.resize(areas_.lights().size());
    std::int64_t slices = 0;
    const SurfacePoint place = litSideOf(scene_.level(), place_);
    if (place.mesh)
      areas_.findOnMesh(place.point, place.sector, {&place.normal, 1}, fractions_, slices);
    else
      areas_.findOnSurface(place.point, place.sector, place.normal, fractions_, slices);
    return slices;
  }

  /// The least that is enough, of some.
  std::optional<double> liftToSee(const LightSource& light) const {
    for (int i = 1; i <= kLifts; ++i)
      for (const double lift : {i * kLiftStep, -i * kLiftStep})
        if (seesIfLifted(light, lift)) return lift;
    return std::nullopt;
  }

  bool seesIfLifted(const LightSource& light, double lift) const {
    LightSource lifted = light;
    lifted.radius = 0;
    lifted.position.z += lift;
    return contains(scene_, scene_[light.sector], lifted.position, 0) &&
           TruthSource(scene_.level(), meshes_, lifted, 1).seenFraction(place_) > 0;
  }

  /// Why no part of a light shines on the plane of the place, if so.
  std::optional<LightReason> behindPlane(const LightSource& light, double inFront) const {
    const double inPlane = light.sun ? kInPlaneSine : kInPlane;
    const double radius = light.sun ? light.sun->sinRadius() : light.radius;
    const bool isCut = light.sun && radius > 0;  // a disc, half of which is in front
    if (std::abs(inFront) <= inPlane && !isCut) return LightReason::InPlane;
    if (inFront + radius <= inPlane) return LightReason::FacesAway;
    return std::nullopt;
  }

  void followToPlace(LightFinding& finding) const {
    const LightSource& light = scene_.level().lights[finding.light];
    const double inFront =
        dot(place_.normal, light.sun ? light.sun->direction() : light.position - place_.point);
    if (const auto reason = behindPlane(light, inFront)) {
      finding.reason = *reason;
      return;
    }
    if (light.sun)
      followTo(light, TruthSun(scene_.level(), meshes_, *light.sun, kInspectedBallPoints), inFront,
               finding);
    else
      followTo(light, TruthSource(scene_.level(), meshes_, light, kInspectedBallPoints), inFront,
               finding);
  }

  template <typename Source>
  void followTo(const LightSource& light, const Source& source, double inFront,
                LightFinding& finding) const {
    finding.seenFraction = source.seenFraction(place_);
    finding.reason = LightReason::FacesAway;
    // Of a middle behind the plane the cosine leaves nothing.
    if (inFront < 0 && (finding.seenFraction == 0 || settings_.lambert)) return;
    const double reach = light.reach(settings_.cutOff);
    const bool isCutOff = light.sun ? reach == 0 : !(finding.distance < reach);
    const double level = isCutOff ? 0 : finding.unshaded * finding.seenFraction;
    finding.adds = level * Vec3{light.colorFactor(0), light.colorFactor(1), light.colorFactor(2)};
    finding.reason = LightReason::OutsideSpot;
    if (light.spot && finding.level == 0 && light.brightnessAt(finding.distance) > 0) return;
    finding.reason = LightReason::TooWeak;
    if (isCutOff || finding.unshaded * light.greatestFactor() < kVisibleLevel) return;
    finding.reason = LightReason::Lights;
    if (finding.seenFraction > 0) return;
    finding.blocker = source.firstMet(place_);
    const bool isBefore =
        finding.blocker && (light.sun || (finding.blocker->t - 1) * finding.distance < kArrival);
    finding.reason = isBefore ? LightReason::Blocked : LightReason::NotReached;
    if (!isBefore) finding.blocker.reset();
  }

  Scene scene_;
  const BakeSettings& settings_;
  const SurfacePoint& place_;
  TruthMeshes meshes_;
  HemisphereSample hemisphere_;
  AreaVisibility areas_;
  std::vector<double> fractions_;  ///< of areas, by their places; empty before they are found
};

double total(Vec3 levels) { return levels.x + levels.y + levels.z; }

void findLights(const Scene& scene, const BakeSettings& settings, Inspection& found) {
  Follower follower(scene, settings, found.place);
  for (std::size_t i = 0; i < scene.level().lights.size(); ++i)
    found.lights.push_back(follower.glance(i));
  std::ranges::stable_sort(found.lights, std::greater{}, &LightFinding::level);
  std::size_t followed = 0;
  for (int rays = 0; followed < found.lights.size() && rays < kMaxRays; ++followed) {
    LightFinding& finding = found.lights[followed];
    rays += follower.follow(finding);
    found.sum = found.sum + finding.adds;
  }
  found.notFollowed = found.lights.size() - followed;
  found.lights.erase(found.lights.begin() + static_cast<std::ptrdiff_t>(followed),
                     found.lights.end());
  std::ranges::stable_sort(found.lights, std::greater{}, [](const LightFinding& finding) {
    return std::pair(total(finding.adds), finding.comesNear);
  });
}

/// The lightmap is clamped, and where a shadow ends it is even over a texel.
Vec3 bouncedIn(const LightmapFinding& map, Vec3 ofLights) {
  const Vec3 beyond = map.shown - ofLights;
  return {std::max(0.0, beyond.x), std::max(0.0, beyond.y), std::max(0.0, beyond.z)};
}

}  // namespace

Inspection inspect(const Scene& scene, const BakedLight& light, const BakeSettings& settings,
                   const TruthHit& place) {
  Inspection found{place, std::nullopt, {}, 0, {}, {}};
  if (isSky(place.kind)) return found;
  found.lightmap = lightmapAt(scene, light, place);
  findLights(scene, settings, found);
  if (settings.bounces > 0 && found.lightmap) found.bounced = bouncedIn(*found.lightmap, found.sum);
  return found;
}

}  // namespace hearth
