#include "walk/slide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "math/predicates.h"
#include "walk/body.h"

namespace hearth {

namespace {

/// How often a motion may change its direction. Chains of walls so short that there are more of
/// them in one motion slow it down.
constexpr std::size_t kMaxContacts = 32;

/// Fraction of the motion. Less of it against a wall is rounding, which must not stop what slides.
constexpr double kAgainst = 1e-14;

struct Contact {
  double fraction;  ///< of the motion, 0..1
  Vec2 normal;      ///< of unit length, off the blocker
};

/// When a disc at `q` that moves by `motion` touches the vertex `v`, farther than `radius` now.
std::optional<Contact> touchVertex(Vec2 v, Vec2 q, Vec2 motion, double radius, double tolerance) {
  const Vec2 w = q - v;
  const double towards = dot(w, motion);
  if (towards >= -tolerance * length(w)) return std::nullopt;
  const double a = dot(motion, motion);
  const double c = dot(w, w) - radius * radius;
  const double root = towards * towards - a * c;
  if (root < 0) return std::nullopt;
  const double fraction = std::max(0.0, c / (-towards + std::sqrt(root)));
  if (fraction > 1) return std::nullopt;
  const Vec2 away = w + fraction * motion;
  return Contact{fraction, (1 / length(away)) * away};
}

std::optional<Contact> earlier(std::optional<Contact> a, std::optional<Contact> b) {
  if (!a || !b) return a ? a : b;
  return b->fraction < a->fraction ? b : a;
}

/// When it touches the round blocker.
std::optional<Contact> touchRound(const Blocker& blocker, Vec2 q, Vec2 motion, double radius,
                                  double tolerance) {
  const Vec2 away = q - blocker.a;
  const double distance = length(away);
  const double reach = radius + blocker.radius;
  if (distance >= reach) return touchVertex(blocker.a, q, motion, reach, tolerance);
  if (distance == 0 || dot(motion, away) >= -tolerance * distance) return std::nullopt;
  return Contact{0, (1 / distance) * away};
}

/// A blocker is convex, so once a motion does not come nearer to it, it never will again.
std::optional<Contact> touch(const Blocker& blocker, Vec2 q, Vec2 motion, double radius,
                             double tolerance) {
  if (blocker.radius > 0) return touchRound(blocker, q, motion, radius, tolerance);
  const Vec2 along = blocker.b - blocker.a;
  const double size = length(along);
  const double side = cross(along, q - blocker.a);
  if (blocker.isCorner) {
    if (side >= 0) return std::nullopt;
    return touch({blocker.a, blocker.a}, q, motion, radius, tolerance);
  }
  if (side < 0) return std::nullopt;
  const Vec2 away = q - nearestOnSegment(blocker.a, blocker.b, q);
  const double distance = length(away);
  if (distance < radius) {
    Vec2 normal = turned90(along);
    if (distance > 0) normal = away;
    const double normalLength = length(normal);
    if (normalLength == 0) return std::nullopt;
    normal = (1 / normalLength) * normal;
    if (dot(motion, normal) < -tolerance) return Contact{0, normal};
    return std::nullopt;
  }
  std::optional<Contact> first = earlier(touchVertex(blocker.a, q, motion, radius, tolerance),
                                         touchVertex(blocker.b, q, motion, radius, tolerance));
  if (size == 0) return first;
  const Vec2 normal = (1 / size) * turned90(along);
  const double approach = dot(motion, normal);
  if (approach >= -tolerance) return first;
  // Rounding may put the body within the radius here and not above.
  const double fraction = std::max(0.0, (radius - side / size) / approach);
  const double at = dot(q + fraction * motion - blocker.a, along);
  if (fraction <= 1 && at >= 0 && at <= size * size)
    first = earlier(first, Contact{fraction, normal});
  return first;
}

/// The contacts at one place of the disc.
class Contacts {
 public:
  void clear() { count_ = 0; }
  void add(Vec2 normal) { normals_[count_++] = normal; }

  /// The part of `wanted` along one of them that runs against no other, or nothing.
  Vec2 allowed(Vec2 wanted, double tolerance) const {
    for (std::size_t i = count_; i-- > 0;) {
      const Vec2 along = wanted - dot(wanted, normals_[i]) * normals_[i];
      if (dot(wanted, normals_[i]) < 0 && isFree(along, tolerance)) return along;
    }
    return {0, 0};
  }

 private:
  bool isFree(Vec2 motion, double tolerance) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (dot(motion, normals_[i]) < -tolerance) return false;
    return true;
  }

  std::array<Vec2, kMaxContacts> normals_;
  std::size_t count_ = 0;
};

}  // namespace

Slide slideAlong(std::span<const Blocker> blockers, Vec2 motion, double radius) {
  const double tolerance = kAgainst * length(motion);
  Slide slide;
  Contacts contacts;
  double left = 1;  // of the motion
  Vec2 next = motion;
  for (std::size_t i = 0; i < kMaxContacts; ++i) {
    std::optional<Contact> first;
    for (const Blocker& blocker : blockers)
      first = earlier(first, touch(blocker, slide.displacement, next, radius, tolerance));
    slide.displacement = slide.displacement + (first ? first->fraction : 1) * next;
    if (!first) return slide;
    slide.collided = true;
    // A contact that was slid away from does not hold any more.
    if (first->fraction * length(next) > kSkin * radius) contacts.clear();
    left *= 1 - first->fraction;
    contacts.add(first->normal);
    next = contacts.allowed(left * motion, tolerance);
    if (next == Vec2{}) return slide;
  }
  return slide;
}

}  // namespace hearth
