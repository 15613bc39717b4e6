#include "settings/quality.h"

#include <algorithm>
#include <array>
#include <string>

#include "math/check.h"

namespace hearth {

namespace {

constexpr DrawSettings kExact{};
constexpr DrawSettings kTwoByTwoPixels{.pixelSize = 2};

constexpr std::array kQualities = {
    Quality{"draft", {2, false, 0, 4}, kTwoByTwoPixels},
    Quality{"normal", {1, false, 36, 1}, kExact},
    Quality{"high", {0.5, false, 36, 1}, kExact},
    Quality{"reference", {0.25, true, 64, 0.25}, kExact},
};

}  // namespace

BakeSettings BakeQuality::appliedTo(const BakeSettings& authored) const {
  BakeSettings settings = authored;
  settings.texel *= texelScale;
  if (adaptiveSamples) settings.samples.reset();
  settings.softSamples = softSamples;
  settings.gatherError = gatherError;
  return settings;
}

std::span<const Quality> qualities() { return kQualities; }

const Quality* qualityNamed(std::string_view name) {
  const auto found = std::ranges::find(kQualities, name, &Quality::name);
  return found == kQualities.end() ? nullptr : &*found;
}

const Quality& qualityFrom(const OptionValues& values) {
  const std::string name = values.text(Option::Quality).value_or(std::string(kDefaultQuality));
  const Quality* const quality = qualityNamed(name);
  CHECK(quality, name);  // the option takes no other
  return *quality;
}

}  // namespace hearth
