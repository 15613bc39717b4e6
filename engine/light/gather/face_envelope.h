#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/ids.h"
#include "light/gather/blocked_slopes.h"

namespace hearth {

/// The part of a face in the plane of a slice. Along a straight part 1 / distance is linear in the
/// slope, as it is across a picture: depth buffers rely on the same.
struct FaceCut {
  SlopeRange slopes;
  double nearFrom;     ///< 1 / metres on the map from the start, at `slopes.from` ...
  double nearTo;       ///< ... and at `slopes.to`
  SurfaceId mesh;      ///< of its face
  std::uint32_t face;  ///< index into Level::meshFaces

  double nearAt(double slope) const {
    return std::lerp(nearFrom, nearTo, (slope - slopes.from) / (slopes.to - slopes.from));
  }
};

/// Of faces in a slice, at each slope the nearest: the upper envelope of their 1 / distance.
class FaceEnvelope {
 public:
  void clear() {
    cuts_.clear();
    parts_.clear();
  }

  /// Where two lie in one place the first that was added counts.
  void add(const FaceCut& cut);

  /// Whether something hides all of a range from what is no nearer than this.
  bool hide(SlopeRange slopes, double nearest) const;

  /// Calls `visit(slopes, cut)` for what is seen of each, from below.
  template <typename Visit>
  void forEachSeen(Visit&& visit) const {
    for (const Part& part : parts_) visit(part.slopes, cuts_[part.cut]);
  }

  /// Calls `visit` for what these leave of a range, from below.
  template <typename Visit>
  void forEachFree(SlopeRange all, Visit&& visit) const {
    hearth::forEachFree(parts_, &Part::slopes, all, visit);
  }

 private:
  struct Part {
    SlopeRange slopes;
    std::uint32_t cut;  ///< index into `cuts_`
  };

  SlopeRange whereNearer(const FaceCut& cut, const Part& part) const;

  std::vector<FaceCut> cuts_;
  std::vector<Part> parts_;  ///< rising, apart from one another
  std::vector<Part> changed_;
};

}  // namespace hearth
