#include "agreement/tally.h"

#include <fmt/format.h>

#include <algorithm>

namespace hearth::agreement {

Count& Count::operator+=(const Count& other) {
  tested += other.tested;
  missed += other.missed;
  excused += other.excused;
  return *this;
}

KindTally& KindTally::operator+=(const KindTally& other) {
  texture += other.texture;
  gridLight += other.gridLight;
  exactLight += other.exactLight;
  return *this;
}

Tally& Tally::operator+=(const Tally& other) {
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] += other.kinds[i];
  for (std::size_t i = 0; i < kLeftOut; ++i) leftOut[i] += other.leftOut[i];
  levels += other.levels;
  views += other.views;
  holes += other.holes;
  atJumps += other.atJumps;
  asked += other.asked;
  clear += other.clear;
  lightAsked += other.lightAsked;
  if (firstMiss.empty()) firstMiss = other.firstMiss;
  return *this;
}

KindTally Tally::sum() const {
  KindTally sum;
  for (const KindTally& kind : kinds) sum += kind;
  return sum;
}

std::int64_t Tally::missed() const {
  const KindTally all = sum();
  return all.texture.missed + all.gridLight.missed + all.exactLight.missed;
}

std::int64_t Tally::minTested() const {
  return std::ranges::min(kinds, {}, [](const KindTally& k) { return k.texture.tested; })
      .texture.tested;
}

namespace {

std::string columns(const Count& count) {
  return fmt::format(" | {:>11} {:>8} {:>8}", count.tested, count.excused, count.missed);
}

std::string row(std::string_view name, const KindTally& kind) {
  return fmt::format("{:<17}{}{}{}\n", name, columns(kind.texture), columns(kind.gridLight),
                     columns(kind.exactLight));
}

double fraction(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

struct FractionName {
  std::string_view name;
  double Fractions::*fraction;
};
constexpr std::array kTestedFractions = {
    FractionName{"clear of edges", &Fractions::clear},
    FractionName{"light at texels tested", &Fractions::gridTested},
    FractionName{"exact light tested", &Fractions::exactTested}};
constexpr std::array kExcusedFractions = {
    FractionName{"texture excused", &Fractions::textureExcused},
    FractionName{"light at texels excused", &Fractions::gridExcused},
    FractionName{"exact light excused", &Fractions::exactExcused}};

}  // namespace

Fractions fractionsOf(const Tally& tally) {
  const KindTally all = tally.sum();
  return {.clear = fraction(tally.clear, tally.asked),
          .gridTested = fraction(all.gridLight.tested, tally.lightAsked),
          .exactTested = fraction(all.exactLight.tested, tally.lightAsked),
          .textureExcused = fraction(all.texture.excused, all.texture.tested + all.texture.excused),
          .gridExcused = fraction(all.gridLight.excused, tally.lightAsked),
          .exactExcused = fraction(all.exactLight.excused, tally.lightAsked)};
}

std::string beyond(const Fractions& bounds, const Fractions& fractions) {
  std::string text;
  const auto add = [&](const FractionName& of, std::string_view wanted) {
    text += fmt::format("{}: {:.6f}, but {} {} is wanted\n", of.name, fractions.*of.fraction,
                        wanted, bounds.*of.fraction);
  };
  for (const FractionName& of : kTestedFractions)
    if (fractions.*of.fraction < bounds.*of.fraction) add(of, "at least");
  for (const FractionName& of : kExcusedFractions)
    if (fractions.*of.fraction > bounds.*of.fraction) add(of, "at most");
  return text;
}

std::string table(const Tally& tally) {
  std::string text = fmt::format("{:<17} | {:^29} | {:^29} | {:^29}\n", "", "texture, exact",
                                 "light at texels, +-1", "exact light, +-3");
  text += fmt::format("{:<17}", "surface");
  for (int i = 0; i < 3; ++i)
    text += fmt::format(" | {:>11} {:>8} {:>8}", "tested", "at edge", "missed");
  text += '\n';
  for (std::size_t i = 0; i < tally.kinds.size(); ++i)
    text += row(name(static_cast<SurfaceKind>(i)), tally.kinds[i]);
  text += row("all", tally.sum());
  text += fmt::format(
      "left out of exact light: {} texel over 1/8 m, {} light nearer than 0.3 m (0.7 m with "
      "lambert), "
      "{} samples inside a mesh or in a wall, "
      "{} shadow's edge between texels, {} jump or sharp bend of a curve or spot between texels, "
      "{} clipping at full between texels, "
      "{} steep light at an edge beyond which texels are centred\n",
      tally.leftOut[0], tally.leftOut[1], tally.leftOut[2], tally.leftOut[3], tally.leftOut[4],
      tally.leftOut[5], tally.leftOut[6]);
  const Fractions fractions = fractionsOf(tally);
  for (const auto& list : {kTestedFractions, kExcusedFractions})
    for (const FractionName& of : list)
      text += fmt::format("{}: {:.6f}\n", of.name, fractions.*of.fraction);
  text += fmt::format("at edge because of a jump of a curve or spot: {}\n", tally.atJumps);
  text += fmt::format("{} levels, {} views, {} holes\n", tally.levels, tally.views, tally.holes);
  return text;
}

}  // namespace hearth::agreement
