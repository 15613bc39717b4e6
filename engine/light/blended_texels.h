#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "light/lightmap.h"
#include "math/vec.h"

namespace hearth {

/// A lightmap of one state, as it is summed up into a blended one.
class StateTexels {
 public:
  /// Three points of a plane, in texel coordinates.
  using Corners = std::array<Vec2, 3>;

  /// What lies at texel coordinates p of the blend lies at p + `shift` of the state.
  StateTexels(const Lightmap& map, double weight, Vec2 shift);
  /// What lies at `from` in the blend lies at `to` in the state, where texels `within` belong to
  /// the same part of the surface.
  StateTexels(const Lightmap& map, double weight, const Corners& from, const Corners& to,
              const TexelRect& within);

  /// Adds the weighted light at the middles of texels (i, j), (i + 1, j), .. of the blend, as many
  /// as there is room for: `channels` sums for each.
  void addRow(int i, int j, int channels, std::span<float> sums) const;

 private:
  void addEven(int channels, std::span<float> sums) const;
  void addShifted(int i, int j, int channels, std::span<float> sums) const;
  void addTurned(int i, int j, int channels, std::span<float> sums) const;

  const Lightmap* map_;
  float weight_;
  Vec2 min_;  ///< between which the state is read
  Vec2 max_;
  bool isShifted_;  ///< along its columns, if at all
  Vec2 at0_{0, 0};
  Vec2 axisS_{1, 0};
  Vec2 axisT_{0, 1};
};

/// Fills texels of `map`, which keeps each, with the sum of what the states have there, rounded
/// half up.
void blendInto(Lightmap& map, const TexelRect& part, std::span<const StateTexels> states);

}  // namespace hearth
