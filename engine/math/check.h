#pragma once

#include <sstream>
#include <string>

namespace hearth {

/// Stops the program after a broken invariant, having printed where, what and with which values.
/// Bad *input* never comes here: it is reported as a value with its place in the file.
[[noreturn]] void checkFailed(const char* file, int line, const char* expression,
                              const std::string& values);

namespace detail {
template <typename... Values>
std::string joinValues(const Values&... values) {
  std::ostringstream text;
  text.precision(17);
  ((text << ' ' << values), ...);
  return text.str();
}
}  // namespace detail

}  // namespace hearth

/// CHECK(condition, value, ...): `condition` holds unless the program itself is wrong.
#define CHECK(condition, ...)                                           \
  do {                                                                  \
    if (!(condition)) [[unlikely]]                                      \
      ::hearth::checkFailed(__FILE__, __LINE__, #condition,             \
                            ::hearth::detail::joinValues(__VA_ARGS__)); \
  } while (false)
