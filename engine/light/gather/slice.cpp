#include "light/gather/slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "level/locate.h"
#include "level/masked_middle.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth {

namespace {

/// Of a masked middle texture as many parts, from bottom to top, are each a hole or none; but none
/// is narrower than this angle, or those behind one another would divide one another ever more.
constexpr int kPartsOfMiddle = 24;
constexpr double kNarrowestPart = 0.01;  // radians

int partsOf(SlopeRange image) {
  const double angle = hearth::atan(image.to) - hearth::atan(image.from);
  return std::clamp(static_cast<int>(angle / kNarrowestPart), 1, kPartsOfMiddle);
}

FlatPortalSide sideBehind(bool isFloor) {
  return isFloor ? FlatPortalSide::Lower : FlatPortalSide::Upper;
}

/// Cuts off what lies where a linear function is negative; `atA`, `atB` are its values at the ends.
/// False if nothing is left.
bool clip(Vec2& a, Vec2& b, double atA, double atB) {
  if (atA < 0 && atB < 0) return false;
  if (atA < 0)
    a = lerp(a, b, atA / (atA - atB));
  else if (atB < 0)
    b = lerp(a, b, atA / (atA - atB));
  return true;
}

}  // namespace

const std::vector<AreaInSlice>& Slice::areas(const SliceStart& start, Vec2 direction,
                                             SlopeRange slopes, SectorSet* met) {
  start_ = start;
  direction_ = direction;
  met_ = met;
  line_.emplace(start.point.xy(), direction, 1, kPreciseReach);
  areas_.clear();
  branches_.clear();
  if (!slopes.isEmpty()) branches_.push_back({start.sector, 0, 0, nullptr, slopes});
  // No lines through a level that means something are divided so often.
  std::size_t left = 64 * (4 * scene_.level().segments.size() + 16);
  for (; !branches_.empty() && left > 0; --left) {
    const Branch branch = branches_.back();
    branches_.pop_back();
    advance(branch);
  }
  return areas_;
}

/// Of the line from the start to a height `t` metres along the map.
double Slice::slopeTo(double z, double t) const {
  const double rise = z - start_.point.z;
  if (t > 0) return rise / t;
  return rise == 0 ? 0 : std::copysign(kStraightUp, rise);
}

void Slice::seeSky(SlopeRange slopes) {
  if (lights_.sky() && !slopes.isEmpty()) areas_.push_back({slopes, lights_.sky(), std::nullopt});
}

void Slice::see(SlopeRange slopes, SurfaceId surface, TextureId texture, std::uint32_t face) {
  const std::optional<AreaLights::Place> light = lights_.ofTexture(texture);
  if ((light || lights_.bounced()) && !slopes.isEmpty())
    areas_.push_back({slopes, light, surface, face});
}

void Slice::see(SlopeRange slopes, SurfaceId surface) {
  see(slopes, surface, scene_[surface].mapping.texture);
}

void Slice::advance(const Branch& branch) {
  if (met_) met_->add(branch.sector);
  const Exit exit = line_->exitOf(AllWalls{scene_}, branch.sector, branch.tAll, branch.entry);
  if (!exit.segment) return;
  const double fraction = length(line_->at(exit.t) - exit.segment->p0) / exit.segment->length;
  // Not at the start itself, from which no line has a slope.
  const Border border{exit.segment, std::max(exit.t, kNudge),
                      scene_.airAt(*exit.segment, std::clamp(fraction, 0.0, 1.0))};
  meetMeshes(branch, border);
  faces_.forEachFree(branch.slopes, [&](SlopeRange free) { divide(branch, border, free); });
}

/// Which of some lines meet the floor, which the ceiling, and which the wall where they leave.
void Slice::divide(const Branch& branch, const Border& border, SlopeRange slopes) {
  double bottom = slopeTo(border.air.zBottom, border.t);
  double top = slopeTo(border.air.zTop, border.t);
  if (bottom > top) bottom = top = whereAirEnds(branch, border);
  meetFlat(branch, border.t, common(slopes, {-kStraightUp, bottom}), true);
  meetFlat(branch, border.t, common(slopes, {top, kStraightUp}), false);
  meetWall(border, common(slopes, {bottom, top}));
}

/// The slope to where floor and ceiling meet before the border.
double Slice::whereAirEnds(const Branch& branch, const Border& border) const {
  const Sector& sector = scene_[branch.sector];
  const Vec2 p = line_->at(branch.tIn);
  const double before = std::max(0.0, scene_.airTop(sector, p) - scene_.airBottom(sector, p));
  const double beyond = border.air.zBottom - border.air.zTop;
  const double t = std::lerp(branch.tIn, border.t, before / (before + beyond));
  return slopeTo(scene_.airBottom(sector, line_->at(t)), t);
}

void Slice::meetFlat(const Branch& branch, double t, SlopeRange slopes, bool isFloor) {
  if (slopes.isEmpty()) return;
  const Sector& sector = scene_[branch.sector];
  const Flat& flat = isFloor ? sector.floor : sector.ceiling;
  if (flat.isSky) return seeSky(slopes);
  if (flat.flatPortal) return crossFlatPortal(branch, t, slopes, isFloor);
  see(slopes, *(isFloor ? sector.floorSurface : sector.ceilingSurface));
}

/// Lines cross its plane the nearer the steeper they are. `tEnd` is where they leave the sector.
void Slice::crossFlatPortal(const Branch& branch, double tEnd, SlopeRange slopes, bool isFloor) {
  const Sector& sector = scene_[branch.sector];
  const FlatPortal& flatPortal = scene_[*(isFloor ? sector.floor : sector.ceiling).flatPortal];
  const double z = isFloor ? scene_.zFloor(sector) : scene_.zCeiling(sector);
  const double farthest = std::max(branch.tIn, tEnd);
  const auto crossing = [&](double slope) {
    if (slope == 0) return farthest;
    return std::clamp((z - start_.point.z) / slope, branch.tIn, farthest);
  };
  const double steepest = isFloor ? slopes.from : slopes.to;
  const double gentlest = isFloor ? slopes.to : slopes.from;
  findCrossings(flatPortal.members(sideBehind(isFloor)), crossing(steepest), crossing(gentlest));
  for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
    const double from = crossings_[i];
    const double to = crossings_[i + 1];
    // The ends of all keep all slopes, whatever rounding says.
    const double steep = i == 0 ? steepest : slopeTo(z, from);
    const double gentle = i + 2 == crossings_.size() ? gentlest : slopeTo(z, to);
    const SlopeRange these =
        common(slopes, isFloor ? SlopeRange{steep, gentle} : SlopeRange{gentle, steep});
    if (these.isEmpty()) continue;
    const double middle = (from + to) / 2;
    branches_.push_back({memberAt(flatPortal, isFloor, middle), from, middle, nullptr, these});
  }
}

/// Where the outlines of some sectors are crossed between two ends, and the ends, in rising order.
void Slice::findCrossings(std::span<const SectorId> members, double from, double to) {
  crossings_.assign({from, std::max(from, to)});
  for (const SectorId member : members)
    for (const Segment& segment : scene_.segmentsOf(scene_[member])) {
      if ((line_->sideOf(segment.p0) >= 0) == (line_->sideOf(segment.p1) >= 0)) continue;
      const double t = line_->crossingOf(segment);
      if (t > from && t < to) crossings_.push_back(t);
    }
  std::ranges::sort(crossings_);
}

SectorId Slice::memberAt(const FlatPortal& flatPortal, bool isFloor, double t) const {
  const FlatPortalSide side = sideBehind(isFloor);
  for (const SectorId member : flatPortal.members(side))
    if (line_->isInside(scene_.segmentsOf(scene_[member]), t)) return member;
  return sectorAcross(scene_.level(), flatPortal, side, line_->at(t));
}

void Slice::meetWall(const Border& border, SlopeRange slopes) {
  if (slopes.isEmpty()) return;
  if (lights_.needSurfaces()) seePieces(border, slopes);
  for (const LightOpening& opening : scene_.lightOpeningsOf(*border.segment)) {
    const SlopeRange open = common(slopes, slopesThrough(opening, border));
    if (!open.isEmpty()) passMiddles(opening, border, open);
  }
}

/// What is opaque of a wall.
void Slice::seePieces(const Border& border, SlopeRange slopes) {
  for (const auto& [zBottom, zTop, content] : scene_.piecesOf(*border.segment)) {
    const SlopeRange piece = common(slopes, {slopeTo(zBottom, border.t), slopeTo(zTop, border.t)});
    if (const Opening* opening = std::get_if<Opening>(&content)) {
      seeSidewalls(*opening, border, piece);
      continue;
    }
    const SurfaceId surface = std::get<SurfaceId>(content);
    if (!isSky(scene_[surface].kind)) see(piece, surface);
  }
}

/// Where the next sector's slopes stand in an opening; that of its floor is in front.
void Slice::seeSidewalls(const Opening& opening, const Border& border, SlopeRange slopes) {
  const Sector& next = scene_[opening.next];
  const Vec2 p = line_->at(border.t);
  double bottom = -kStraightUp;
  if (opening.floorSidewall) {
    bottom = slopeTo(scene_.airBottom(next, p), border.t);
    see(common(slopes, {-kStraightUp, bottom}), *opening.floorSidewall);
  }
  if (opening.ceilingSidewall)
    see(common(slopes, {std::max(bottom, slopeTo(scene_.airTop(next, p), border.t)), kStraightUp}),
        *opening.ceilingSidewall);
}

/// Of lines that come through the opening into the air behind it, or a sky.
SlopeRange Slice::slopesThrough(const LightOpening& opening, const Border& border) const {
  SlopeRange open{slopeTo(opening.zBottom, border.t), slopeTo(opening.zTop, border.t)};
  const Sector& next = scene_[opening.next];
  if (!next.floorSlope && !next.ceilingSlope) return open;
  const Segment& twin = scene_[opening.twin];
  const double fraction = length(line_->at(border.t) - twin.p0) / twin.length;
  const AirColumn air = scene_.airAt(twin, std::clamp(fraction, 0.0, 1.0));
  if (next.floorSlope) open.from = std::max(open.from, slopeTo(air.zBottom, border.t));
  if (next.ceilingSlope) open.to = std::min(open.to, slopeTo(air.zTop, border.t));
  return open;
}

/// It reflects, but does not shine.
void Slice::seeMiddle(SlopeRange slopes, SurfaceId surface) {
  if (lights_.bounced() && !slopes.isEmpty()) areas_.push_back({slopes, std::nullopt, surface});
}

/// Enters what the middle textures in an opening leave free.
void Slice::passMiddles(const LightOpening& opening, const Border& border, SlopeRange slopes) {
  middles_.clear();
  const Vec2 p = line_->at(border.t);
  for (const SurfaceId id : scene_.maskedMiddlesIn(opening)) {
    const SurfaceGeometry& middle = scene_.geometryOf(id);
    const SlopeRange image =
        common(slopes, {slopeTo(middle.zBottom, border.t), slopeTo(middle.zTop, border.t)});
    if (image.isEmpty()) continue;
    const int parts = partsOf(image);
    const auto slopeAt = [&](double part) { return std::lerp(image.from, image.to, part / parts); };
    const auto isSolid = [&](int part) {
      const double z = start_.point.z + border.t * slopeAt(part + 0.5);
      return solidMaskedMiddles_ || isSolidAt(scene_, id, {p.x, p.y, z});
    };
    const bool isFront = scene_[id].segment == border.segment->id;
    for (int part = 0; part < parts; ++part) {
      if (!isSolid(part)) continue;
      const SlopeRange solid{slopeAt(part), slopeAt(part + 1)};
      middles_.add(solid);
      if (isFront) seeMiddle(common(slopes, solid), id);
    }
  }
  middles_.forEachFree(slopes, [&](SlopeRange free) { enter(opening, border.t, free); });
}

void Slice::enter(const LightOpening& opening, double t, SlopeRange slopes) {
  const Sector& next = scene_[opening.next];
  const Vec2 p = line_->at(t);
  const auto endInSky = [&](SlopeRange beyond) { seeSky(common(beyond, slopes)); };
  SlopeRange rest = slopes;
  if (next.floor.isSky) {
    const double bottom = slopeTo(scene_.airBottom(next, p), t);
    endInSky({-kStraightUp, bottom});
    rest.from = std::max(rest.from, bottom);
  }
  if (next.ceiling.isSky) {
    const double top = slopeTo(scene_.airTop(next, p), t);
    endInSky({top, kStraightUp});
    rest.to = std::min(rest.to, top);
  }
  if (!rest.isEmpty()) branches_.push_back({opening.next, t, t, &scene_[opening.twin], rest});
}

/// Those in the sector, before lines leave it.
void Slice::meetMeshes(const Branch& branch, const Border& border) {
  faces_.clear();
  const Level& level = scene_.level();
  const auto mayMeet = [&](const Box3& box) { return mayBlock(box, branch, border); };
  for (const MeshInSector& at : level.meshesIn(branch.sector)) {
    const Mesh& mesh = level.meshes[at.mesh];
    if (!mesh.castsShadow || !mayMeet(level.faceTrees[at.mesh].box())) continue;
    const std::span<const MeshFace> faces = level.facesOf(mesh);
    level.faceTrees[at.mesh].anyFace(mayMeet, [&](std::uint32_t face) {
      const std::optional<InPlane> whole = cutOf(faces[face]);
      const std::optional<InPlane> cut = whole ? inAir(*whole, branch, border) : std::nullopt;
      if (cut) block(*cut, branch, mesh, faces[face]);
      return false;
    });
  }
  if (lights_.needFaces())
    faces_.forEachSeen([&](SlopeRange slopes, const FaceCut& cut) {
      seeFace(common(slopes, branch.slopes), cut);
    });
}

/// If its front is seen.
void Slice::seeFace(SlopeRange slopes, const FaceCut& cut) {
  const MeshFace& face = scene_.level().meshFaces[cut.face];
  if (scene_.level().meshOf(cut.mesh).isTwoSided ||
      dot(frontOf(face), start_.point - face.corners[0]) > 0)
    see(slopes, cut.mesh, face.texture, cut.face);
}

/// Whether what is in a box may stop lines that nothing has stopped so far.
bool Slice::mayBlock(const Box3& box, const Branch& branch, const Border& border) const {
  const Vec2 half = 0.5 * (box.max.xy() - box.min.xy());
  const Vec2 middle = 0.5 * (box.min.xy() + box.max.xy()) - start_.point.xy();
  const double beside = std::abs(direction_.y) * half.x + std::abs(direction_.x) * half.y;
  if (std::abs(cross(direction_, middle)) > beside + kPositionSlack) return false;
  const double reach = std::abs(direction_.x) * half.x + std::abs(direction_.y) * half.y;
  const double along = dot(direction_, middle);
  const double first = std::max({along - reach, branch.tIn, start_.slack}) - kPositionSlack;
  const double last = std::min(along + reach, border.t) + kPositionSlack;
  if (first > last) return false;
  if (first <= start_.slack) return true;
  const double low = box.min.z - kPositionSlack - start_.point.z;
  const double high = box.max.z + kPositionSlack - start_.point.z;
  const SlopeRange slopes =
      common({low / (low < 0 ? first : last), high / (high > 0 ? first : last)}, branch.slopes);
  return !slopes.isEmpty() && !faces_.hide(slopes, 1 / first);
}

/// The part of a face in the slice's plane.
std::optional<Slice::InPlane> Slice::cutOf(const MeshFace& face) const {
  const std::array<double, 3> sides{line_->sideOf(face.corners[0].xy()),
                                    line_->sideOf(face.corners[1].xy()),
                                    line_->sideOf(face.corners[2].xy())};
  const std::array<bool, 3> isRight{sides[0] >= 0, sides[1] >= 0, sides[2] >= 0};
  if (isRight[0] == isRight[1] && isRight[1] == isRight[2]) return std::nullopt;
  std::array<Vec2, 2> ends{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (isRight[k] == isRight[next]) continue;
    // In one order, so that faces on either side of an edge leave no gap.
    const std::size_t p = isRight[k] ? k : next;
    const std::size_t q = isRight[k] ? next : k;
    const Vec3 at = face.corners[p] +
                    (sides[p] / (sides[p] - sides[q])) * (face.corners[q] - face.corners[p]) -
                    start_.point;
    ends[count++] = {dot(at.xy(), direction_), at.z};
  }
  return InPlane{ends[0], ends[1]};
}

/// Its part in the sector's air, up to kPositionSlack beyond the outline: a face in the plane of an
/// opening stops lines on either side. A start may lie in the plane of a flat, where so much would
/// be steep.
std::optional<Slice::InPlane> Slice::inAir(InPlane cut, const Branch& branch,
                                           const Border& border) const {
  auto& [a, b] = cut;
  const double tFirst = std::max(branch.tIn - kPositionSlack, start_.slack);
  const double tLast = border.t + kPositionSlack;
  if (!clip(a, b, a.x - tFirst, b.x - tFirst) || !clip(a, b, tLast - a.x, tLast - b.x))
    return std::nullopt;
  const Sector& sector = scene_[branch.sector];
  const auto overFloor = [&](Vec2 p) {
    return start_.point.z + p.y - scene_.airBottom(sector, line_->at(p.x)) + kHeightNoise;
  };
  const auto underCeiling = [&](Vec2 p) {
    return scene_.airTop(sector, line_->at(p.x)) - start_.point.z - p.y + kHeightNoise;
  };
  if (!clip(a, b, overFloor(a), overFloor(b)) || !clip(a, b, underCeiling(a), underCeiling(b)))
    return std::nullopt;
  return cut;
}

/// Takes a part of a face out of the branch.
void Slice::block(InPlane cut, const Branch& branch, const Mesh& mesh, const MeshFace& face) {
  auto& [a, b] = cut;
  if (a.y / a.x > b.y / b.x) std::swap(a, b);
  const SlopeRange slopes{a.y / a.x, b.y / b.x};
  if (!common(slopes, branch.slopes).isEmpty())
    faces_.add({slopes, 1 / a.x, 1 / b.x, mesh.surface, scene_.level().indexOf(face)});
}

}  // namespace hearth
