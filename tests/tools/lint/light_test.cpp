#include <gtest/gtest.h>

#include "places.h"

namespace hearth::test {

namespace {

/// A lit room and a dark one, with a wall between them.
constexpr std::string_view kRooms = R"({ 'light': 0, 'sectors': {
  'lit': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
    'loops': {'border': {'v': [0,0, 4,0, 4,4, 0,4], 'walls': {'texture': '#808080'}}}},
  'dark': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
    'loops': {'border': {'v': [4,0, 8,0, 8,4, 4,4], 'walls': {'texture': '#808080'}}}}
}})";

constexpr std::string_view kLamp = "[{ 'x': 2, 'y': 2, 'z': 2, 'intensity': 200 }]";

TEST(BlackSurfaces, AreToldOnceForASectorThatHasNoOther) {
  EXPECT_EQ(placesInLight(kRooms, kLamp), (Places{"4:3 /sectors/dark [black]"}));
}

TEST(BlackSurfaces, AreNoneWithALampOrLightOfTheSector) {
  EXPECT_EQ(placesInLight(kRooms,
                          "[{ 'x': 2, 'y': 2, 'z': 2, 'intensity': 200 }, "
                          "{ 'x': 6, 'y': 2, 'z': 2, 'intensity': 200 }]"),
            Places{});
  EXPECT_EQ(placesInLight(with(kRooms, "'light': 0,", "'light': 0.1,"), kLamp), Places{});
}

TEST(BlackSurfaces, AreNoneInLightHoweverFaintThatShows) {
  const std::string lit = with(kRooms, "'dark': {", "'dark': { 'light': 0.1, ");
  EXPECT_EQ(placesInLight(lit, "[{ 'x': 2, 'y': 2, 'z': 2, 'intensity': 1 }]"),
            (Places{"1:2 /0 [weak-light]"}));
}

/// The lamp stands in the plane of the floor, which it does not light.
TEST(BlackSurfaces, AreToldOneByOneInASectorThatHasOthers) {
  const std::string lit = with(kRooms, "'dark': {", "'dark': { 'light': 0.1, ");
  EXPECT_EQ(placesInLight(lit, "[{ 'x': 2, 'y': 2, 'z': 0, 'intensity': 200 }]"),
            (Places{"2:21 /sectors/lit/floor [black]"}));
}

/// The far side of the pillar, 0.8 x 4 m, is in its own shadow.
TEST(BlackSurfaces, MayBeInTheShadowOfThingsWhereTheyAreSmall) {
  const std::string lit = with(kRooms, "'dark': {", "'dark': { 'light': 0.1, ");
  const std::string level =
      with(lit, "0,4], 'walls': {'texture': '#808080'}}",
           "0,4], 'walls': {'texture': '#808080'}}, 'pillar': {'v': [3,1.6, 3,2.4, 3.8,2.4, "
           "3.8,1.6], 'walls': {'texture': '#808080'}}");
  EXPECT_EQ(placesInLight(level, "[{ 'x': 1, 'y': 2, 'z': 2, 'intensity': 200 }]"), Places{});
}

TEST(UselessLights, AreThoseThatGiveNoLight) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.1,");
  EXPECT_EQ(placesInLight(lit,
                          "[{ 'x': 2, 'y': 2, 'z': 2, 'intensity': 200 },\n"
                          " { 'x': 2, 'y': 2, 'z': 3, 'intensity': 0 },\n"
                          " { 'x': 2, 'y': 2, 'z': 1, 'curve': [[0.5, 0]] }]"),
            (Places{"2:2 /1 [useless-light]", "3:2 /2 [useless-light]"}));
}

TEST(UselessLights, AreSunsThatNoSkyLetsIn) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.1,");
  EXPECT_EQ(placesInLight(lit, "{ 'lights': [],\n'suns': [{ 'angle': 0, 'pitch': 45 }] }"),
            (Places{"2:10 /suns/0 [useless-light]"}));
}

/// All of one colour: each surface is lit by the others, and black by no means.
TEST(BlackSurfaces, AreNotThoseThatShine) {
  EXPECT_EQ(placesInLight(kRooms, "{ 'lights': [], 'emit': { '#808080': { 'intensity': 60 } } }"),
            Places{});
}

/// Of a texture that nothing wears the loader warns.
TEST(UselessLights, AreEmittersThatGiveNoLight) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.1,");
  EXPECT_EQ(placesInLight(
                lit, "{ 'lights': [], 'emit': {\n'#808080': { 'intensity': 0 },\n'lava': {} } }"),
            (Places{"2:12 /emit/#808080 [useless-light]"}));
}

TEST(UselessLights, IsASkyThatNoRoomIsOpenTo) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.1,");
  EXPECT_EQ(placesInLight(lit, "{ 'lights': [],\n'sky': { 'intensity': 100 } }"),
            (Places{"2:8 /sky [useless-light]"}));
}

TEST(UselessLights, MayShineLessFarThanToASurface) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.1,");
  EXPECT_EQ(placesInLight(lit, "[{ 'x': 2, 'y': 2, 'z': 2, 'curve': [[0, 200], [1.9, 0]] }]"),
            (Places{"1:2 /0 [useless-light]"}));
  EXPECT_EQ(placesInLight(lit, "[{ 'x': 2, 'y': 2, 'z': 2, 'curve': [[0, 200], [2.1, 0]] }]"),
            Places{});
}

/// Full light is 255: a lamp of intensity 1 does not show.
TEST(WeakLights, AreThoseThatBringNoSurfaceMoreThanAFewLevels) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.1,");
  EXPECT_EQ(placesInLight(lit,
                          "[{ 'x': 2, 'y': 2, 'z': 2, 'intensity': 1 },\n"
                          " { 'x': 2, 'y': 2, 'z': 3, 'intensity': 200, 'falloff': 60 },\n"
                          " { 'x': 2, 'y': 2, 'z': 1, 'intensity': 5 }]"),
            (Places{"1:2 /0 [weak-light]", "2:2 /1 [weak-light]"}));
}

TEST(Overexposure, IsFoundWhereMostLightIsLost) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.1,");
  EXPECT_EQ(placesInLight(lit, "[{ 'x': 2, 'y': 2, 'z': 2, 'intensity': 800 }]"),
            (Places{"1:2 /0 [overexposed]"}));
}

/// The lamp in the dark room would bring more to the wall between, if it were not behind it.
TEST(Overexposure, IsToldOnceOfEachLightThatBringsMost) {
  EXPECT_EQ(placesInLight(with(kRooms, "'light': 0,", "'light': 0.1,"),
                          "[{ 'x': 1, 'y': 2, 'z': 2, 'intensity': 50 },\n"
                          " { 'x': 2, 'y': 2, 'z': 2, 'intensity': 900 },\n"
                          " { 'x': 4.5, 'y': 2, 'z': 2, 'intensity': 910 }]"),
            (Places{"2:2 /1 [overexposed]", "3:2 /2 [overexposed]"}));
}

TEST(Overexposure, IsNoneWhereLightIsSomewhatMoreThanFull) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.5,");
  EXPECT_EQ(placesInLight(lit, "[{ 'x': 2, 'y': 2, 'z': 2, 'intensity': 380 }]"), Places{});
}

TEST(Overexposure, IsNoneInThePoolOfLightAroundALamp) {
  const std::string lit = with(kRooms, "'light': 0,", "'light': 0.1,");
  EXPECT_EQ(placesInLight(lit, "[{ 'x': 2, 'y': 2, 'z': 3.8, 'intensity': 1000, 'falloff': 4 }]"),
            Places{});
}

TEST(Overexposure, IsNoneInASectorThatIsFullyBright) {
  const std::string bright = with(kRooms, "'light': 0,", "'light': 1,");
  EXPECT_EQ(placesInLight(bright, "[{ 'x': 2, 'y': 2, 'z': 2, 'intensity': 800 }]"), Places{});
}

}  // namespace

}  // namespace hearth::test
