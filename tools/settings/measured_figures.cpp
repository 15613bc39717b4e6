#include "settings/measured_figures.h"

#include <algorithm>
#include <vector>

#include "settings/approximations.h"
#include "settings/measured_pareto_front.h"
#include "settings/measured_settings.h"
#include "settings/settings.h"

namespace hearth {

namespace {

/// The settings whose values differ.
template <typename Settings>
std::vector<Option> changedIn(const Settings& settings, const Settings& authored,
                              Approximation::Of of) {
  std::vector<Option> changed;
  for (const Approximation& approximation : approximations()) {
    const Option option = approximation.setting;
    if (approximation.of == of && valueOf(settings, option) != valueOf(authored, option))
      changed.push_back(option);
  }
  return changed;
}

/// Of settings of which at most one approximates in another way.
template <typename Settings>
std::optional<Figure> figureOfOne(const Settings& settings, const Settings& authored,
                                  Approximation::Of of) {
  const std::vector<Option> changed = changedIn(settings, authored, of);
  if (changed.size() != 1) return std::nullopt;
  return figureOf(changed.front(), valueOf(settings, changed.front()),
                  valueOf(authored, changed.front()));
}

}  // namespace

std::optional<Figure> figureOf(Option setting, std::string_view value, std::string_view authored) {
  const MeasuredSetting* const found = measuredAlone(setting, value);
  const MeasuredSetting* const own = measuredAlone(setting, authored);
  if (!found || !own) return std::nullopt;
  return Figure{found->cost / own->cost, found->off};
}

std::optional<Figure> figureOf(const BakeSettings& bake, const BakeSettings& authored) {
  if (bake.lambert != authored.lambert || bake.bounces != authored.bounces) return std::nullopt;
  if (const auto figure = figureOfOne(bake, authored, Approximation::Of::Bake)) return figure;
  const auto found = std::ranges::find_if(measuredBakes(), [&](const MeasuredBake& measured) {
    return measured.bake.appliedTo(authored) == bake;
  });
  if (found == measuredBakes().end()) return std::nullopt;
  return Figure{found->cost, found->rms};
}

std::optional<Figure> figureOf(const DrawSettings& draw) {
  if (const auto figure = figureOfOne(draw, DrawSettings{}, Approximation::Of::Frame))
    return figure;
  const auto found = std::ranges::find(measuredFrames(), draw, &MeasuredFrame::draw);
  if (found == measuredFrames().end()) return std::nullopt;
  return Figure{found->cost, found->over2};
}

}  // namespace hearth
