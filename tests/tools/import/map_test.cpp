#include "import/doom/map.h"

#include <gtest/gtest.h>

#include "wad_builder.h"

namespace hearth::doom {

namespace {

/// A triangle of one sector, as the lumps of a map have it.
struct Lumps {
  LumpBuilder things;
  LumpBuilder lines;
  LumpBuilder sides;
  LumpBuilder vertices;
  LumpBuilder sectors;

  Lumps() {
    things.int16(3).int16(-4).int16(90).int16(2028).int16(7);
    for (const int i : {0, 1, 2})
      lines.int16(i).int16((i + 1) % 3).int16(1).int16(46).int16(5).int16(i).int16(-1);
    for (const int i : {0, 1, 2})
      sides.int16(i).int16(-i).name("upper").name("LOWER").name("-").int16(0);
    vertices.int16(0).int16(0).int16(0).int16(64).int16(64).int16(-64);
    sectors.int16(-8).int16(120).name("FLOOR").name("CEIL").int16(300).int16(9).int16(5);
  }

  WadBuilder wad(const char* name = "MAP01") const {
    WadBuilder builder;
    builder.add(name).add("THINGS", things).add("LINEDEFS", lines).add("SIDEDEFS", sides);
    return builder.add("VERTEXES", vertices).add("SECTORS", sectors);
  }
};

std::string mistakeOf(const WadBuilder& builder, const char* name = "MAP01") {
  const Wad wad = opened(builder);
  const auto map = readMap(wad, name);
  EXPECT_FALSE(map);
  return map ? "" : map.error();
}

TEST(MapOfAWad, hasAllOfItsRecords) {
  const Wad wad = opened(Lumps().wad());
  EXPECT_EQ(mapNames(wad), std::vector<std::string>{"MAP01"});
  const auto map = readMap(wad, "MAP01");
  ASSERT_TRUE(map) << map.error();
  ASSERT_EQ(map->vertices.size(), 3U);
  EXPECT_EQ(map->vertices[2].y, -64);
  ASSERT_EQ(map->lines.size(), 3U);
  const Line& line = map->lines[1];
  EXPECT_EQ(line.from, 1U);
  EXPECT_EQ(line.to, 2U);
  EXPECT_EQ(line.special, 46);
  EXPECT_EQ(line.tag, 5);
  EXPECT_EQ(line.sides[0], 1U);
  EXPECT_FALSE(line.sides[1]);
  ASSERT_EQ(map->sides.size(), 3U);
  EXPECT_EQ(map->sides[2].yOffset, -2);
  EXPECT_EQ(map->sides[2].upper, "UPPER");
  ASSERT_EQ(map->sectors.size(), 1U);
  EXPECT_EQ(map->sectors[0].floor, -8);
  EXPECT_EQ(map->sectors[0].light, 255) << "there is no more";
  EXPECT_EQ(map->sectors[0].tag, 5);
  ASSERT_EQ(map->things.size(), 1U);
  EXPECT_EQ(map->things[0].y, -4);
  EXPECT_EQ(map->things[0].type, 2028);
}

TEST(MapOfAWad, isTheLastOfItsName) {
  Lumps first;
  first.sectors = LumpBuilder();
  WadBuilder builder = first.wad();
  const Lumps second;
  builder.add("MAP01").add("THINGS", second.things).add("LINEDEFS", second.lines);
  builder.add("SIDEDEFS", second.sides).add("VERTEXES", second.vertices);
  builder.add("SECTORS", second.sectors);
  EXPECT_TRUE(readMap(opened(builder), "MAP01"));
}

TEST(MapOfAWad, takesNoLumpOfTheNextOne) {
  WadBuilder builder;
  builder.add("MAP01").add("THINGS", Lumps().things);
  const Lumps next;
  builder.add("MAP02").add("THINGS", next.things).add("LINEDEFS", next.lines);
  builder.add("SIDEDEFS", next.sides).add("VERTEXES", next.vertices);
  builder.add("SECTORS", next.sectors);
  EXPECT_EQ(mistakeOf(builder), "MAP01: there is no VERTEXES");
  EXPECT_TRUE(readMap(opened(builder), "MAP02"));
}

TEST(MapOfAWad, saysWhichMapsThereAre) {
  EXPECT_EQ(mistakeOf(Lumps().wad(), "MAP02"), "there is no map MAP02; those of the WAD: MAP01");
}

TEST(MapOfAWad, isRefusedWhereItsLumpsAreCut) {
  Lumps lumps;
  lumps.sides.int16(0);
  EXPECT_EQ(mistakeOf(lumps.wad()), "MAP01: SIDEDEFS has 92 bytes, which is no multiple of 30");
}

TEST(MapOfAWad, isRefusedWhereItHasMoreThanNumbersReach) {
  Lumps lumps;
  lumps.things.repeat(0, std::size_t{10} * 65536);
  EXPECT_EQ(mistakeOf(lumps.wad()), "MAP01: THINGS has 65537 records, more than 65536");
}

TEST(MapOfAWad, isRefusedWhereALineCouldNotNameAllSides) {
  Lumps lumps;
  lumps.sides.repeat(0, std::size_t{30} * (65535 - 3));
  EXPECT_TRUE(readMap(opened(lumps.wad()), "MAP01"));
  lumps.sides.repeat(0, 30);
  EXPECT_EQ(mistakeOf(lumps.wad()), "MAP01: SIDEDEFS has 65536 records, more than 65535");
}

TEST(MapOfAWad, isMissingFromAWadWithoutMaps) {
  WadBuilder builder;
  builder.add("PLAYPAL");
  EXPECT_EQ(mistakeOf(builder), "there are no maps of Doom's own format in it");
}

TEST(MapOfAWad, isNoneWithoutAName) { EXPECT_TRUE(mapNames(opened(Lumps().wad(""))).empty()); }

TEST(MapOfAWad, isRefusedWhereItNamesWhatIsNotThere) {
  Lumps side;
  side.sides.int16(0).int16(0).name("-").name("-").name("-").int16(1);
  EXPECT_EQ(mistakeOf(side.wad()), "MAP01: side 3 names sector 1 of 1");
  Lumps vertex;
  vertex.lines.int16(0).int16(3).int16(1).int16(0).int16(0).int16(0).int16(-1);
  EXPECT_EQ(mistakeOf(vertex.wad()), "MAP01: line 3 names vertex 3 of 3");
  Lumps line;
  line.lines.int16(0).int16(1).int16(1).int16(0).int16(0).int16(0).int16(3);
  EXPECT_EQ(mistakeOf(line.wad()), "MAP01: line 3 names side 3 of 3");
}

TEST(MapOfAWad, isRefusedWhereItIsForHexen) {
  WadBuilder builder = Lumps().wad();
  builder.add("BEHAVIOR");
  EXPECT_EQ(mistakeOf(builder), "MAP01 is a map for Hexen, not for Doom");
}

}  // namespace

}  // namespace hearth::doom
