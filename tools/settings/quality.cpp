#include "settings/quality.h"

#include <algorithm>
#include <array>

namespace hearth {

namespace {

constexpr DrawSettings kExact{};
constexpr DrawSettings kSquares{.pixelSize = 2};

constexpr std::array kQualities = {
    Quality{"draft", {2, false, 0}, kSquares},
    Quality{"normal", {1, false, 36}, kExact},
    Quality{"high", {0.5, false, 36}, kExact},
    Quality{"reference", {0.25, true, 64}, kExact},
};

}  // namespace

BakeSettings BakeQuality::appliedTo(const BakeSettings& authored) const {
  BakeSettings settings = authored;
  settings.texel *= texelScale;
  if (adaptiveSamples) settings.samples.reset();
  settings.softSamples = softSamples;
  return settings;
}

std::span<const Quality> qualities() { return kQualities; }

const Quality* qualityNamed(std::string_view name) {
  const auto found = std::ranges::find(kQualities, name, &Quality::name);
  return found == kQualities.end() ? nullptr : &*found;
}

}  // namespace hearth
