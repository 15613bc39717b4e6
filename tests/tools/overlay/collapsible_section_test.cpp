// A section that is brought into view when it is called.

#include "viewer/overlay/collapsible_section.h"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include "support/canvas.h"
#include "viewer/overlay/overlay.h"

namespace hearth {
namespace {

TEST(CollapsibleSection, IsOpenedAndScrolledToTheTop) {
  Overlay overlay;
  overlay.toggle();
  test::Canvas picture(700, 400);
  CollapsibleSection section;
  bool closes = false;
  bool isOpen = false;
  float top = 0;
  const auto frame = [&] {
    const auto lines = [] {
      for (int i = 0; i < 60; ++i) ImGui::TextUnformatted("line");
    };
    overlay.draw(
        1,
        [&] {
          lines();
          top = ImGui::GetCursorScreenPos().y;
          if (closes) ImGui::SetNextItemOpen(false);
          isOpen = section.show("section");
          if (isOpen) lines();
        },
        picture);
  };
  frame();
  EXPECT_TRUE(isOpen) << "at first";
  closes = true;
  frame();
  closes = false;
  frame();
  EXPECT_FALSE(isOpen);
  EXPECT_GT(top, 400);
  section.reveal();
  EXPECT_TRUE(section.isRevealed());
  for (int i = 0; i < 4; ++i) frame();
  EXPECT_FALSE(section.isRevealed());
  EXPECT_TRUE(isOpen);
  EXPECT_GE(top, 0);
  EXPECT_LT(top, 30);
}

}  // namespace
}  // namespace hearth
