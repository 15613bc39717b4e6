// The section that lets choose how accurately a walk is lit and drawn.

#include "settings/quality.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

#include "settings/approximations.h"
#include "settings/settings.h"
#include "support/canvas.h"
#include "viewer/overlay/overlay.h"
#include "viewer/overlay/quality_section.h"
#include "walk/stage.h"

namespace hearth {
namespace {

constexpr int kPadding = 8;            // pixels, of the panel
constexpr int kLetter = 7;             // its width
constexpr int kSlider = 17 * kLetter;  // where it begins

/// A panel with this section alone, and a hand that clicks into it.
class QualityTest : public testing::Test {
 protected:
  QualityTest() {
    overlay_.toggle();
    frame();
    left_ = overlay_.widthBeside(picture_.width()) + kPadding;
  }

  void frame() {
    const BakeSettings authored;
    Level level;
    level.bake = authored;
    const Geometry geometry{};
    const EffectiveSettings effective{
        authored, bakeSettingsFrom({level, geometry}, choice_.options),
        drawSettingsFrom(choice_.options), moverLightFrom(choice_.options), canBake_};
    overlay_.draw(
        now_ += 0.02, [&] { wasChosen_ |= showQuality(effective, choice_); }, picture_);
  }

  void button(bool isDown, int x, int y) {
    overlay_.handle(isDown ? test::pressAt(x, y) : test::releaseAt(x, y));
    frame();
    frame();
  }
  void click(int x, int y) {
    button(true, x, y);
    button(false, x, y);
  }

  /// Opens whatever list there is, row by row, and takes its first value or, if that is the
  /// current one, the next.
  std::set<Option> chosenFromLists() {
    std::set<Option> chosen;
    for (int y = kPadding; y < 420; y += 11)
      for (const int below : {26, 43}) {
        const OptionValues before = choice_.options;
        click(left_ + 20 * kLetter, y);
        click(left_ + 20 * kLetter, y + below);
        click(left_ - 100, 10);  // which closes what is still open
        for (const Approximation& approximation : approximations())
          if (choice_.options.text(approximation.setting) != before.text(approximation.setting))
            chosen.insert(approximation.setting);
      }
    return chosen;
  }

  Overlay overlay_;
  test::Canvas picture_{700, 900};
  QualityChoice choice_;
  bool canBake_ = true;
  bool wasChosen_ = false;
  int left_ = 0;
  double now_ = 1;
};

TEST(QualityOptions, OfAQualityTakeThePlaceOfSingleOnes) {
  OptionValues options;
  options.set(Option::PixelSize, "3");
  options.set(Option::Texel, "0.5");
  options.set(Option::Threads, "2");
  chooseQuality(options, "high");
  EXPECT_EQ(options.text(Option::Quality), "high");
  EXPECT_FALSE(options.has(Option::PixelSize));
  EXPECT_FALSE(options.has(Option::Texel));
  EXPECT_TRUE(options.has(Option::Threads)) << "how, not what";
}

TEST(QualityInWords, SaysWhatEachQualityWasMeasuredToCost) {
  const auto words = [](std::string_view name) {
    const Quality& quality = *qualityNamed(name);
    const EffectiveSettings effective{{}, quality.bake.appliedTo({}), quality.draw, {}, true};
    return bakeInWords(effective, {}) + "; " + framesInWords(effective);
  };
  EXPECT_EQ(words("draft"),
            "0.16 x the time, 8.5 levels off; 0.64 x the time, 62 % of pixels differ");
  EXPECT_EQ(words("normal"), "as the level says; 1 x the time, 7.3 % of pixels differ");
  EXPECT_EQ(words("high"), "2.9 x the time, 4 levels off; 1 x the time, 7.3 % of pixels differ");
  EXPECT_EQ(words("reference"),
            "24 x the time, 2.5 levels off; 1 x the time, 7.3 % of pixels differ");
}

TEST(QualityInWords, SaysThatLightIsFromAFile) {
  OptionValues options;
  options.set(Option::LightFrom, "x.bake");
  EXPECT_EQ(bakeInWords({{}, {}, {}, {}, false}, options), "from a file");
  EXPECT_EQ(bakeInWords({{}, {}, {}, {}, false}, {}), "as the level says") << "as in a replay";
}

TEST_F(QualityTest, IsChosenByAClick) {
  choice_.options.set(Option::PixelSize, "4");
  for (int y = kPadding; y < 200 && !wasChosen_; y += 6) click(left_ + 5, y);
  EXPECT_EQ(choice_.options.text(Option::Quality), "draft");
  EXPECT_FALSE(choice_.options.has(Option::PixelSize));
}

TEST_F(QualityTest, LetsChooseEverySettingOfTheTable) {
  std::set<Option> all;
  for (const Approximation& approximation : approximations()) all.insert(approximation.setting);
  EXPECT_EQ(chosenFromLists(), all);
  EXPECT_TRUE(wasChosen_);
}

TEST_F(QualityTest, LeavesLightThatCannotBeBakedAsItIs) {
  canBake_ = false;
  std::set<Option> ofFrames;
  for (const Approximation& approximation : approximations())
    if (approximation.of == Approximation::Of::Frame) ofFrames.insert(approximation.setting);
  EXPECT_EQ(chosenFromLists(), ofFrames);
}

TEST_F(QualityTest, HasSlidersForFieldOfViewAndFrameCap) {
  const auto drag = [this](int from, int y, int to) {
    button(true, from, y);
    button(true, to, y);  // still held, elsewhere
    button(false, to, y);
  };
  std::set<double> fovs;
  std::set<double> caps;
  for (const int y : {kPadding + 10, kPadding + 33})
    for (const int to : {0, picture_.width()}) {
      drag(left_ + kSlider, y, to);
      fovs.insert(choice_.fov);
      caps.insert(choice_.frameCap);
    }
  EXPECT_EQ(*fovs.begin(), 10);
  EXPECT_EQ(*fovs.rbegin(), 170);
  EXPECT_EQ(*caps.begin(), 0);
  EXPECT_EQ(*caps.rbegin(), 240);
}

}  // namespace
}  // namespace hearth
