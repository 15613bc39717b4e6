#include "area_light/area_tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hearth::area_light {

void Errors::add(double error, double errorOfTruth) {
  ++places;
  far += std::abs(error) > kFar + 3 * errorOfTruth ? 1 : 0;
  squares += error * error;
  squaresOfTruth += errorOfTruth * errorOfTruth;
  greatest = std::max(greatest, std::abs(error));
}

Errors& Errors::operator+=(const Errors& other) {
  places += other.places;
  far += other.far;
  squares += other.squares;
  squaresOfTruth += other.squaresOfTruth;
  greatest = std::max(greatest, other.greatest);
  return *this;
}

double Errors::rms() const {
  return places == 0 ? 0 : std::sqrt(squares / static_cast<double>(places));
}

double Errors::rmsOfBake() const {
  const double rest = std::max(0.0, squares - squaresOfTruth);
  return places == 0 ? 0 : std::sqrt(rest / static_cast<double>(places));
}

void AreaTally::add(SurfaceKind kind, double baked, double truth, double errorOfTruth,
                    const std::string& at) {
  // Between the corners of a small face of a mesh light is interpolated, also where none arrives.
  if (truth == 0 && (baked <= kFar || kind != SurfaceKind::Mesh)) {
    ++(baked > kFar ? spills : dark);
    if (baked > kFar && spill.empty()) spill = fmt::format("{}: {} instead of none", at, baked);
    return;
  }
  const double error = baked - truth;
  if (std::abs(error) > sum().greatest)
    worst = fmt::format("{}: {:.1f} instead of {:.1f} +- {:.1f}", at, baked, truth, errorOfTruth);
  kinds[static_cast<std::size_t>(kind)].add(error, errorOfTruth);
}

AreaTally& AreaTally::operator+=(const AreaTally& other) {
  if (other.sum().greatest > sum().greatest || worst.empty()) worst = other.worst;
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] += other.kinds[i];
  levels += other.levels;
  slices += other.slices;
  samples += other.samples;
  dark += other.dark;
  spills += other.spills;
  if (spill.empty()) spill = other.spill;
  return *this;
}

Errors AreaTally::sum() const {
  Errors all;
  for (const Errors& kind : kinds) all += kind;
  return all;
}

std::string table(const AreaTally& tally) {
  std::string text = fmt::format("{:<18} {:>8} {:>8} {:>8} {:>8} {:>9}\n", "", "places", "RMS",
                                 "of bake", "over 4", "greatest");
  const auto add = [&text](std::string_view name, const Errors& errors) {
    if (errors.places == 0) return;
    text += fmt::format("{:<18} {:>8} {:>8.2f} {:>8.2f} {:>7.2f}% {:>9.1f}\n", name, errors.places,
                        errors.rms(), errors.rmsOfBake(),
                        100 * static_cast<double>(errors.far) / static_cast<double>(errors.places),
                        errors.greatest);
  };
  for (std::size_t i = 0; i < kSurfaceKindCount; ++i)
    add(name(static_cast<SurfaceKind>(i)), tally.kinds[i]);
  add("all", tally.sum());
  return text +
         fmt::format("{} levels, {:.2f} slices a sample; {} dark places, {} spills\nworst: {}\n{}",
                     tally.levels,
                     static_cast<double>(tally.slices) /
                         static_cast<double>(std::max<std::int64_t>(1, tally.samples)),
                     tally.dark, tally.spills, tally.worst,
                     tally.spill.empty() ? "" : fmt::format("a spill: {}\n", tally.spill));
}

}  // namespace hearth::area_light
