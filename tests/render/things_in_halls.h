#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/renderer.h"
#include "support/level_text.h"

/// Rooms of one colour in which tests look at sprites and meshes.
namespace hearth::test {

inline constexpr int kSize = 64;  ///< pixels each way: 32 for each metre at a depth of one
inline constexpr Rgb kWall = {128, 128, 128};
inline constexpr Rgb kRed = {200, 0, 0};
inline constexpr Rgb kGreen = {0, 200, 0};

/// A fully bright level of these sectors and things.
LoadedLevel levelWith(std::string_view things, std::string_view sectors,
                      const std::vector<NamedText>& others = {});

/// From x = 0 to 8 and y = -4 to 4, 4 m high.
std::string hall();
/// The same hall, divided at x = 4. What follows in the opening's wall on either side may be given.
std::string halves(std::string_view west = "", std::string_view east = "");

/// 2 m above the floor of the first sector.
Camera lookingEast(double x = 0.5);

Image drawn(const LoadedLevel& loaded, const Camera& camera, LightMode mode = LightMode::Both,
            DrawSettings settings = {});

/// Pixels of a colour.
int count(const Image& picture, Rgb color);

}  // namespace hearth::test
