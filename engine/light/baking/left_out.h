#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "light/baking/texel_sums.h"
#include "light/sampling/sample_placement.h"

namespace hearth {

/// Which samples are left out of their texels: those of a surface that lie inside a mesh, and those
/// of a mesh that lie in no air. Nothing can show there, and their darkness must not bleed out.
class LeftOut {
 public:
  template <typename Lit>
  LeftOut(const Lit& surface, const std::vector<SamplePoint>& samples) {
    if (!surface.mayLeaveOut()) return;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!surface.isLeftOut(samples[i])) continue;
      isOut_.resize(samples.size());
      isOut_[i] = 1;
    }
  }

  bool isNone() const { return isOut_.empty(); }
  bool is(std::size_t sample) const { return !isNone() && isOut_[sample] != 0; }
  template <typename Samples>
  bool isAny(const Samples& samples) const {
    return !isNone() && std::ranges::any_of(samples, [&](std::size_t i) { return is(i); });
  }
  template <typename Samples>
  bool areAll(const Samples& samples) const {
    return !isNone() && std::ranges::all_of(samples, [&](std::size_t i) { return is(i); });
  }

 private:
  std::vector<std::uint8_t> isOut_;  ///< by sample; empty where none is
};

/// Texels of a rectangle without a sample that counts.
class EmptyTexels {
 public:
  explicit EmptyTexels(const TexelRect& rect) : rect_(rect) {}

  void add(int i, int j) { texels_.push_back({i, j}); }
  /// One that filtering does not read, and that goes on as texel (`used`, j) does.
  void addUnused(int i, int j, int used) { unused_.push_back({i, j, used}); }

  /// Gives each the sums of the nearest texel that has a sample and is read; dark where none is.
  void fill(TexelSums& sums) const;

 private:
  struct Texel {
    int i;
    int j;
  };

  struct UnusedTexel {
    int i;
    int j;
    int used;
  };

  TexelRect rect_;
  std::vector<Texel> texels_;  ///< row by row
  std::vector<UnusedTexel> unused_;
};

}  // namespace hearth
