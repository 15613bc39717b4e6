#include "measure/tradeoff/trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "settings/approximations.h"
#include "settings/quality.h"

namespace hearth {

namespace {

struct Choice {
  Option setting;
  std::string_view value;
};
using Choices = std::vector<Choice>;

/// What is combined: a bake of the first with a frame of the second.
const std::array<Choices, 7> kBakeTrials{{
    {{Option::Texel, "0.5"}, {Option::SoftSamples, "0"}},
    {{Option::Texel, "0.25"}, {Option::SoftSamples, "0"}},
    {{Option::Texel, "0.25"}, {Option::Samples, "auto"}},
    {{Option::Texel, "0.0625"}, {Option::SoftSamples, "16"}},
    {{Option::Texel, "0.0625"}, {Option::Samples, "4"}},
    {{Option::Texel, "0.0625"}, {Option::Samples, "auto"}},
    {{Option::Texel, "0.03125"}, {Option::Samples, "auto"}},
}};
const std::array<Choices, 3> kFrameTrials{{
    {},
    {{Option::LightFilter, "nearest"}},
    {{Option::PixelSize, "2"}},
}};

class Trials {
 public:
  Trials(const Scene& scene, const OptionValues& values) : scene_(scene), values_(values) {}

  /// Returns what is wrong with the settings, or nothing. Those that were tried are left out.
  std::optional<std::string> add(const Choices& choices) {
    OptionValues values = values_;
    std::string options;
    for (const auto& [setting, value] : choices) {
      values.set(setting, std::string(value));
      options += fmt::format("{}{} {}", options.empty() ? "" : " ", row(setting).name, value);
    }
    const auto bake = bakeSettingsFor(scene_, values);
    if (!bake) return bake.error();
    const Trial trial{std::move(options), *bake, drawSettingsFrom(values)};
    const auto isTrial = [&](const Trial& other) {
      return other.bake == trial.bake && other.draw == trial.draw;
    };
    if (std::ranges::none_of(trials_, isTrial)) trials_.push_back(trial);
    return std::nullopt;
  }

  std::vector<Trial> taken() { return std::move(trials_); }

 private:
  Scene scene_;
  const OptionValues& values_;
  std::vector<Trial> trials_;
};

std::vector<Choices> allChoices() {
  std::vector<Choices> all{{}};
  for (const Quality& quality : qualities()) all.push_back({{Option::Quality, quality.name}});
  for (const Approximation& approximation : approximations()) {
    // The pictures of truth have no light of areas: see area_trials.h.
    if (approximation.setting == Option::GatherError) continue;
    for (const std::string_view value : triedOf(approximation))
      all.push_back({{approximation.setting, value}});
  }
  for (const Choices& bake : kBakeTrials)
    for (const Choices& frame : kFrameTrials) {
      all.push_back(bake);
      all.back().insert(all.back().end(), frame.begin(), frame.end());
    }
  return all;
}

}  // namespace

tl::expected<std::vector<Trial>, std::string> trialsFor(const Scene& scene,
                                                        const OptionValues& values) {
  Trials trials(scene, values);
  for (const Choices& choices : allChoices())
    if (const auto mistake = trials.add(choices)) return tl::unexpected(*mistake);
  return trials.taken();
}

}  // namespace hearth
