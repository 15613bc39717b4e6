#pragma once

#include <string>
#include <string_view>

namespace hearth {

/// Runs another program of Hearth in this one's place, with `arguments` as of main(): from the
/// folder of this program, where it is built, or from ../libexec/hearth, where it is installed.
/// Returns only if that fails: what is wrong.
std::string startInstead(std::string_view program, char* const* arguments);

}  // namespace hearth
