#include "light/baking/light_visibility.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>

#include "light/grid/lit_lattice.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr int kPointsPerSample = 32;

/// In radii of the ball. A point nearer to its centre than this sees the ball under too wide an
/// angle for a disc, and uses points spread over the ball.
constexpr double kMinDiscDistance = 1.25;

/// The plane of a wall. Portals count, too: if light passes one, the points spread over the ball
/// show it.
Plane planeOf(const Segment& segment) {
  const Vec2 along = (1 / segment.length) * (segment.p1 - segment.p0);
  return {{segment.p0.x, segment.p0.y, 0}, {turned90(along).x, turned90(along).y, 0}};
}

/// Of a flat at this height, or the slope on it.
Plane planeOf(double zFlat, const std::optional<Slope>& slope, bool isFloor) {
  const Vec2 gradient = slope ? slope->gradient : Vec2{};
  const double z = slope ? slope->zAt({0, 0}) : zFlat;
  const double scale = (isFloor ? 1 : -1) / std::sqrt(1 + dot(gradient, gradient));
  return {{0, 0, z}, scale * Vec3{-gradient.x, -gradient.y, 1}};
}

/// The planes of all walls, flats and slopes of the sector that come into the ball. Skies do not.
std::vector<Plane> planesInside(const Scene& scene, const Sector& sector, Vec3 center,
                                double radius) {
  std::vector<Plane> planes;
  for (const Segment& segment : scene.segmentsOf(sector))
    if (length(nearestOnSegment(segment.p0, segment.p1, center.xy()) - center.xy()) <= radius)
      planes.push_back(planeOf(segment));
  const auto addFlat = [&](const Flat& flat, const Plane& plane) {
    if (!flat.isSky && std::abs(plane.inFront(center)) <= radius) planes.push_back(plane);
  };
  addFlat(sector.floor, planeOf(scene.zFloor(sector), sector.floorSlope, true));
  addFlat(sector.ceiling, planeOf(scene.zCeiling(sector), sector.ceilingSlope, false));
  return planes;
}

/// The i-th point of a sequence that fills the cube [-1, 1)^3 evenly. Its steps are the powers of
/// 1/g, g = 1.2207... being the root of g^4 = g + 1 (M. Roberts, "The Unreasonable Effectiveness of
/// Quasirandom Sequences", 2018).
Vec3 spreadPoint(int i) {
  constexpr std::array kSteps = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  const auto coordinate = [i](double step) {
    const double x = 0.5 + i * step;
    return 2 * (x - std::floor(x)) - 1;
  };
  return {coordinate(kSteps[0]), coordinate(kSteps[1]), coordinate(kSteps[2])};
}

/// The directions from a point in which it would see a ball, as a disc of radius 1. Let D be the
/// distance to the centre of the ball, R its radius, and T = R / sqrt(D^2 - R^2) the tangent of
/// half the angle that the ball fills. The disc's point p lies in the direction `w = forward + T
/// (p.x right + p.y up)`. The line along w is inside the ball from
/// `(D - h) / |w|^2` to `(D + h) / |w|^2` lengths of w, where `h = R sqrt(1 - p^2)`.
class BallDisc {
 public:
  /// Of the ball, what lies in front of all planes shines.
  BallDisc(Vec3 eye, Vec3 center, double radius, const std::vector<Plane>& planes)
      : eye_(eye), planes_(planes), distance_(length(center - eye)), radius_(radius) {
    const Vec3 forward = (1 / distance_) * (center - eye);
    const Vec3 other = std::abs(forward.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 right = cross(forward, other);
    const double tangent = radius / std::sqrt((distance_ - radius) * (distance_ + radius));
    forward_ = forward;
    right_ = (tangent / length(right)) * right;
    up_ = cross(right_, forward);
    tangent2_ = tangent * tangent;
  }

  /// What a line from the eye has inside the ball, in lengths of its w from the eye.
  struct Chord {
    double from;
    double to;  ///< less than `from` where there is nothing

    double middle() const { return (from + to) / 2; }
    /// Proportional to the ball's volume behind a unit of the disc's area: a unit of solid angle
    /// contains |w|^3 (to^3 - from^3) / 3 of it, and a unit of the disc fills T^2 / |w|^3 of solid
    /// angle.
    double volume() const { return to > from ? to * to * to - from * from * from : 0; }
  };

  Chord wholeChord(DiscCells::Distance p) const {
    const double half = radius_ * p.halfChord;
    const double perLength2 = 1 / (1 + tangent2_ * p.square);
    return {(distance_ - half) * perLength2, (distance_ + half) * perLength2};
  }

  /// What shines of a line's chord.
  Chord shiningChord(Vec2 p, Chord chord) const {
    const Vec3 direction = directionTo(p);
    for (const Plane& plane : planes_) {
      const double speed = dot(direction, plane.normal);
      const double crossing = -plane.inFront(eye_) / speed;
      if (speed > 0) chord.from = std::max(chord.from, crossing);
      if (speed < 0) chord.to = std::min(chord.to, crossing);
    }
    return chord;
  }

  Vec3 pointAt(Vec2 p, double t) const { return eye_ + t * directionTo(p); }

 private:
  Vec3 directionTo(Vec2 p) const { return forward_ + p.x * right_ + p.y * up_; }

  Vec3 eye_;
  const std::vector<Plane>& planes_;
  double distance_;
  double radius_;
  Vec3 forward_;  ///< unit vector
  Vec3 right_;    ///< T long, like `up_`
  Vec3 up_;
  double tangent2_;
};

Vec2 onDisc(Vec2 cells, int cellsAcross) { return 2.0 / cellsAcross * cells - Vec2{1, 1}; }

Vec2 nearestOnDisc(Vec2 cells, int cellsAcross) {
  const Vec2 p = onDisc(cells, cellsAcross);
  return (1 / std::max(1.0, length(p))) * p;
}

}  // namespace

DiscCells::DiscCells(int across) {
  if (across == 0) return;
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i <= across; ++i)
      corners.push_back(nearestOnDisc({static_cast<double>(i), static_cast<double>(j)}, across));
  std::vector<Vec2> inside;
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < across; ++i)
      kWholeCell.integral([&](Vec2 inCell) {
        const Vec2 cell{static_cast<double>(i), static_cast<double>(j)};
        inside.push_back(onDisc(cell + inCell, across));
        return 0.0;
      });
  cornerDistances = distancesOf(corners);
  insideDistances = distancesOf(inside);
}

DiscCells::Distance DiscCells::distanceOf(Vec2 point) {
  const double square = dot(point, point);
  return {square, std::sqrt(std::max(0.0, 1 - square))};
}

DiscCells::Distances DiscCells::distancesOf(const std::vector<Vec2>& points) {
  Distances distances;
  for (const Vec2 point : points) distances.all.push_back(distanceOf(point));
  std::ranges::sort(distances.all, {}, &Distance::square);
  const auto isSame = [](Distance a, Distance b) { return a.square == b.square; };
  distances.all.erase(std::unique(distances.all.begin(), distances.all.end(), isSame),
                      distances.all.end());
  for (const Vec2 point : points) {
    const auto found =
        std::ranges::lower_bound(distances.all, dot(point, point), {}, &Distance::square);
    distances.indexOfPoint.push_back(static_cast<std::uint32_t>(found - distances.all.begin()));
  }
  return distances;
}

LightVisibility::LightVisibility(const Scene& scene, const LightSource& light, int softSamples,
                                 bool solidMaskedMiddles)
    : raytracer_(scene, solidMaskedMiddles),
      center_(Raytracer::sourceOf(scene, light)),
      radius_(softSamples == 0 ? 0 : light.radius),
      cells_(static_cast<int>(std::lround(std::sqrt(softSamples)))),
      discCells_(radius_ > 0 ? cells_ : 0) {
  shaftLight_ = {center_.position, radius_, {center_.sector}, false};
  sectors_ = {center_.sector};
  if (radius_ == 0) return;
  SectorSet met;
  planes_ = planesInside(scene, scene[center_.sector], center_.position, radius_);
  isCutByPlanesOnly_ = true;
  for (int i = 0; pointCount_ < kPointsPerSample * softSamples; ++i) {
    const Vec3 p = spreadPoint(i);
    if (dot(p, p) > 1) continue;
    ++pointCount_;
    const Vec3 position = center_.position + radius_ * p;
    const std::optional<SectorId> sector = raytracer_.sectorAt(center_, position, &met);
    if (sector) points_.push_back({position, *sector});
    isCutByPlanesOnly_ &= isInFrontOfPlanes(position) == (sector == center_.sector);
    isCutByPlanesOnly_ &= !sector || sector == center_.sector;
    if (sector && std::ranges::find(shaftLight_.sectors, *sector) == shaftLight_.sectors.end())
      shaftLight_.sectors.push_back(*sector);
  }
  shaftLight_.isCutByWalls = isCutByPlanesOnly_;
  sectors_ = met.sorted();
}

bool LightVisibility::isInFrontOfPlanes(Vec3 p) const {
  return std::ranges::all_of(planes_, [p](const Plane& plane) { return plane.inFront(p) > 0; });
}

double LightVisibility::seenFraction(const LightTarget& target, std::int64_t& rays,
                                     SectorSet* met) const {
  return seenFractionBy(target, [&](const Raytracer::Source& source) {
    ++rays;
    return raytracer_.sees(source, target.point, target.sector, met);
  });
}

double LightVisibility::seenFraction(const LightTarget& target, const Shaft& shaft,
                                     TargetVisibility outcome, std::int64_t& rays) const {
  if (outcome == TargetVisibility::Dark) return 0;
  if (outcome == TargetVisibility::Unknown)
    return seenFractionBy(target, [&](const Raytracer::Source& source) {
      ++rays;
      return raytracer_.sees(source, target.point, target.sector, shaft);
    });
  if (planes_.empty() && pointCount_ == std::ssize(points_) &&
      (radius_ == 0 || target.plane.inFront(center_.position) > radius_ + 2 * kInPlane))
    return 1;
  return seenFractionBy(target, [](const Raytracer::Source&) { return true; });
}

double LightVisibility::seenFractionFromAir(Vec3 point, SectorId sector, std::int64_t& rays) const {
  return seenFractionBy(point, [&](const Raytracer::Source& source) {
    ++rays;
    return raytracer_.reaches(source, point, sector);
  });
}

double LightVisibility::seenFraction(const FacePoint& target, const Shaft& shaft,
                                     TargetVisibility outcome, std::int64_t& rays) const {
  if (outcome == TargetVisibility::Dark) return 0;
  const Plane plane{target.point, target.normal};
  return seenFractionBy(target.point, [&](const Raytracer::Source& source) {
    if (plane.inFront(source.position) <= kInPlane) return false;
    ++rays;
    return raytracer_.sees(source, target, shaft);
  });
}

double LightVisibility::seenFractionFromCorner(Vec3 corner, std::uint32_t mesh, const Shaft& shaft,
                                               TargetVisibility outcome, std::int64_t& rays) const {
  if (outcome == TargetVisibility::Dark) return 0;
  return seenFractionBy(corner, [&](const Raytracer::Source& source) {
    const Vec3 toSource = source.position - corner;
    const double distance = length(toSource);
    if (!(distance > kInPlane)) return false;
    ++rays;
    return raytracer_.sees(source, FacePoint{corner, (1 / distance) * toSource, mesh}, shaft);
  });
}

template <typename Sees>
double LightVisibility::seenFractionBy(const LightTarget& target, Sees&& sees) const {
  // A point light is known to be in front.
  if (radius_ == 0) return sees(center_) ? 1 : 0;
  return seenFractionBy(target.point, [&](const Raytracer::Source& source) {
    return target.plane.inFront(source.position) > kInPlane && sees(source);
  });
}

/// `sees` answers whether the line from a source arrives.
template <typename Sees>
double LightVisibility::seenFractionBy(Vec3 point, Sees&& sees) const {
  if (radius_ == 0) return sees(center_) ? 1 : 0;
  const bool isNear = length(center_.position - point) < kMinDiscDistance * radius_;
  return isNear || !isCutByPlanesOnly_ ? seenOfPoints(sees) : seenOfDisc(point, sees);
}

template <typename Sees>
double LightVisibility::seenOfPoints(Sees&& sees) const {
  return static_cast<double>(std::ranges::count_if(points_, sees)) / pointCount_;
}

template <typename Sees>
double LightVisibility::seenOfDisc(Vec3 point, Sees&& sees) const {
  const BallDisc disc(point, center_.position, radius_, planes_);
  const auto seesAt = [&](Vec2 p, BallDisc::Chord whole) {
    const BallDisc::Chord chord = disc.shiningChord(p, whole);
    return chord.from <= chord.to && sees({disc.pointAt(p, chord.middle()), center_.sector});
  };
  const auto isLit = [&](Vec2 cells) {
    const Vec2 p = nearestOnDisc(cells, cells_);
    return seesAt(p, disc.wholeChord(DiscCells::distanceOf(p)));
  };
  std::vector<BallDisc::Chord> cornerChords;
  cornerChords.reserve(discCells_.cornerDistances.all.size());
  for (const DiscCells::Distance distance : discCells_.cornerDistances.all)
    cornerChords.push_back(disc.wholeChord(distance));
  // The lattice asks for corners, and cells are integrated, in the order in which DiscCells lists
  // them.
  std::size_t corner = 0;
  const LitLattice lattice(cells_, cells_, isLit, [&](int, int) {
    const std::uint32_t distance = discCells_.cornerDistances.indexOfPoint[corner];
    return seesAt(discCells_.corners[corner++], cornerChords[distance]);
  });
  if (lattice.isUniform() && !lattice.isLitAt(0, 0)) return 0;
  if (lattice.isUniform() && planes_.empty()) return 1;
  std::vector<double> volumes;
  volumes.reserve(discCells_.insideDistances.all.size());
  for (const DiscCells::Distance distance : discCells_.insideDistances.all)
    volumes.push_back(disc.wholeChord(distance).volume());
  auto distance = discCells_.insideDistances.indexOfPoint.begin();
  double seen = 0;
  double whole = 0;
  for (int j = 0; j < cells_; ++j)
    for (int i = 0; i < cells_; ++i) {
      const double all = kWholeCell.integral([&](Vec2) { return volumes[*distance++]; });
      whole += all;
      const int litCorners = lattice.litCorners(i, j);
      if (litCorners == 0) continue;
      const bool isAllSeen = litCorners == 4 && planes_.empty();
      const Vec2 cell{static_cast<double>(i), static_cast<double>(j)};
      seen += isAllSeen ? all : lattice.part(i, j).integral([&](Vec2 inCell) {
        const Vec2 p = onDisc(cell + inCell, cells_);
        return disc.shiningChord(p, disc.wholeChord(DiscCells::distanceOf(p))).volume();
      });
    }
  return seen / whole;
}

struct LightVisibility::Beams {
  Beams(const Scene& where, const BeamLimits& which) : scene(where), limits(which) {}

  Scene scene;
  BeamLimits limits;
  std::atomic_flag hasBegun;
  std::once_flag once;
  std::optional<BeamTree> found;
};

LightVisibility::~LightVisibility() = default;
LightVisibility::LightVisibility(LightVisibility&&) noexcept = default;

void LightVisibility::useBeams(const Scene& scene, const BeamLimits& limits) {
  if (radius_ == 0) beams_ = std::make_unique<Beams>(scene, limits);
}

const BeamTree* LightVisibility::beams() const {
  if (!beams_) return nullptr;
  std::call_once(beams_->once, [this] {
    beams_->hasBegun.test_and_set();
    beams_->found.emplace(beams_->scene, center_, beams_->limits);
  });
  return &*beams_->found;
}

void LightVisibility::prefetchBeams() const {
  if (beams_ && !beams_->hasBegun.test_and_set()) beams();
}

GatherAccuracy LightVisibilities::accuracyFor(Purpose purpose, double gatherError) {
  const GatherAccuracy ofSource{.change = 2, .changeOfBounced = 2};
  return (purpose == Purpose::Source ? ofSource : GatherAccuracy{}).times(gatherError);
}

LightVisibilities::LightVisibilities(const Scene& scene, const BakeSettings& settings,
                                     Purpose purpose, IrradianceSource irradiance)
    : LightVisibilities(scene, settings, LightReach(scene.lights(), settings), {}, purpose,
                        std::move(irradiance)) {}

LightVisibilities::LightVisibilities(const Scene& scene, const BakeSettings& settings,
                                     const LightReach& itsReach, std::vector<Box> regions,
                                     Purpose purpose, IrradianceSource irradiance)
    : reach(itsReach),
      scene_(scene),
      settings_(settings),
      regions_(std::move(regions)),
      purpose_(purpose),
      irradiance_(std::move(irradiance)),
      areas_(scene, settings.solidMaskedMiddles, accuracyFor(purpose, settings.gatherError)),
      lights_(reach.lights()) {}

AreaVisibility LightVisibilities::areas() const {
  AreaVisibility areas = areas_;
  if (const Irradiance* irradiance = irradiance_ ? irradiance_() : nullptr)
    areas.setIrradiance(*irradiance);
  return areas;
}

std::vector<SectorId> LightVisibilities::sectorsOf(std::size_t light) const {
  if (!scene_.lights()[light].hasPlace()) return {};
  SectorSet sectors;
  for (const LightVisibility* visibility : {&fine(light), &rough(light)})
    for (const SectorId sector : visibility->sectors()) sectors.add(sector);
  return sectors.sorted();
}

void LightVisibilities::makeReady(std::size_t index) const {
  // Of all lights together; an equal part for each, so that the order in which they are found
  // does not matter.
  constexpr std::size_t kMaxBytesOfBeams = std::size_t{256} << 20;
  Light& light = lights_[index];
  std::call_once(light.once, [&] {
    const LightSource& source = scene_.lights()[index];
    const int roughSamples = (settings_.softSamples + 3) / 4;
    if (source.sun) {
      const auto of = [&](int softSamples) {
        return SunVisibility(scene_, *source.sun, softSamples, settings_.solidMaskedMiddles);
      };
      light.sun.emplace(of(settings_.softSamples));
      light.roughSun.emplace(of(roughSamples));
      return light.isReady.store(true, std::memory_order_release);
    }
    const auto visibility = [&](int softSamples) {
      return std::make_unique<LightVisibility>(scene_, source, softSamples,
                                               settings_.solidMaskedMiddles);
    };
    if (reach.isSoft(index)) light.rough = visibility(roughSamples);
    const std::optional<Box> region =
        regions_.empty() ? std::nullopt : std::optional(regions_[index]);
    auto fine = visibility(settings_.softSamples);
    // Targets may lie outside the light's reach by what authors' files are inexact.
    fine->useBeams(scene_,
                   {reach.metres(index) + kAuthorNoise, kMaxBytesOfBeams / reach.lights(), region});
    light.fine = std::move(fine);
    light.isReady.store(true, std::memory_order_release);
  });
}

}  // namespace hearth
