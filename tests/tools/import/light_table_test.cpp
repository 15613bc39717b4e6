#include "import/doom/light_table.h"

#include <gtest/gtest.h>

namespace hearth::doom {

namespace {

std::string mistakeIn(std::string_view json) {
  const auto table = parseLightTable(json);
  EXPECT_FALSE(table) << json;
  return table ? "" : table.error();
}

TEST(LightTable, readsAllKeys) {
  const auto table = parseLightTable(R"({ "//": "mine", "things": { "2028": { "//": "lamp",
    "color": "#102030", "intensity": 1, "falloff": 2, "reach": 3, "height": 4, "every": 5,
    "emit": 6 } },
    "walls": { "LITE3": {} }, "flats": { "LAVA1": { "reach": 7 } },
    "sky": { "color": "#203040", "intensity": 8 },
    "sun": { "color": "#304050", "angle": -9, "pitch": 10, "intensity": 11, "size": 12 } })");
  ASSERT_TRUE(table) << table.error();
  const Glow& lamp = table->things.at(2028);
  EXPECT_EQ(lamp.color, "#102030");
  EXPECT_EQ(lamp.intensity, 1);
  EXPECT_EQ(lamp.falloff, 2);
  EXPECT_EQ(lamp.reach, 3);
  EXPECT_EQ(lamp.height, 4);
  EXPECT_EQ(lamp.every, 5);
  EXPECT_EQ(lamp.emit, 6);
  EXPECT_EQ(table->sky.color, "#203040");
  EXPECT_EQ(table->sky.intensity, 8);
  ASSERT_TRUE(table->sun);
  EXPECT_EQ(table->sun->color, "#304050");
  EXPECT_EQ(table->sun->angle, -9);
  EXPECT_EQ(table->sun->pitch, 10);
  EXPECT_EQ(table->sun->intensity, 11);
  EXPECT_EQ(table->sun->size, 12);
  EXPECT_EQ(table->walls.at("LITE3").color, "#ffffff");
  EXPECT_EQ(table->walls.at("LITE3").emit, 0);
  EXPECT_EQ(table->flats.at("LAVA1").reach, 7);
}

TEST(LightTable, saysWhereItsMistakesAre) {
  EXPECT_TRUE(mistakeIn("[").starts_with("/: it is no JSON"));
  EXPECT_TRUE(mistakeIn("[]").starts_with("/: "));
  EXPECT_TRUE(mistakeIn(R"({"thing": {}})").starts_with("/thing: "));
  EXPECT_TRUE(mistakeIn(R"({"things": {"lamp": {}}})").starts_with("/things/lamp: "));
  EXPECT_TRUE(mistakeIn(R"({"things": {"0": {}}})").starts_with("/things/0: "));
  EXPECT_TRUE(mistakeIn(R"({"things": {"70000": {}}})").starts_with("/things/70000: "));
  EXPECT_TRUE(mistakeIn(R"({"walls": {"A": 1}})").starts_with("/walls/A: "));
  EXPECT_TRUE(mistakeIn(R"({"walls": {"A": {"colour": 1}}})").starts_with("/walls/A/colour: "));
  EXPECT_TRUE(mistakeIn(R"({"walls": {"A": {"color": "red"}}})").starts_with("/walls/A/color: "));
  EXPECT_TRUE(mistakeIn(R"({"walls": {"A": {"falloff": -1}}})").starts_with("/walls/A/falloff: "));
  EXPECT_TRUE(mistakeIn(R"({"walls": {"A": {"every": 0.2}}})").starts_with("/walls/A/every: "));
  EXPECT_TRUE(mistakeIn(R"({"walls": {"A": {"reach": 1e300}}})").starts_with("/walls/A/reach: "));
  EXPECT_TRUE(mistakeIn(R"({"walls": {"A": {"emit": -1}}})").starts_with("/walls/A/emit: "));
  EXPECT_TRUE(mistakeIn(R"({"sky": 1})").starts_with("/sky: "));
  EXPECT_TRUE(mistakeIn(R"({"sky": {"size": 1}})").starts_with("/sky/size: there is no such key"));
  EXPECT_TRUE(mistakeIn(R"({"sun": {"pitch": 0}})").starts_with("/sun/pitch: "));
  EXPECT_TRUE(mistakeIn(R"({"sun": {"size": 21}})").starts_with("/sun/size: "));
  EXPECT_TRUE(mistakeIn(R"({"flats": {"A": {"reach": "1"}}})").starts_with("/flats/A/reach: "));
}

// By their numbers in Doom: lamps, candles, torches, the burning barrel.
TEST(LightTable, ofTheProgramHasAllLampsAndFires) {
  const auto table = parseLightTable(ownLightTable());
  ASSERT_TRUE(table) << table.error();
  for (const std::uint16_t thing :
       std::initializer_list<std::uint16_t>{2028, 85, 86, 34, 35, 44, 45, 46, 55, 56, 57, 70})
    EXPECT_TRUE(table->things.contains(thing)) << thing;
}

TEST(LightTable, ofTheProgramHasASkyASunAndEmittersOfAllSurfaces) {
  const auto table = parseLightTable(ownLightTable());
  ASSERT_TRUE(table) << table.error();
  EXPECT_GT(table->sky.intensity, 0);
  EXPECT_TRUE(table->sun);
  for (const auto* surfaces : {&table->walls, &table->flats})
    for (const auto& [name, glow] : *surfaces) EXPECT_GT(glow.emit, 0) << name;
}

TEST(LightTable, ofTheProgramHasLitTexturesAndLava) {
  const auto table = parseLightTable(ownLightTable());
  ASSERT_TRUE(table) << table.error();
  for (const char* wall : {"LITE3", "LITE5", "LITEBLU1", "FIREBLU1"})
    EXPECT_TRUE(table->walls.contains(wall)) << wall;
  for (const char* flat : {"LAVA1", "TLITE6_1", "FLAT22"})
    EXPECT_TRUE(table->flats.contains(flat)) << flat;
}

}  // namespace

}  // namespace hearth::doom
