#include "load/model/model_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace hearth {

namespace {

/// The `e` of a decimal number. Held within what no text makes up for by its digits.
std::int64_t exponentOf(std::string_view number) {
  constexpr std::int64_t kMost = std::int64_t{1} << 40;
  const std::size_t letter = number.find_first_of("eE");
  if (letter == std::string_view::npos) return 0;
  std::string_view digits = number.substr(letter + 1);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t exponent = 0;
  const auto error = std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec;
  if (error == std::errc::result_out_of_range) return digits.starts_with('-') ? -kMost : kMost;
  return std::clamp(exponent, -kMost, kMost);
}

/// Of a decimal number that is not 0: whether it is below 1.
bool isBelowOne(std::string_view number) {
  const std::string_view digits = number.substr(0, number.find_first_of("eE"));
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
  const std::int64_t places = point > first ? point - first : point - first + 1;
  return places + exponentOf(number) <= 0;
}

}  // namespace

std::optional<double> nearestDouble(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double number = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error == std::errc::invalid_argument || stop != end) return std::nullopt;
  if (std::isnan(number)) return std::nullopt;
  if (error != std::errc::result_out_of_range) return number;
  // It does not say which end of the range was left.
  const double sign = word.starts_with('-') ? -1 : 1;
  return sign * (isBelowOne(word) ? 0 : std::numeric_limits<double>::infinity());
}

bool takeNumbers(const ModelLine& line, std::string_view& rest, const WantedNumbers& wanted,
                 std::span<double> numbers, ModelReport& report) {
  const NumberRange range = wanted.range;
  for (double& number : numbers) {
    const auto word = takeWord(rest);
    if (!word) {
      report.error(line.number, fmt::format("\"{}\" has too few numbers", shortened(line.keyword)),
                   fmt::format("give {}", wanted.names));
      return false;
    }
    const std::optional<double> read = nearestDouble(*word);
    if (!read) {
      report.error(line.number, fmt::format("\"{}\" is no number", shortened(*word)),
                   "write it like 1.25 or -3e-5");
      return false;
    }
    if (!(*read >= range.min && *read <= range.max)) {
      report.error(line.number, fmt::format("{} is out of range", shortened(*word)),
                   fmt::format("give a number from {} to {}", range.min, range.max));
      return false;
    }
    number = *read;
  }
  return true;
}

void leaveOutRest(const ModelLine& line, std::string_view rest, ModelReport& report) {
  if (takeWord(rest)) report.leaveOut(fmt::format("more numbers of {}", line.keyword), line.number);
}

}  // namespace hearth
