#include "hearth/command.h"

#include <fmt/format.h>

#include <cstdio>

namespace hearth {

ExitStatus fail(std::string_view message) {
  fmt::print(stderr, "hearth: error: {}\n", message);
  return ExitStatus::BadInput;
}

std::vector<Option> limitOptions() {
  return {Option::MaxFileBytes, Option::MaxImagePixels, Option::MaxVertices, Option::MaxLights};
}

std::vector<Option> bakeOptions() {
  return std::vector<Option>{Option::Texel,   Option::Samples,   Option::Bounces,
                             Option::Lambert, Option::NoLambert, Option::Threads} +
         limitOptions();
}

std::vector<Option> operator+(std::vector<Option> a, const std::vector<Option>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace hearth
