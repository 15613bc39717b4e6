// What sections are made of.

#include "viewer/overlay/widgets.h"

#include <gtest/gtest.h>

#include "support/canvas.h"
#include "viewer/overlay/overlay.h"

namespace hearth {
namespace {

TEST(Widgets, BreakTextAtBlanksAlone) {
  Overlay overlay;
  overlay.toggle();
  test::Canvas picture(700, 400);
  const auto broken = [&](std::string_view text, float count) {
    std::string lines;
    overlay.draw(
        1, [&] { lines = brokenAtBlanks(text, letters(count)); }, picture);
    return lines;
  };
  EXPECT_EQ(broken("at 7.499, 6, 0.695: raise it", 12), "at 7.499, 6,\n0.695: raise\nit");
  EXPECT_EQ(broken("at 7.499, 6, 0.695: raise it", 11), "at 7.499,\n6, 0.695:\nraise it");
  EXPECT_EQ(broken("12.345,67.891,0.125 m", 5), "12.345,67.891,0.125\nm");
  EXPECT_EQ(broken("short", 5), "short");
  EXPECT_EQ(broken("", 5), "");
}

}  // namespace
}  // namespace hearth
