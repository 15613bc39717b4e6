#include "load/json/color.h"

#include <charconv>

namespace hearth {

std::optional<Rgb> parseColor(std::string_view text) {
  if (text.size() != 7 || text[0] != '#' || text[1] == '-') return std::nullopt;
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, value, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  return Rgb{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8 & 255),
             static_cast<std::uint8_t>(value & 255)};
}

}  // namespace hearth
