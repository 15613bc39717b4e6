#include "light/blended_texels.h"

#include <algorithm>
#include <cmath>

namespace hearth {

namespace {

/// A sum begins with a half, so that cutting it off rounds half up.
constexpr float kHalf = 0.5F;

/// Weights add up to 1, so no sum is much above 255.
std::uint8_t cutOff(float sum) {
  return static_cast<std::uint8_t>(std::min(static_cast<int>(sum), 255));
}

void addWeighted(float weight, const std::uint8_t* levels, std::span<float> sums) {
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += weight * levels[k];
}

/// Texels of a row that are summed up at once, on the stack.
constexpr int kTexelsAtOnce = 64;

}  // namespace

StateTexels::StateTexels(const Lightmap& map, double weight, Vec2 shift)
    : map_(&map),
      weight_(static_cast<float>(weight)),
      min_{map.rect.i0 + 0.5, map.rect.j0 + 0.5},
      max_{map.rect.i0 + map.rect.width - 0.5, map.rect.j0 + map.rect.height - 0.5},
      isShifted_(shift.x == 0),
      at0_(shift) {}

StateTexels::StateTexels(const Lightmap& map, double weight, const Corners& from, const Corners& to,
                         const TexelRect& within)
    : map_(&map),
      weight_(static_cast<float>(weight)),
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

void StateTexels::addRow(int i, int j, int channels, std::span<float> sums) const {
  if (map_->isUniform())
    addEven(channels, sums);
  else if (isShifted_)
    addShifted(i, j, channels, sums);
  else
    addTurned(i, j, channels, sums);
}

void StateTexels::addEven(int channels, std::span<float> sums) const {
  const int last = map_->channels - 1;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const int channel = static_cast<int>(k) % channels;
    sums[k] += weight_ * map_->levels[static_cast<std::size_t>(std::min(channel, last))];
  }
}

/// Columns of the blend are columns of the state.
void StateTexels::addShifted(int i, int j, int channels, std::span<float> sums) const {
  const TexelRect& rect = map_->rect;
  const double down = std::clamp(j + 0.5 + at0_.y, min_.y, max_.y) - (rect.j0 + 0.5);
  const int row = std::min(static_cast<int>(down), rect.height - 1);
  const auto below = static_cast<float>(down - row);
  const auto perRow =
      static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(map_->channels);
  const std::uint8_t* const upper = &map_->levels[static_cast<std::size_t>(row) * perRow];
  const std::uint8_t* const lower = below == 0 ? upper : upper + perRow;
  const int texels = static_cast<int>(sums.size()) / channels;
  if (i >= rect.i0 && i + texels <= rect.i0 + rect.width && channels == map_->channels) {
    const std::ptrdiff_t first = std::ptrdiff_t{i - rect.i0} * channels;
    addWeighted(weight_ * (1 - below), upper + first, sums);
    if (below > 0) addWeighted(weight_ * below, lower + first, sums);
    return;
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const int texel = static_cast<int>(k) / channels;
    const int channel = std::min(static_cast<int>(k) % channels, map_->channels - 1);
    const int column = std::clamp(i + texel - rect.i0, 0, rect.width - 1);
    const int index = column * map_->channels + channel;
    sums[k] += weight_ * (1 - below) * upper[index] + weight_ * below * lower[index];
  }
}

void StateTexels::addTurned(int i, int j, int channels, std::span<float> sums) const {
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const int texel = static_cast<int>(k) / channels;
    const double s = i + texel + 0.5;
    const Vec2 at = at0_ + s * axisS_ + (j + 0.5) * axisT_;
    const double level =
        map_->sample(std::clamp(at.x, min_.x, max_.x), std::clamp(at.y, min_.y, max_.y),
                     static_cast<int>(k) % channels);
    sums[k] += weight_ * static_cast<float>(level);
  }
}

void blendInto(Lightmap& map, const TexelRect& part, std::span<const StateTexels> states) {
  std::array<float, 3 * std::size_t{kTexelsAtOnce}> memory;
  for (int j = part.j0; j < part.j0 + part.height; ++j)
    for (int i = part.i0; i < part.i0 + part.width; i += kTexelsAtOnce) {
      const int texels = std::min(kTexelsAtOnce, part.i0 + part.width - i);
      const std::span<float> sums(memory.data(), static_cast<std::size_t>(texels * map.channels));
      std::ranges::fill(sums, kHalf);
      for (const StateTexels& state : states) state.addRow(i, j, map.channels, sums);
      std::ranges::transform(sums, map.texel(i, j), cutOff);
    }
}

}  // namespace hearth
