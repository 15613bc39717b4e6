#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "load/link/link.h"
#include "load/link/plane_fit.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Slopes of one sector, whose border is sound.
class SlopeLinker {
 public:
  SlopeLinker(Linking& linking, std::size_t index)
      : linking_(linking),
        index_(index),
        description_(linking.description.sectors[index]),
        sector_(linking.level.sectors[index]) {
    const OutlineSector& outline = linking.outlines.sectors[index];
    const OutlineLoop& border = outline.loops[0];
    for (std::uint32_t i = 0; i < border.edgeCount; ++i)
      border_.push_back(linking.outlines.points[border.firstVertex + i]);
    double shortest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < border.edgeCount; ++i)
      shortest =
          std::min(shortest, linking.outlines.length(linking.outlines.edges[border.firstEdge + i]));
    noise_ = noiseOf(shortest);
  }

  void link() {
    for (Flat* flat : {&sector_.floor, &sector_.ceiling}) setOrigin(*flat);
    if (description_.slopeFloor)
      sector_.floorSlope = fit(*description_.slopeFloor, sector_.floor.z, 1);
    if (description_.slopeCeil)
      sector_.ceilingSlope = fit(*description_.slopeCeil, sector_.ceiling.z, -1);
    if (!linking_.isDoubtful[index_]) checkRoom();
  }

 private:
  void setOrigin(Flat& flat) const {
    const bool isFloor = &flat == &sector_.floor;
    const bool isSloped =
        isFloor ? description_.slopeFloor.has_value() : description_.slopeCeil.has_value();
    const bool isRelative =
        isFloor ? description_.floor.isRelative : description_.ceiling.isRelative;
    if (isSloped || isRelative) flat.textureOrigin = border_[0];
  }

  void fail(Place place, std::string message, std::string advice) {
    linking_.report.error(place, std::move(message), std::move(advice));
    linking_.isDoubtful[index_] = true;
  }

  /// `up` is 1 for a wedge that stands on `zFlat`, -1 for one that hangs from it.
  std::optional<Slope> fit(const SlopeDescription& described, double zFlat, double up) {
    if (described.heights.size() != border_.size()) {
      fail(described.place,
           fmt::format("{} heights for a border of {} vertices", described.heights.size(),
                       border_.size()),
           "give one height for each vertex of the border");
      return std::nullopt;
    }
    std::vector<Vec3> known;
    for (std::size_t i = 0; i < border_.size(); ++i)
      if (described.heights[i])
        known.push_back({border_[i].x, border_[i].y, zFlat + up * *described.heights[i]});
    const std::optional<PlaneFit> plane = fitPlane(known, border_[0], noise_);
    if (!plane) {
      fail(described.place, "the heights do not give a plane",
           "give the heights of at least three vertices that do not lie in one line");
      return std::nullopt;
    }
    if (plane->worstMiss > noise_) {
      fail(described.place,
           fmt::format("the heights miss a plane by up to {:.6g} m", plane->worstMiss),
           "correct them, or write null for all but three");
      return std::nullopt;
    }
    return toSlope(described, *plane, zFlat, up);
  }

  std::optional<Slope> toSlope(const SlopeDescription& described, const PlaneFit& plane,
                               double zFlat, double up) {
    Slope slope{border_[0], plane.zAtOrigin, plane.gradient, {}, described.isRelative};
    if (described.sidewall) slope.sidewall = linking_.textures.link(*described.sidewall);
    double lowest = 0;
    for (std::size_t i = 0; i < border_.size(); ++i) {
      const double height = up * (slope.zAt(border_[i]) - zFlat);
      lowest = std::min(lowest, height);
      if (described.heights[i] || height >= -noise_) continue;
      fail(described.heightPlaces[i],
           fmt::format("the plane of the other heights is {:.6g} m on the wrong side of the flat "
                       "here",
                       -height),
           "a wedge stands on its floor or hangs from its ceiling: correct the other heights");
      return std::nullopt;
    }
    // Noise can take the plane past the flat, where no wall would bound the air.
    slope.zAt0 -= up * lowest;
    return slope;
  }

  /// What stands on the floor and what hangs from the ceiling may touch, but not pass each other.
  void checkRoom() {
    if (!sector_.floorSlope && !sector_.ceilingSlope) return;
    double worst = 0;
    for (const Vec2 p : border_)
      worst = std::max(worst, sector_.authoredBottom(p) - sector_.authoredTop(p));
    if (worst <= noise_) return;
    const SlopeDescription& at =
        description_.slopeFloor ? *description_.slopeFloor : *description_.slopeCeil;
    fail(at.place, fmt::format("the wedge passes what is opposite to it by {:.6g} m", worst),
         "lower its heights or raise the ceiling");
  }

  Linking& linking_;
  std::size_t index_;
  const SectorDescription& description_;
  Sector& sector_;
  std::vector<Vec2> border_;  ///< in file order
  double noise_ = 0;
};

}  // namespace

void linkSlopes(Linking& linking) {
  for (std::size_t i = 0; i < linking.level.sectors.size(); ++i)
    if (linking.outlines.sectors[i].isSound) SlopeLinker(linking, i).link();
}

}  // namespace hearth
