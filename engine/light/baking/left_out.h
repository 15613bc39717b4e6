#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "light/lightmap.h"
#include "light/sampling/sample_placement.h"
#include "light/used_texels.h"

namespace hearth {

/// Which samples are left out of their texels: those of a surface that lie inside a mesh, and those
/// of a mesh that lie in no air. Nothing can show there, and their darkness must not bleed out.
class LeftOut {
 public:
  template <typename Lit>
  LeftOut(const Lit& surface, const std::vector<SamplePoint>& samples) {
    if (!surface.mayLeaveOut()) return;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].isSpare || !surface.isLeftOut(samples[i])) continue;
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

/// Used texels without a sample that counts.
class EmptyTexels {
 public:
  /// They are some of `texels`.
  explicit EmptyTexels(const UsedTexels& texels) : used_(texels) {}

  void add(int i, int j) { texels_.push_back({i, j}); }

  /// Calls `visit(i, j)` for each.
  template <typename Visit>
  void forEach(Visit&& visit) const {
    for (const auto& [i, j] : texels_) visit(i, j);
  }

  /// Gives each the light of the nearest used texel that has a sample; dark where none is. The
  /// lightmap keeps all its texels.
  void fill(Lightmap& map) const;

 private:
  struct Texel {
    int i;
    int j;
  };

  const UsedTexels& used_;
  std::vector<Texel> texels_;  ///< row by row
};

}  // namespace hearth
