#include "settings/option_groups.h"

namespace hearth {

std::vector<Option> limitOptions() {
  return {Option::MaxFileBytes, Option::MaxImagePixels, Option::MaxVertices, Option::MaxLights};
}

std::vector<Option> settingOptions() {
  return {Option::Texel,   Option::Samples,       Option::SoftSamples,
          Option::CutOff,  Option::MiddleShadows, Option::Bounces,
          Option::Lambert, Option::NoLambert,     Option::Threads};
}

std::vector<Option> drawOptions() {
  return {Option::TextureFilter, Option::LightFilter, Option::PixelSize};
}

std::vector<Option> bakeOptions() {
  return std::vector<Option>{Option::Quality} + settingOptions() + limitOptions();
}

std::vector<Option> lightOptions() {
  return std::vector<Option>{Option::LightFrom, Option::NoCache} + bakeOptions();
}

std::vector<Option> operator+(std::vector<Option> a, const std::vector<Option>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace hearth
