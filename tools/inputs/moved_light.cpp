#include "inputs/moved_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "light/blended_light.h"
#include "load/suggest.h"
#include "settings/mover_light.h"
#include "settings/settings.h"

namespace hearth {

namespace {

tl::expected<std::size_t, std::string> moverNamed(const Level& level, std::string_view name) {
  const auto found = std::ranges::find(level.movers, name, &Mover::name);
  if (found != level.movers.end()) return static_cast<std::size_t>(found - level.movers.begin());
  if (level.movers.empty()) return tl::unexpected<std::string>("--mover: the level has no movers");
  std::vector<std::string_view> names;
  for (const Mover& mover : level.movers) names.push_back(mover.name);
  return tl::unexpected(fmt::format("--mover: the level has no mover \"{}\"; {}", name,
                                    suggest(name, names, "`hearth info` lists them")));
}

/// From NAME=SHARE; a name may have a "=", too.
tl::expected<MoverShare, std::string> moverShareFrom(const Level& level, std::string_view text) {
  const std::size_t sign = text.rfind('=');
  const auto share =
      sign == std::string_view::npos ? std::nullopt : parseNumbers(text.substr(sign + 1));
  if (!share || share->size() != 1 || !(share->front() >= 0 && share->front() <= 1))
    return tl::unexpected(
        fmt::format("--mover: \"{}\" is not NAME=SHARE with a share from 0 to 1", text));
  return moverNamed(level, text.substr(0, sign)).map([&](std::size_t mover) {
    return MoverShare{mover, share->front()};
  });
}

}  // namespace

std::vector<double> moverSharesOf(const Level& level, const Shot& shot) {
  std::vector<double> shares(level.movers.size());
  for (const auto& [mover, share] : shot.movers) shares[mover] = share;
  return shares;
}

tl::expected<std::vector<double>, std::string> moverSharesFor(const Level& level,
                                                              const OptionValues& values) {
  std::vector<double> shares(level.movers.size());
  if (const auto name = values.text(Option::Shot)) {
    const auto shot = std::ranges::find(level.shots, *name, &Shot::name);
    if (shot != level.shots.end()) shares = moverSharesOf(level, *shot);
  }
  for (const std::string& text : values.texts(Option::Mover)) {
    const auto given = moverShareFrom(level, text);
    if (!given) return tl::unexpected(given.error());
    shares[given->mover] = given->share;
  }
  return shares;
}

RestStates restStatesFor(std::span<const double> shares, const OptionValues& values) {
  return RestStates(shares, moverLightFrom(values).stages);
}

tl::expected<MovedLevel, std::string> loadedAt(const LoadedLevel& authored,
                                               const LevelSource& source,
                                               std::span<const double> shares,
                                               const OptionValues& values) {
  if (std::ranges::count(shares, 0.0) == std::ssize(shares)) return MovedLevel(authored);
  LoadResult result = levelAt(authored, source, shares, limitsFrom(values));
  if (result.loaded) return MovedLevel(*std::move(result.loaded));
  const auto error = std::ranges::find(result.diagnostics, true, &Diagnostic::isError);
  return tl::unexpected(fmt::format("with its movers so: {}", format(*error)));
}

tl::expected<BakedLight, std::string> MovedLight::at(const LoadedLevel& shown,
                                                     std::span<const double> shares) {
  const RestStates states = restStatesFor(shares, values_);
  if (states.count() == 1) return lightFor(shown.scene(), values_);
  std::vector<LightAtRest> lights;
  for (std::size_t i = 0; i < states.count(); ++i) {
    const auto rest = atRest(states.shares(i));
    if (!rest) return tl::unexpected(rest.error());
    lights.push_back({{authored_.level, (*rest)->geometry}, &(*rest)->light});
  }
  return blendedLight(shown.scene(), lights, states.weights(), threadsFrom(values_));
}

tl::expected<const MovedLight::AtRest*, std::string> MovedLight::atRest(
    const std::vector<double>& shares) {
  if (const auto found = rests_.find(shares); found != rests_.end()) return &found->second;
  const auto level = loadedAt(authored_, source_, shares, values_);
  if (!level) return tl::unexpected(level.error());
  auto light = lightFor((*level)->scene(), values_);
  if (!light) return tl::unexpected(light.error());
  const auto [rest, isNew] = rests_.emplace(shares, AtRest{(*level)->geometry, *std::move(light)});
  return &rest->second;
}

}  // namespace hearth
