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

std::int64_t Tally::leastTested() const {
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

}  // namespace

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
      "{} shadow's edge between texels, {} jump or sharp bend of a curve between texels, "
      "{} clipping at full between texels, "
      "{} steep light at an edge beyond which texels are centred\n",
      tally.leftOut[0], tally.leftOut[1], tally.leftOut[2], tally.leftOut[3], tally.leftOut[4],
      tally.leftOut[5]);
  text += fmt::format("at edge because of a jump of a curve: {}\n", tally.atJumps);
  text += fmt::format("{} levels, {} views, {} holes\n", tally.levels, tally.views, tally.holes);
  return text;
}

}  // namespace hearth::agreement
