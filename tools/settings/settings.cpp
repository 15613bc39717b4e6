#include "settings/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>

#include "light/bakery.h"
#include "math/check.h"
#include "settings/quality.h"

namespace hearth {

namespace {

struct NamedFilter {
  TextureFilter filter;
  std::string_view name;
};

constexpr std::array kTextureFilters = {NamedFilter{TextureFilter::Nearest, "nearest"},
                                        NamedFilter{TextureFilter::Bilinear, "bilinear"},
                                        NamedFilter{TextureFilter::Mipmapped, "mipmapped"}};

/// Without any, they are no setting.
bool hasMaskedMiddles(const Scene& scene) {
  return std::ranges::any_of(scene.shownSurfaces(), [&](SurfaceId surface) {
    return scene[surface].kind == SurfaceKind::MaskedMiddle;
  });
}

}  // namespace

BakeSettings bakeSettingsFrom(const Scene& scene, const OptionValues& values) {
  BakeSettings settings = qualityFrom(values).bake.appliedTo(scene.level().bake);
  settings.texel = values.number(Option::Texel).value_or(settings.texel);
  if (const auto samples = values.number(Option::Samples))
    settings.samples = static_cast<int>(*samples);
  else if (values.has(Option::Samples))
    settings.samples.reset();  // "auto"
  if (const auto softSamples = values.number(Option::SoftSamples))
    settings.softSamples = static_cast<int>(*softSamples);
  settings.cutOff = values.number(Option::CutOff).value_or(settings.cutOff);
  settings.gatherError = values.number(Option::GatherError).value_or(settings.gatherError);
  if (const auto shadows = values.text(Option::MiddleShadows))
    settings.solidMaskedMiddles = *shadows == "solid" && hasMaskedMiddles(scene);
  if (const auto bounces = values.number(Option::Bounces))
    settings.bounces = static_cast<int>(*bounces);
  if (values.has(Option::Lambert)) settings.lambert = true;
  if (values.has(Option::NoLambert)) settings.lambert = false;
  return settings;
}

tl::expected<BakeSettings, std::string> bakeSettingsFor(const Scene& scene,
                                                        const OptionValues& values) {
  if (values.has(Option::Lambert) && values.has(Option::NoLambert))
    return tl::unexpected<std::string>("give --lambert or --no-lambert, not both");
  const BakeSettings settings = bakeSettingsFrom(scene, values);
  if (const auto mistake = mistakeInSettings(scene, settings))
    return tl::unexpected(fmt::format("--{}", *mistake));  // the option of the setting's name
  return settings;
}

std::string valueOf(const BakeSettings& settings, Option option) {
  switch (option) {
    case Option::Texel:
      return fmt::to_string(settings.texel);
    case Option::Samples:
      return settings.samples ? fmt::to_string(*settings.samples) : "auto";
    case Option::SoftSamples:
      return fmt::to_string(settings.softSamples);
    case Option::CutOff:
      return fmt::to_string(settings.cutOff);
    case Option::GatherError:
      return fmt::to_string(settings.gatherError);
    case Option::Bounces:
      return fmt::to_string(settings.bounces);
    case Option::MiddleShadows:
      return settings.solidMaskedMiddles ? "solid" : "holes";
    default:
      CHECK(false, row(option).name);
      return "";
  }
}

std::string optionsOf(const BakeSettings& settings) {
  std::string options;
  for (const Option option : {Option::Texel, Option::Samples, Option::SoftSamples, Option::CutOff,
                              Option::GatherError, Option::Bounces})
    options += fmt::format("{} {} ", row(option).name, valueOf(settings, option));
  options += settings.lambert ? "--lambert" : "--no-lambert";
  return options + (settings.solidMaskedMiddles ? " --middle-shadows solid" : "");
}

std::string samplesInWords(const BakeSettings& settings) {
  if (!settings.samples) return "samples where shadows' edges need them";
  return fmt::format("{} sample(s) each", *settings.samples);
}

LoadLimits limitsFrom(const OptionValues& values) {
  LoadLimits limits;
  const auto take = [&](Option option, auto& limit) {
    if (const auto given = values.number(option))
      limit = static_cast<std::remove_reference_t<decltype(limit)>>(*given);
  };
  take(Option::MaxFileBytes, limits.fileBytes);
  take(Option::MaxImagePixels, limits.imagePixels);
  take(Option::MaxVertices, limits.vertices);
  take(Option::MaxGridCells, limits.gridCells);
  take(Option::MaxLights, limits.lights);
  take(Option::MaxSpriteImages, limits.spriteImages);
  take(Option::MaxMeshFaces, limits.meshFaces);
  return limits;
}

DrawSettings drawSettingsFrom(const OptionValues& values) {
  DrawSettings settings = qualityFrom(values).draw;
  if (const auto name = values.text(Option::TextureFilter))
    settings.textureFilter = std::ranges::find(kTextureFilters, *name, &NamedFilter::name)->filter;
  if (const auto filter = values.text(Option::LightFilter))
    settings.lightFilter = *filter == "nearest" ? LightFilter::Nearest : LightFilter::Bilinear;
  if (const auto size = values.number(Option::PixelSize))
    settings.pixelSize = static_cast<int>(*size);
  return settings;
}

std::string valueOf(const DrawSettings& settings, Option option) {
  switch (option) {
    case Option::TextureFilter:
      return std::string(
          std::ranges::find(kTextureFilters, settings.textureFilter, &NamedFilter::filter)->name);
    case Option::LightFilter:
      return settings.lightFilter == LightFilter::Nearest ? "nearest" : "bilinear";
    case Option::PixelSize:
      return fmt::to_string(settings.pixelSize);
    default:
      CHECK(false, row(option).name);
      return "";
  }
}

std::vector<Option> notStandard(const DrawSettings& settings) {
  std::vector<Option> options;
  for (const Option option : {Option::TextureFilter, Option::LightFilter, Option::PixelSize})
    if (valueOf(settings, option) != valueOf(DrawSettings{}, option)) options.push_back(option);
  return options;
}

std::string optionsOf(const DrawSettings& settings) {
  std::string options;
  for (const Option option : notStandard(settings))
    options += fmt::format("{}{} {}", options.empty() ? "" : " ", row(option).name,
                           valueOf(settings, option));
  return options;
}

}  // namespace hearth
