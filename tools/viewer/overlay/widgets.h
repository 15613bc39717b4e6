#pragma once

#include <string>
#include <string_view>

/// What sections of the overlay are made of, besides ImGui's own.
namespace hearth {

/// The width of so many letters, in pixels.
float letters(float count);

void showText(const std::string& text);
/// The text in lines of at most so many pixels, broken at blanks: numbers and names stay whole,
/// even where they are wider.
std::string brokenAtBlanks(std::string_view text, float width);
/// Broken so at the panel's edge.
void showWrapped(std::string_view text);
/// While the pointer is on the last item, which may be disabled.
void showTip(const std::string& text);

struct SliderRange {
  double least;
  double most;
  double steps;  ///< from one whole number to the next
};

/// A line: what is chosen, the slider, and the value as `words` say, which no knob covers. Returns
/// whether the value has changed.
bool showSlider(const char* name, double& value, const SliderRange& range,
                const std::string& words);

}  // namespace hearth
