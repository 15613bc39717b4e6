#include "text/progress_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace hearth {

namespace {

constexpr double kMaxSecondsLeft = 1000 * 86400.0;  // longer is no estimate

std::string_view name(Stage stage) {
  constexpr std::array<std::string_view, 4> kNames = {"loading", "surfaces", "baking", "writing"};
  return kNames[static_cast<std::size_t>(stage)];
}

/// Three digits and a unit of thousands: `1.24 M`.
std::string shortNumber(double value) {
  constexpr std::array<std::string_view, 5> kUnits = {"", " k", " M", " G", " T"};
  std::size_t unit = 0;
  for (; value >= 999.5 && unit + 1 < kUnits.size(); ++unit) value /= 1000;
  return fmt::format("{:.3g}{}", value, kUnits[unit]);
}

std::string shortTime(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  if (whole < 172800) return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
  return fmt::format("{} days", whole / 86400);
}

}  // namespace

int percentOf(const StageProgress& progress) {
  if (progress.done >= progress.total) return 100;
  const double fraction = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  return std::clamp(static_cast<int>(100 * fraction), 0, 99);
}

std::string progressText(const StageProgress& progress) {
  if (progress.total <= 0) return fmt::format("{} ...", name(progress.stage));
  std::string text = fmt::format("{:<8} {:3} %", name(progress.stage), percentOf(progress));
  const double perSecond = static_cast<double>(progress.done) / progress.seconds;
  if (progress.done <= 0 || !(progress.seconds > 0)) return text;
  text += fmt::format("  {} texels/s", shortNumber(perSecond));
  const double left = static_cast<double>(progress.total - progress.done) / perSecond;
  if (left >= 0 && left < kMaxSecondsLeft) text += fmt::format("  {} left", shortTime(left));
  return text;
}

}  // namespace hearth
