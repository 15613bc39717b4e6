#pragma once

#include <vector>

#include "settings/options.h"

namespace hearth {

/// Options that all commands share: limits of loading.
std::vector<Option> limitOptions();
/// How to bake.
std::vector<Option> settingOptions();
/// How to draw: what pictures may be less accurate in.
std::vector<Option> drawOptions();
/// How to bake, and limits of loading.
std::vector<Option> bakeOptions();
/// Where light is taken from, how to bake, and limits of loading.
std::vector<Option> lightOptions();
std::vector<Option> operator+(std::vector<Option> a, const std::vector<Option>& b);

}  // namespace hearth
