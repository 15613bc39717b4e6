#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lint/lint.h"

namespace hearth::test {

/// A function of hearth/lint/lint.h that needs no bake.
using GeometryLint = void (*)(const LintedLevel&, Findings&);

/// Findings, each as `LINE:COLUMN /json/pointer [kind]`.
using Places = std::vector<std::string>;

/// What it finds in a level. Single quotes in the text may stand for double ones.
Places placesOf(GeometryLint lint, std::string_view levelText);

/// What is found in the light of a level, likewise.
Places placesInLight(std::string_view levelText, std::string_view lightsText);

/// The message that belongs to the first of them.
std::string firstMessage(GeometryLint lint, std::string_view levelText);

/// The advice of each of them.
std::vector<std::string> advicesOf(GeometryLint lint, std::string_view levelText);

/// A text with one part of it, which must be there just once, replaced.
std::string with(std::string_view text, std::string_view part, std::string_view replacement);

}  // namespace hearth::test
