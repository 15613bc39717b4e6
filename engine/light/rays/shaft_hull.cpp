#include "light/rays/shaft_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "light/ray_error.h"

namespace hearth {

namespace {

/// The lines that touch a disc round the origin and one of several points, and have all of these on
/// one side, by their unit normals away from them. None where the disc holds all points.
struct Tangents {
  std::optional<Vec2> left;
  std::optional<Vec2> right;

  template <std::size_t N>
  Tangents(const std::array<Vec2, N>& points, std::size_t count, double radius) {
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 p = points[i];
      const double length2 = dot(p, p);
      if (length2 <= radius * radius) continue;
      const double touch = std::sqrt(length2 - radius * radius);
      const auto normal = [&](double side) {
        return (1 / length2) * (radius * p + side * touch * turned90(p));
      };
      if (!left || dot(*left, p) > radius) left = normal(1);
      if (!right || dot(*right, p) > radius) right = normal(-1);
    }
  }
};

}  // namespace

TargetBox TargetBox::around(const Box3& box) {
  TargetBox around;
  around.normal = {0, 0, 1};
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y})
      for (const double z : {box.min.z, box.max.z}) around.storage[around.count++] = {x, y, z};
  return around;
}

ShaftHull::ShaftHull(Vec3 center, double radius, const TargetBox& targets)
    : center_(center), radius_(radius), count_(targets.count) {
  double size = largestCoordinate(center);
  Vec2 axis;
  double low = -radius;
  double high = radius;
  for (std::size_t i = 0; i < count_; ++i) {
    const Vec3 p = targets.storage[i] - center;
    targets_[i] = p;
    reach_ = std::max(reach_, dot(p, p));
    axis = axis + p.xy();
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  reach_ = std::sqrt(reach_) + radius;
  size += reach_;
  noise_ = roundingOf(size);
  margin_ = rayMargin(noise_);
  lows_.add({{}, low - margin_});
  highs_.add({{}, high + margin_});

  const double axisLength = length(axis);
  axis = axisLength > 0 ? (1 / axisLength) * axis : Vec2{1, 0};
  addAround(axis);
  const bool isWall = std::abs(targets.normal.z) < 0.5;
  addPlane(Vec3{} - targets.normal);
  const Vec2 along = turned90(targets.normal.xy());
  addAboveAndBelow(isWall ? (1 / length(along)) * along : turned90(axis));
}

/// All relative to one of the targets, as if that were a point light that shines on the others, for
/// a half-space that the rays do not leave contains them if it contains the targets.
ShaftHull::ShaftHull(const SunCone& sun, const TargetBox& targets)
    : center_(targets.storage[0]), radius_(0), count_(targets.count), reach_(sun.reach) {
  double low = 0;
  double high = 0;
  double size = largestCoordinate(center_) + reach_;
  for (std::size_t i = 0; i < count_; ++i) {
    targets_[i] = targets.storage[i] - center_;
    size = std::max(size, largestCoordinate(targets.storage[i]) + reach_);
    low = std::min(low, targets_[i].z);
    high = std::max(high, targets_[i].z);
  }
  noise_ = roundingOf(size);
  margin_ = rayMargin(noise_);
  lows_.add({{}, low - (sun.goesUp() ? 0 : reach_) - margin_});
  highs_.add({{}, high + reach_ + margin_});
  if (dot(targets.normal, sun.direction) >= sun.sinRadius) addPlane(Vec3{} - targets.normal);
  if (sun.isUpright())
    addAroundZenith(sun, low);
  else
    addAroundSun(sun);
}

/// Upright planes along the axes, where the zenith is in the sun's disc or nearly so. At the height
/// of the highest air rays are no farther beside their start than the lowest of them.
void ShaftHull::addAroundZenith(const SunCone& sun, double lowestTarget) {
  const double onMap = length(sun.direction.xy());
  const double sine = sun.direction.z * sun.cosRadius - onMap * sun.sinRadius;
  const double cosine = onMap * sun.cosRadius + sun.direction.z * sun.sinRadius;
  const double height = std::max(0.0, sun.zHighest - center_.z - lowestTarget);
  const double beside = sine > 0 ? std::min(reach_, height * cosine / sine) : reach_;
  for (const Vec2 normal : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}})
    sides_.add({normal, farthest({normal.x, normal.y, 0}) + beside + margin_});
}

/// The cone of directions lies in a wedge of the map, and between two sloped planes.
void ShaftHull::addAroundSun(const SunCone& sun) {
  const double onMap = length(sun.direction.xy());
  const Vec2 axis = (1 / onMap) * sun.direction.xy();
  const double sine = sun.sinRadius / onMap;  // of half the wedge's angle
  const double cosine = std::sqrt(1 - sine * sine);
  const Vec2 back = -sine * axis;
  for (const Vec2 normal :
       {cosine * turned90(axis) + back, -cosine * turned90(axis) + back, Vec2{} - axis})
    addPlane({normal.x, normal.y, 0});
  const auto addTilted = [&](double sinElevation, double cosElevation, double side) {
    const Vec2 tilted = -side * sinElevation * axis;
    addPlane({tilted.x, tilted.y, side * cosElevation});
  };
  const auto [z, s, c] = std::array{sun.direction.z, sun.sinRadius, sun.cosRadius};
  addTilted(z * c + onMap * s, onMap * c - z * s, 1);   // of the highest rays
  addTilted(z * c - onMap * s, onMap * c + z * s, -1);  // of the lowest
}

void ShaftHull::addAround(Vec2 axis) {
  std::array<Vec2, 8> onMap;
  for (std::size_t i = 0; i < count_; ++i) onMap[i] = targets_[i].xy();
  const Tangents sides(onMap, count_, radius_);
  const Vec2 left = sides.left.value_or(turned90(axis));
  const Vec2 right = sides.right.value_or(Vec2{} - turned90(axis));
  for (const Vec2 normal : {left, right, axis, Vec2{} - axis}) addPlane({normal.x, normal.y, 0});
}

/// Planes that hold a direction of the map.
void ShaftHull::addAboveAndBelow(Vec2 along) {
  const Vec2 across = turned90(along);
  std::array<Vec2, 8> upright;
  for (std::size_t i = 0; i < count_; ++i)
    upright[i] = {dot(targets_[i].xy(), across), targets_[i].z};
  const Tangents tangents(upright, count_, radius_);
  for (const auto& normal : {tangents.left, tangents.right})
    if (normal) addPlane({normal->x * across.x, normal->x * across.y, normal->y});
}

double ShaftHull::farthest(Vec3 normal) const {
  double most = radius_;
  for (const Vec3& p : targets()) most = std::max(most, dot(normal, p));
  return most;
}

void ShaftHull::addPlane(Vec3 normal) {
  const double most = farthest(normal) + margin_;
  if (normal.z == 0) return sides_.add({normal.xy(), most});
  if (std::abs(normal.z) < kSteepest) return;
  const SlopedPlane plane{(-1 / normal.z) * normal.xy(), most / normal.z};
  if (normal.z > 0)
    highs_.add(plane);
  else
    lows_.add(plane);
}

std::optional<ShaftHull::Slice> ShaftHull::slice(Vec2 p0, Vec2 p1) const {
  const Vec2 a = p0 - center_.xy();
  const Vec2 b = p1 - center_.xy();
  double from = 0;
  double to = 1;
  for (const HalfPlane& side : sides_.all()) {
    const double outside0 = dot(side.normal, a) - side.most;
    const double outside1 = dot(side.normal, b) - side.most;
    if (outside0 > 0 && outside1 > 0) return std::nullopt;
    if (outside0 > 0) from = std::max(from, outside0 / (outside0 - outside1));
    if (outside1 > 0) to = std::min(to, outside0 / (outside0 - outside1));
  }
  if (from > to) return std::nullopt;
  Slice slice;
  slice.from = from;
  slice.to = to;
  const Vec2 start = lerp(a, b, from);
  const Vec2 end = lerp(a, b, to);
  for (const SlopedPlane& high : highs_.all())
    slice.tops_[slice.topCount_++] = {center_.z + high.at(start), center_.z + high.at(end)};
  for (const SlopedPlane& low : lows_.all())
    slice.bottoms_[slice.bottomCount_++] = {center_.z + low.at(start), center_.z + low.at(end)};
  return slice;
}

ShaftHull::Outline ShaftHull::outlineIn(const Box& box) const {
  const Vec2 center = center_.xy();
  Outline outline;
  for (const Vec2 corner :
       {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}})
    outline.add(corner - center);
  for (const HalfPlane& side : sides_.all()) outline = clipped(outline, side);
  for (Vec2& corner : std::span(outline.items).first(outline.count)) corner = corner + center;
  return outline;
}

/// I. Sutherland, G. Hodgman, "Reentrant Polygon Clipping", 1974.
ShaftHull::Outline ShaftHull::clipped(const Outline& outline, const HalfPlane& side) {
  Outline clipped;
  for (std::size_t i = 0, before = outline.count - 1; i < outline.count; before = i++) {
    // Only rounding can make so many corners.
    if (clipped.count + 2 > clipped.items.size()) return outline;
    const double outside0 = dot(side.normal, outline[before]) - side.most;
    const double outside1 = dot(side.normal, outline[i]) - side.most;
    if ((outside0 <= 0) != (outside1 <= 0))
      clipped.add(lerp(outline[before], outline[i], outside0 / (outside0 - outside1)));
    if (outside1 <= 0) clipped.add(outline[i]);
  }
  return clipped;
}

bool ShaftHull::Slice::isBelow(EndHeights line) const {
  return std::any_of(tops_.begin(), tops_.begin() + topCount_,
                     [&](EndHeights top) { return top.from < line.from && top.to < line.to; });
}

bool ShaftHull::Slice::isAbove(EndHeights line) const {
  return std::any_of(bottoms_.begin(), bottoms_.begin() + bottomCount_, [&](EndHeights bottom) {
    return bottom.from > line.from && bottom.to > line.to;
  });
}

bool ShaftHull::mayMeet(const Level& level, std::uint32_t mesh) const {
  return level.meshes[mesh].castsShadow &&
         level.faceTrees[mesh].anyFace([&](const Box3& box) { return !isClearOf(box); },
                                       [](std::uint32_t) { return true; });
}

/// Whether `isBeyond(normal, most)` holds for a bounding plane: the body has only points p with
/// dot(normal, p) <= most.
template <typename IsBeyond>
bool ShaftHull::anyPlane(IsBeyond&& isBeyond) const {
  const auto isBeyondSide = [&](const HalfPlane& side) {
    return isBeyond(Vec3{side.normal.x, side.normal.y, 0}, side.most);
  };
  const auto isAbove = [&](const SlopedPlane& high) {
    return isBeyond(Vec3{-high.gradient.x, -high.gradient.y, 1}, high.atCenter);
  };
  const auto isBelow = [&](const SlopedPlane& low) {
    return isBeyond(Vec3{low.gradient.x, low.gradient.y, -1}, -low.atCenter);
  };
  return std::ranges::any_of(sides_.all(), isBeyondSide) ||
         std::ranges::any_of(highs_.all(), isAbove) || std::ranges::any_of(lows_.all(), isBelow);
}

/// Whether it is certain that it has nothing of a box.
bool ShaftHull::isClearOf(const Box3& box) const {
  return anyPlane([&](Vec3 normal, double most) {
    return dot(normal, box.farthest(-1 * normal) - center_) > most;
  });
}

bool ShaftHull::isClearOf(const MeshFace& face) const {
  return anyPlane([&](Vec3 normal, double most) {
    return std::ranges::all_of(face.corners,
                               [&](Vec3 p) { return dot(normal, p - center_) > most; });
  });
}

ShaftHull::Distances ShaftHull::distances(Vec2 onLine, Vec2 normal) const {
  const double ofCenter = dot(normal, center_.xy() - onLine);
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec3& p : targets()) {
    const double distance = dot(normal, p.xy());
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  return {ofCenter - radius_, ofCenter + radius_, ofCenter + least, ofCenter + most};
}

}  // namespace hearth
