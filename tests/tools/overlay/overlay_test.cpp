// The panel over a picture: how it takes events, and what it shows.

#include "viewer/overlay/overlay.h"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "settings/channels.h"
#include "settings/options.h"
#include "support/canvas.h"
#include "viewer/overlay/figures_section.h"
#include "viewer/overlay/view_section.h"
#include "walk/stage.h"

namespace hearth {
namespace {

constexpr Rgb kGrey = {90, 90, 90};

void showNothing() {}

TEST(OverlayTest, HasLettersOfWholeTimesTheirSize) {
  EXPECT_EQ(letterScale(1), 1);
  EXPECT_EQ(letterScale(720), 1);
  EXPECT_EQ(letterScale(1080), 1);
  EXPECT_EQ(letterScale(1440), 2);
  EXPECT_EQ(letterScale(2160), 3);
}

TEST(OverlayTest, TakesNothingWhileItIsClosed) {
  Overlay overlay;
  EXPECT_FALSE(overlay.handle(test::motion(3, 3)));
  EXPECT_FALSE(overlay.handle(test::pressAt(1, 1)));
  EXPECT_FALSE(overlay.handle(TypedText{"w"}));
  EXPECT_FALSE(overlay.isStale(1e9));
}

TEST(OverlayTest, TakesTheMouseAndLeavesTheKeys) {
  Overlay overlay;
  overlay.toggle();
  test::Canvas picture(640, 400);
  overlay.draw(1, showNothing, picture);
  EXPECT_TRUE(overlay.handle(test::motion(3, 3)));
  EXPECT_TRUE(overlay.handle(test::pressAt(1, 1)));
  EXPECT_FALSE(overlay.handle(test::down(Key::W)));
  EXPECT_FALSE(overlay.handle(test::up(Key::W)));
  EXPECT_FALSE(overlay.handle(WindowEvent::FocusLost));
}

TEST(OverlayTest, KeepsWhatIsTypedIntoAFieldForItself) {
  Overlay overlay;
  overlay.toggle();
  std::array<char, 32> field{};
  auto frame = [&, now = 1.0]() mutable {
    test::Canvas picture(640, 400);
    const auto section = [&field] {
      ImGui::SetNextItemWidth(100);
      ImGui::InputText("field", field.data(), field.size());
    };
    overlay.draw(now += 0.02, section, picture);
  };
  frame();
  const int left = overlay.widthBeside(640);
  overlay.handle(test::pressAt(left + 20, 15));
  overlay.handle(test::releaseAt(left + 20, 15));  // before any frame saw it held
  for (int i = 0; i < 3; ++i) frame();
  EXPECT_TRUE(overlay.handle(test::down(Key::H)));
  EXPECT_TRUE(overlay.handle(TypedText{"hi"}));
  EXPECT_FALSE(overlay.handle(test::up(Key::H))) << "no key is to stay held in the walk";
  EXPECT_FALSE(overlay.handle(test::down(Key::F1)))
      << "F1 closes the panel also from a field of text";
  frame();
  EXPECT_STREQ(field.data(), "hi");
  overlay.toggle();
  overlay.toggle();
  frame();
  overlay.handle(test::down(Key::Backspace));
  frame();
  EXPECT_STREQ(field.data(), "h");
  overlay.handle(WindowEvent::FocusLost);
  for (int i = 0; i < 50; ++i) frame();  // a key that was let go of does not repeat
  EXPECT_STREQ(field.data(), "h");
}

TEST(OverlayTest, IsDrawnAtTheRightAndNowhereElse) {
  Overlay overlay;
  overlay.toggle();
  test::Canvas picture(1280, 720, kGrey);
  overlay.draw(1, showNothing, picture);
  const int left = overlay.widthBeside(1280);
  EXPECT_GT(left, 1280 / 2);
  for (int y = 0; y < 720; ++y) {
    for (int x = 0; x < left; ++x) ASSERT_EQ(picture.at(x, y), kGrey) << x << ',' << y;
    for (int x = left; x < 1280; ++x) ASSERT_NE(picture.at(x, y), kGrey) << x << ',' << y;
  }
}

TEST(OverlayTest, ShowsInPicturesOfAnySize) {
  Overlay overlay;
  overlay.toggle();
  double now = 1;
  for (const auto& [width, height] :
       {ImageSize{1, 1}, {3, 900}, {900, 3}, {320, 200}, {3840, 2160}, {640, 400}}) {
    test::Canvas around(width + 2, height + 2, kGrey);
    const PixelRows& rows = around;
    const PixelRows picture = rows.part(1, 1, width, height);
    overlay.draw(
        now += 0.1, [] { showFigures({}); }, picture);
    EXPECT_NE(imageOf(picture), Image(width, height, kGrey));
    picture.fill(kGrey);
    EXPECT_EQ(around.image(), Image(width + 2, height + 2, kGrey)) << "nothing beside it";
  }
}

TEST(OverlayTest, IsStaleAfterAnEventAndFourTimesASecond) {
  Overlay overlay;
  overlay.toggle();
  test::Canvas picture(320, 200);
  for (int i = 0; i < 10; ++i) overlay.draw(1, showNothing, picture);
  EXPECT_FALSE(overlay.isStale(1.2));
  EXPECT_TRUE(overlay.isStale(1.25));
  EXPECT_TRUE(overlay.isStale(0)) << "the clock was set back";
  overlay.handle(test::motion(1, 1));
  EXPECT_TRUE(overlay.isStale(1));
}

TEST(ViewSectionTest, LetsChooseEveryChannelAndEveryMode) {
  Overlay overlay;
  overlay.toggle();
  LightMode mode = LightMode::Both;
  std::string_view channel;
  std::set<LightMode> modes;
  std::set<std::string_view> channels;
  auto click = [&, now = 1.0](int x, int y) mutable {
    for (const Event& event : test::clickAt(x, y)) {
      overlay.handle(event);
      for (int i = 0; i < 2; ++i) {
        test::Canvas picture(500, 300);
        overlay.draw(
            now += 0.02, [&] { showView(mode, channel); }, picture);
      }
    }
    if (channel.empty()) modes.insert(mode);
    channels.insert(channel);
  };
  click(400, 17);  // the first picture, in which nothing is laid out yet
  for (int y = 10; y < 260; y += 11)
    for (int x = 50; x < 480; x += 16) click(x, y);
  EXPECT_EQ(modes.size(), 3);
  std::set<std::string_view> all = {""};
  for (const std::string_view name : split(row(Option::Channel).value, '|')) all.insert(name);
  EXPECT_EQ(channels, all);
}

TEST(Channels, AreThoseOfTheOptionWithAText) {
  std::vector<std::string_view> names;
  for (const ChannelText& text : channelTexts()) {
    names.push_back(text.name);
    EXPECT_FALSE(text.shows.empty()) << text.name;
    EXPECT_EQ(isGeometry(text.name), text.kind == ChannelKind::Geometry);
  }
  EXPECT_EQ(names, split(row(Option::Channel).value, '|'));
  EXPECT_FALSE(isGeometry(""));
}

// --- Figures -------------------------------------------------------------------------------------

TEST(FrameHistoryTest, KeepsTheLastFrames) {
  FrameHistory frames;
  EXPECT_EQ(frames.size(), 0);
  for (int i = 0; i < 250; ++i) {
    frames.add({.find = static_cast<double>(i)});
    EXPECT_EQ(frames.at(frames.size() - 1).find, i);
  }
  ASSERT_EQ(frames.size(), FrameHistory::kMax);
  EXPECT_EQ(frames.at(0).find, 50);
}

TEST(FiguresTest, HaveAScaleOfARoundTime) {
  EXPECT_EQ(scaleFor(0), 1e-3);
  EXPECT_EQ(scaleFor(1e-3), 1e-3);
  EXPECT_EQ(scaleFor(1.1e-3), 2e-3);
  EXPECT_EQ(scaleFor(2.1e-3), 5e-3);
  EXPECT_NEAR(scaleFor(0.0051), 0.01, 1e-12);
  EXPECT_NEAR(scaleFor(17), 20, 1e-9);
  EXPECT_EQ(scaleFor(NAN), 1e-3);
}

TEST(FiguresTest, HaveABarWhosePartsAreAsHighAsTheyTookLong) {
  Overlay overlay;
  overlay.toggle();
  Figures figures;
  figures.frames.add({.find = 4e-3, .paint = 3e-3, .cover = 1e-3, .show = 2e-3});  // of 10 ms
  test::Canvas picture(1280, 720);
  for (int i = 0; i < 3; ++i)
    overlay.draw(
        1 + i, [&] { showFigures(figures); }, picture);
  // The newest bar ends where the panel's padding of 8 pixels begins.
  const auto heightOf = [&](Rgb color) {
    int height = 0;
    for (int y = 0; y < picture.height(); ++y)
      if (picture.at(1280 - 9, y) == color) ++height;
    return height;
  };
  const double graph = 4 * 13;
  EXPECT_NEAR(heightOf({96, 160, 255}), 0.4 * graph, 1);
  EXPECT_NEAR(heightOf({112, 208, 112}), 0.3 * graph, 1);
  EXPECT_NEAR(heightOf({255, 200, 80}), 0.1 * graph, 1);
  EXPECT_NEAR(heightOf({160, 128, 128}), 0.2 * graph, 1);
}

}  // namespace
}  // namespace hearth
