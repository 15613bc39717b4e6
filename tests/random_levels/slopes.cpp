#include "random_levels/slopes.h"

#include <algorithm>
#include <cmath>

#include "random_levels/texture_uses.h"

namespace hearth::random_levels {
namespace {

std::vector<Vec2> borderOf(const Model& model, const Sector& sector) {
  std::vector<Vec2> points;
  for (const VertexId v : sector.loops[0].vertices)
    points.push_back(metres(model.mesh.vertices[v]));
  return points;
}

struct Extent {
  double low = 0;
  double high = 0;
};

Extent extentAlong(Vec2 direction, const std::vector<Vec2>& points) {
  Extent extent{dot(direction, points[0]), dot(direction, points[0])};
  for (const Vec2 p : points) {
    extent.low = std::min(extent.low, dot(direction, p));
    extent.high = std::max(extent.high, dot(direction, p));
  }
  return extent;
}

/// The three vertices that span the largest triangle: the plane through them says the heights of
/// all others without magnifying what rounding did to these.
std::set<std::size_t> widestTriangle(const std::vector<Vec2>& points) {
  std::set<std::size_t> widest;
  double most = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const double area = std::abs(cross(points[j] - points[i], points[k] - points[i]));
        if (area > most) widest = {i, j, k};
        most = std::max(most, area);
      }
    }
  }
  return widest;
}

/// Metres: the format's tolerance follows from it.
double shortestEdge(const Model& model, const Sector& sector) {
  double shortest = 1e9;
  for (const Loop& loop : sector.loops) {
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const VertexId next = loop.vertices[(i + 1) % loop.vertices.size()];
      const Point end = model.mesh.vertices[next];
      shortest = std::min(shortest, distance(model.mesh.vertices[loop.vertices[i]], end));
    }
  }
  return shortest;
}

class SlopeBuilder {
 public:
  SlopeBuilder(Random& random, Model& model) : random_(random), model_(model) {}

  void slopeSome(double fraction) {
    for (Sector& sector : model_.sectors) {
      if (!maySlope(sector) || sector.floor.wedge || sector.ceiling.wedge) continue;
      const bool hasFloor = sector.floor.isPlain() && random_.chance(fraction);
      const bool hasCeiling = sector.ceiling.isPlain() && random_.chance(fraction * 0.7);
      // Both wedges together fill at most the height.
      const double floorPart = hasFloor && hasCeiling ? random_.pick({0.25, 0.5, 0.7}) : 1;
      if (hasFloor) slope(sector, sector.floor, floorPart);
      if (hasCeiling) slope(sector, sector.ceiling, hasFloor ? 1 - floorPart : 1);
    }
  }

  /// One plane over two neighbours, as far as some pair has room for it.
  void continueOne() {
    for (Sector& sector : model_.sectors) {
      for (const Wall& wall : sector.loops[0].walls) {
        for (const PortalPiece* portal : portalsOf(wall)) {
          Sector& next = model_.sectors[portal->next];
          const bool isFloor = random_.chance(0.5);
          if (&sector != &next && continueInto(sector, next, isFloor)) return;
        }
      }
    }
  }

 private:
  static bool maySlope(const Sector& sector) {
    return sector.height() >= 500'000 && !sector.isChainLink;
  }

  /// A wedge of at most `part` of the sector's height.
  void slope(const Sector& sector, Flat& flat, double part) {
    const std::vector<Vec2> border = borderOf(model_, sector);
    const double room = metres(sector.height()) * part;
    const double top = room * random_.pick({1.0, 1.0, 0.6, 0.4, 0.25, 0.1});
    const double foot = top * random_.pick({0.0, 0.0, 0.0, 0.2, 0.5, 1.0});
    const Vec2 direction = randomDirection(border);
    const Extent extent = extentAlong(direction, border);
    const double rise = (top - foot) / (extent.high - extent.low);
    setWedge(sector, flat, rise * direction, foot - rise * extent.low);
  }

  /// Along an axis, square to a wall (so that a whole edge is level), or any.
  Vec2 randomDirection(const std::vector<Vec2>& border) {
    const std::size_t i = random_.below(border.size());
    switch (random_.below(4)) {
      case 0:
        return {1, 0};
      case 1:
        return {0, -1};
      case 2: {
        const Vec2 edge = border[(i + 1) % border.size()] - border[i];
        return 1 / length(edge) * turned90(edge);
      }
      default: {
        const double x = random_.real(0.1, 1);
        return {x, random_.real(-1, -0.1)};
      }
    }
  }

  void setWedge(const Sector& sector, Flat& flat, Vec2 gradient, double base) {
    Wedge wedge{.gradient = gradient, .base = base, .nulls = {}, .sidewall = wallTexture(random_)};
    wedge.isRelative = random_.chance(0.4);
    wedge.isRounded = shortestEdge(model_, sector) > 0.3 && random_.chance(0.15);
    const std::vector<Vec2> border = borderOf(model_, sector);
    const std::set<std::size_t> needed = widestTriangle(border);
    const bool hasNulls = border.size() > 3 && random_.chance(0.35);
    for (std::size_t i = 0; hasNulls && i < border.size(); ++i) {
      if (!needed.contains(i) && random_.chance(0.7)) wedge.nulls.insert(i);
    }
    flat.wedge = wedge;
  }

  /// For ceilings, heights count downwards: the same sums with the sign of z turned.
  bool continueInto(Sector& a, Sector& b, bool isFloor) {
    Flat& flatA = isFloor ? a.floor : a.ceiling;
    Flat& flatB = isFloor ? b.floor : b.ceiling;
    if (!maySlope(a) || !maySlope(b) || !flatA.isPlain() || !flatB.isPlain()) return false;
    if ((isFloor ? a.ceiling : a.floor).wedge || (isFloor ? b.ceiling : b.floor).wedge)
      return false;
    const double sign = isFloor ? 1 : -1;
    const double footA = sign * metres(flatA.z);
    const double footB = sign * metres(flatB.z);
    const double foot = std::max(footA, footB);
    const double top = std::min(footA + metres(a.height()), footB + metres(b.height()));
    if (top - foot < 0.2) return false;
    const std::vector<Vec2> borderA = borderOf(model_, a);
    std::vector<Vec2> both = borderOf(model_, b);
    both.insert(both.end(), borderA.begin(), borderA.end());
    const Vec2 direction = randomDirection(borderA);
    const Extent extent = extentAlong(direction, both);
    const double rise = (top - foot) * random_.pick({0.25, 0.5, 0.9}) / (extent.high - extent.low);
    const double base = foot - rise * extent.low;
    setWedge(a, flatA, rise * direction, base - footA);
    setWedge(b, flatB, rise * direction, base - footB);
    return true;
  }

  Random& random_;
  Model& model_;
};

}  // namespace

void makeSlopes(Random& random, Model& model, double fraction) {
  SlopeBuilder builder(random, model);
  if (fraction > 0 && random.chance(0.6)) builder.continueOne();
  if (fraction > 0) builder.slopeSome(fraction);
}

}  // namespace hearth::random_levels
