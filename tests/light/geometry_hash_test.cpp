// What a moved vertex changes and a new texture does not.

#include "light/geometry_hash.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "light/lit_surface.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr double kTexel = 0.125;  // metres

/// A hall with a stack, a sloped floor, and a sky over its yard; a cellar below the hall.
constexpr std::string_view kLevel = R"({
  "name": "all kinds", "light": 0.25,
  "player": {"sector": "hall", "x": 1, "y": 1, "z": 1.5},
  "sectors": {
    "hall": {
      "floor": {"z": 0, "next": "hall-cellar"}, "ceiling": {"z": 3, "texture": "#808080"},
      "loops": {
        "border": {"v": [0,0, 6,0, 6,4, 0,4], "walls": [
          {"texture": "#808080"},
          {"walls": [{"z": 1, "texture": "#808080"},
                     {"next": "yard", "texture": "#808080"}]},
          {"texture": "#808080"}, {"texture": "#808080"}]},
        "inner": {"v": [2,2, 2,3, 3,3, 3,2], "walls": {"texture": "#808080"}}}},
    "yard": {
      "floor": {"z": 0, "texture": "#808080"},
      "slopeFloor": {"z": [0, 0.5, 0.5, 0], "sidewall": "#808080"},
      "ceiling": {"z": 5, "texture": "#80a0ff", "parallax": true},
      "loops": {"border": {"v": [6,0, 10,0, 10,4, 6,4], "walls": [
        {"texture": "#808080"}, {"texture": "#808080"}, {"texture": "#808080"},
        {"next": "hall", "texture": "#808080"}]}}},
    "cellar": {
      "floor": {"z": -2, "texture": "#808080"}, "ceiling": {"z": 0, "next": "hall-cellar"},
      "loops": {
        "border": {"v": [0,0, 6,0, 6,4, 0,4], "walls": {"texture": "#808080"}},
        "inner": {"v": [2,2, 2,3, 3,3, 3,2], "walls": {"texture": "#808080"}}}}}})";

constexpr std::string_view kLights = R"([{"x": 1, "y": 1, "z": 2}])";

/// The level with the first `from` in its text replaced.
LoadedLevel with(std::string_view from, std::string_view to, std::string_view lights = kLights) {
  std::string text(kLevel);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return test::levelFrom(text.replace(at, from.size(), to), lights);
}

LoadedLevel original() { return with("all kinds", "all kinds"); }

TEST(GeometryHash, isTheSameOnEveryMachineAndInEveryBuild) {
  EXPECT_EQ(geometryHash(original().scene(), kTexel), 0xeddd8dbecbb26ea5U);
}

TEST(GeometryHash, doesNotKnowNamesTexturesAndLight) {
  const std::uint64_t hash = geometryHash(original().scene(), kTexel);
  for (const auto& [from, to] : {
           std::array<std::string_view, 2>{"all kinds", "other"},
           {R"("light": 0.25)", R"("light": 0.75)"},
           {R"("floor": {"z": -2)", R"("light": 0.5, "floor": {"z": -2)"},
           {R"({"texture": "#808080"})", R"({"texture": "#ff0000 2,3 4,5"})"},
           {R"({"texture": "#808080"})",
            R"({"texture": {"name": "#808080", "along": 1, "zref": 7}})"},
           {R"("sidewall": "#808080")", R"("sidewall": "#123456", "isRelative": true)"},
           {R"("texture": "#80a0ff")", R"("texture": "#ffffff")"},
           {R"("texture": "#808080"},
      "slopeFloor")",
            R"("texture": "#808080", "isRelative": true},
      "slopeFloor")"},
           {R"("x": 1, "y": 1)", R"("x": 1.5, "y": 0.5)"},
           {R"("inner")", R"("pillar")"},
           {R"("v": [0,0, 6,0)", R"("v": [-0.0,-0.0, 6,-0.0)"},
       })
    EXPECT_EQ(geometryHash(with(from, to).scene(), kTexel), hash) << to;
  const LoadedLevel lit =
      with("all kinds", "all kinds", R"([{"x": 2, "y": 1, "z": 1, "radius": 0.1},
                                                       {"x": 8, "y": 2, "z": 3}])");
  EXPECT_EQ(geometryHash(lit.scene(), kTexel), hash);
}

TEST(GeometryHash, doesNotKnowTheNamesOfSectors) {
  std::string text(kLevel);
  for (std::size_t at = 0; (at = text.find("yard", at)) != std::string::npos;)
    text.replace(at, 4, "a court");
  EXPECT_EQ(geometryHash(test::levelFrom(text, kLights).scene(), kTexel),
            geometryHash(original().scene(), kTexel));
}

TEST(GeometryHash, changesWithAllThatDecidesSurfacesAndTheirTexels) {
  const std::uint64_t hash = geometryHash(original().scene(), kTexel);
  EXPECT_NE(geometryHash(original().scene(), 0.25), hash) << "size of texels";
  for (const auto& [from, to] : {
           std::array<std::string_view, 2>{"10,0, 10,4", "10,0, 10,4.0000001"},  // a vertex
           {R"(6,4, 0,4], "walls": {)", R"(6,4, 3,4, 0,4], "walls": {)"},        // a cut wall
           {R"("ceiling": {"z": 3)", R"("ceiling": {"z": 3.001)"},
           {R"("floor": {"z": -2)", R"("floor": {"z": -2.5)"},
           {"[0, 0.5, 0.5, 0]", "[0, 0.25, 0.25, 0]"},            // the slope's gradient
           {"[0, 0.5, 0.5, 0]", "[0.125, 0.625, 0.625, 0.125]"},  // its height
           {R"("slopeFloor")", R"("$slopeFloor")"},               // whether there is one
           {R"({"z": 1, "texture")", R"({"z": 1.5, "texture")"},  // a sub-wall
           {R"({"z": 1, "texture")", R"({"z": 1, "next": "yard", "texture")"},  // a link
           {R"(, "parallax": true)", ""},                                       // sky
       })
    EXPECT_NE(geometryHash(with(from, to).scene(), kTexel), hash) << to;
}

TEST(GeometryHash, changesWhereAFlatPortalIsClosed) {
  std::string text(kLevel);
  for (std::size_t at = 0; (at = text.find(R"("next": "hall-cellar")", at)) != std::string::npos;)
    text.replace(at, 21, R"("texture": "#808080")");
  EXPECT_NE(geometryHash(test::levelFrom(text, kLights).scene(), kTexel),
            geometryHash(original().scene(), kTexel));
}

}  // namespace
}  // namespace hearth
