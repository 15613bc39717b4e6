#pragma once

#include <string_view>

/// OBJ models.
namespace hearth::test {

/// A cube of 1 m each way, its origin in the middle of its bottom.
inline constexpr std::string_view kBoxModel =
    "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\n"
    "v -0.5 1 -0.5\nv 0.5 1 -0.5\nv 0.5 1 0.5\nv -0.5 1 0.5\n"
    "f 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 8 7 6 5\nf 1 2 3 4\n";

/// A square of 1 m that stands upright across the x axis, its origin in the middle of its bottom.
inline constexpr std::string_view kPanelModel =
    "v 0 0 0.5\nv 0 0 -0.5\nv 0 1 -0.5\nv 0 1 0.5\nf 1 2 3 4\n";

}  // namespace hearth::test
