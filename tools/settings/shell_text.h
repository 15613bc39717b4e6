#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "settings/options.h"

/// Commands as text that a shell reads back.
namespace hearth {

/// One word, in quotes where it needs them.
std::string shellWord(std::string_view text);

/// Those of `options` that were given, as they are typed, a space before each.
std::string typedOptions(const OptionValues& values, const std::vector<Option>& options);

}  // namespace hearth
