#include "light/blended_texels.h"

#include <algorithm>
#include <cmath>

namespace hearth {

namespace {

std::uint8_t rounded(double level) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(level + 0.5), 0.0, 255.0));
}

/// Texels of a row that are summed up at once, on the stack.
constexpr int kTexelsAtOnce = 64;

}  // namespace

StateTexels::StateTexels(const Lightmap& map, double weight, Vec2 shift)
    : map_(&map),
      weight_(weight),
      min_{map.rect.i0 + 0.5, map.rect.j0 + 0.5},
      max_{map.rect.i0 + map.rect.width - 0.5, map.rect.j0 + map.rect.height - 0.5},
      isShifted_(shift.x == 0),
      at0_(shift) {}

StateTexels::StateTexels(const Lightmap& map, double weight, const Corners& from, const Corners& to,
                         const TexelRect& within)
    : map_(&map),
      weight_(weight),
      min_{within.i0 + 0.5, within.j0 + 0.5},
      max_{within.i0 + within.width - 0.5, within.j0 + within.height - 0.5},
      isShifted_(false) {
  const Vec2 u = from[1] - from[0];
  const Vec2 v = from[2] - from[0];
  const double area = cross(u, v);
  axisS_ = (v.y / area) * (to[1] - to[0]) - (u.y / area) * (to[2] - to[0]);
  axisT_ = (u.x / area) * (to[2] - to[0]) - (v.x / area) * (to[1] - to[0]);
  at0_ = to[0] - from[0].x * axisS_ - from[0].y * axisT_;
}

void StateTexels::addRow(int i, int j, int channels, std::span<double> sums) const {
  if (map_->isUniform())
    addEven(channels, sums);
  else if (isShifted_)
    addShifted(i, j, channels, sums);
  else
    addTurned(i, j, channels, sums);
}

void StateTexels::addEven(int channels, std::span<double> sums) const {
  const int last = map_->channels - 1;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const int channel = static_cast<int>(k) % channels;
    sums[k] += weight_ * map_->levels[static_cast<std::size_t>(std::min(channel, last))];
  }
}

/// Columns of the blend are columns of the state.
void StateTexels::addShifted(int i, int j, int channels, std::span<double> sums) const {
  const TexelRect& rect = map_->rect;
  const double down = std::clamp(j + 0.5 + at0_.y, min_.y, max_.y) - (rect.j0 + 0.5);
  const int row = std::min(static_cast<int>(down), rect.height - 1);
  const double below = down - row;
  const int perRow = rect.width * map_->channels;
  const std::uint8_t* const upper =
      &map_->levels[static_cast<std::size_t>(row) * static_cast<std::size_t>(perRow)];
  const auto level = [&](int index) -> double {
    return below == 0 ? upper[index] : std::lerp(upper[index], upper[index + perRow], below);
  };
  const int texels = static_cast<int>(sums.size()) / channels;
  if (i >= rect.i0 && i + texels <= rect.i0 + rect.width && channels == map_->channels) {
    const int first = (i - rect.i0) * channels;
    for (std::size_t k = 0; k < sums.size(); ++k)
      sums[k] += weight_ * level(first + static_cast<int>(k));
    return;
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const int texel = static_cast<int>(k) / channels;
    const int channel = std::min(static_cast<int>(k) % channels, map_->channels - 1);
    const int column = std::clamp(i + texel - rect.i0, 0, rect.width - 1);
    sums[k] += weight_ * level(column * map_->channels + channel);
  }
}

void StateTexels::addTurned(int i, int j, int channels, std::span<double> sums) const {
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const double s = i + static_cast<int>(k) / channels + 0.5;
    const Vec2 at = at0_ + s * axisS_ + (j + 0.5) * axisT_;
    sums[k] +=
        weight_ * map_->sample(std::clamp(at.x, min_.x, max_.x), std::clamp(at.y, min_.y, max_.y),
                               static_cast<int>(k) % channels);
  }
}

void blendInto(Lightmap& map, const TexelRect& part, std::span<const StateTexels> states) {
  std::array<double, 3 * kTexelsAtOnce> memory;
  for (int j = part.j0; j < part.j0 + part.height; ++j)
    for (int i = part.i0; i < part.i0 + part.width; i += kTexelsAtOnce) {
      const int texels = std::min(kTexelsAtOnce, part.i0 + part.width - i);
      const std::span sums(memory.data(), static_cast<std::size_t>(texels * map.channels));
      std::ranges::fill(sums, 0.0);
      for (const StateTexels& state : states) state.addRow(i, j, map.channels, sums);
      std::ranges::transform(sums, map.texel(i, j), rounded);
    }
}

}  // namespace hearth
