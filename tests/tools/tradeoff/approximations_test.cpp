#include "settings/approximations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "../loaded.h"
#include "cli/command.h"
#include "render/renderer.h"
#include "settings/measured_settings.h"
#include "settings/mover_light.h"
#include "settings/settings.h"

namespace hearth {
namespace {

TEST(Approximations, areAllSettingsOfBakesAndFrames) {
  std::set<Option> settings;
  for (const Approximation& approximation : approximations())
    settings.insert(approximation.setting);
  EXPECT_EQ(settings.size(), approximations().size()) << "each once";
  for (const Option option : drawOptions())
    EXPECT_TRUE(settings.contains(option)) << row(option).name;
  // What light is, and not how nearly it is found.
  const std::set<Option> others{Option::Bounces, Option::Lambert, Option::NoLambert,
                                Option::Threads};
  for (const Option option : settingOptions())
    EXPECT_NE(settings.contains(option), others.contains(option)) << row(option).name;
}

TEST(Approximations, areTriedWithValuesThatTheirOptionsTake) {
  for (const Approximation& approximation : approximations())
    for (const std::string_view value : triedOf(approximation))
      EXPECT_EQ(mistakeIn(row(approximation.setting), std::string(value)), std::nullopt)
          << row(approximation.setting).name << ' ' << value;
}

std::string defaultOf(const Approximation& approximation) {
  switch (approximation.of) {
    case Approximation::Of::Bake:
      return valueOf(BakeSettings{}, approximation.setting);
    case Approximation::Of::Frame:
      return valueOf(DrawSettings{}, approximation.setting);
    case Approximation::Of::Movers:
      return valueOf(MoverLightSettings{}, approximation.setting);
  }
  return "";
}

TEST(MeasuredSettings, areAllValuesThatAreTried) {
  for (const Approximation& approximation : approximations())
    for (const std::string_view value : triedOf(approximation))
      EXPECT_TRUE(measuredAlone(approximation.setting, value))
          << row(approximation.setting).name << ' ' << value << ": see tools/measure_settings.py";
}

TEST(MeasuredSettings, areHeldAgainstTheDefaults) {
  for (const Approximation& approximation : approximations()) {
    const MeasuredSetting* own = measuredAlone(approximation.setting, defaultOf(approximation));
    ASSERT_TRUE(own) << row(approximation.setting).name;
    EXPECT_EQ(own->cost, 1) << row(approximation.setting).name;
  }
}

TEST(MeasuredSettings, areOfValuesThatTheirOptionsTakeEachOnce) {
  std::set<std::pair<Option, std::string_view>> seen;
  for (const MeasuredSetting& of : measuredSettings()) {
    EXPECT_EQ(mistakeIn(row(of.setting), std::string(of.value)), std::nullopt) << of.value;
    EXPECT_TRUE(seen.insert({of.setting, of.value}).second) << of.value;
    EXPECT_GT(of.cost, 0) << of.value;
    EXPECT_GT(of.off, 0) << of.value;
  }
}

/// A shipped level in coarse light, as its settings leave it.
class ShippedLevel {
 public:
  explicit ShippedLevel(const std::string& path) : loaded_(loaded(path)) {
    base_.set(Option::Texel, "0.5");
    light_ = bakeWith(base_);
    for (const Image& picture : picturesOf(light_, {})) pictures_.push_back(picture);
  }

  bool isChangedBy(const Approximation& approximation, std::string_view value) const {
    OptionValues values = base_;
    values.set(approximation.setting, std::string(value));
    if (approximation.of == Approximation::Of::Frame)
      return picturesOf(light_, drawSettingsFrom(values)) != pictures_;
    return picturesOf(bakeWith(values), {}) != pictures_;
  }

 private:
  BakedLight bakeWith(const OptionValues& values) const {
    return bake(loaded_.scene(), bakeSettingsFor(loaded_.scene(), values).value(), 2);
  }

  std::vector<Image> picturesOf(const BakedLight& light, const DrawSettings& settings) const {
    const Renderer renderer(loaded_.scene(), loaded_.textures, light, settings);
    std::vector<Image> pictures;
    for (const Shot& shot : loaded_.level.shots)
      pictures.push_back(renderer.draw(cameraOf(shot), LightMode::Both));
    return pictures;
  }

  LoadedLevel loaded_;
  OptionValues base_;
  BakedLight light_;
  std::vector<Image> pictures_;
};

TEST(Approximations, eachChangeWhatIsSeenOfAShippedLevel) {
  const ShippedLevel tutorial("levels/tutorial.json");
  const ShippedLevel gaol("levels/gaol.json");
  for (const Approximation& approximation : approximations()) {
    if (approximation.of == Approximation::Of::Movers) continue;  // of which these have none
    const auto tried = triedOf(approximation);
    EXPECT_TRUE(std::ranges::any_of(tried, [&](std::string_view value) {
      return tutorial.isChangedBy(approximation, value) || gaol.isChangedBy(approximation, value);
    })) << row(approximation.setting).name;
  }
}

}  // namespace
}  // namespace hearth
