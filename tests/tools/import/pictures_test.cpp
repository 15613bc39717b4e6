#include "import/doom/pictures.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "pictures_builder.h"

namespace hearth::doom {
namespace {

using Sentences = std::vector<std::string>;

Pictures read(const Wad& wad) {
  auto pictures = Pictures::read(wad);
  if (!pictures) ADD_FAILURE() << pictures.error();
  return std::move(pictures).value();
}

std::string mistakeOf(const WadBuilder& builder) {
  const Wad wad = opened(builder);
  const auto pictures = Pictures::read(wad);
  EXPECT_FALSE(pictures);
  return pictures ? "" : pictures.error();
}

/// A palette, and the patches RED (1 x 2 of colour 1), BLUE (2 x 1 of colour 2).
WadBuilder withPatches() {
  return WadBuilder()
      .add("PLAYPAL", palette())
      .add("PNAMES", patchNames({"red", "Blue", "NONE", "BROKEN"}))
      .add("RED", plainPatch(1, 2, 1))
      .add("BLUE", plainPatch(2, 1, 2))
      .add("BROKEN", "123");
}

WadBuilder withTextures(const std::vector<std::string>& definitions) {
  return withPatches().add("TEXTURE1", texturesOf(definitions));
}

/// The error of the only texture, T.
std::string refusalOf(const std::string& definition) {
  const Wad wad = opened(withTextures({definition}));
  const Pictures pictures = read(wad);
  EXPECT_TRUE(pictures.hasWall("T"));
  EXPECT_EQ(pictures.sizeOfWall("T"), std::nullopt);
  const auto wall = pictures.wall("T");
  EXPECT_FALSE(wall);
  return wall ? "" : wall.error();
}

TEST(Pictures, areNoneInAWadOfAPaletteAlone) {
  const Wad wad = opened(WadBuilder().add("PLAYPAL", palette()));
  const Pictures pictures = read(wad);
  EXPECT_TRUE(pictures.walls().empty());
  EXPECT_FALSE(pictures.hasWall("DOOR3"));
  EXPECT_EQ(pictures.sizeOfWall("DOOR3"), std::nullopt);
  EXPECT_EQ(pictures.wall("DOOR3").error(), "there is no wall texture DOOR3");
  EXPECT_TRUE(pictures.flats().empty());
  EXPECT_FALSE(pictures.hasFlat("NUKAGE1"));
  EXPECT_EQ(pictures.flat("NUKAGE1").error(), "there is no flat NUKAGE1");
}

TEST(Pictures, needAPalette) {
  EXPECT_EQ(mistakeOf(WadBuilder()), "PLAYPAL, the palette, has 0 bytes: 768 are needed");
  EXPECT_EQ(mistakeOf(WadBuilder().add("PLAYPAL", palette().substr(1))),
            "PLAYPAL, the palette, has 767 bytes: 768 are needed");
}

TEST(Pictures, takeTheFirstPaletteOfTheLastLump) {
  const Wad wad = opened(WadBuilder()
                             .add("PLAYPAL", LumpBuilder().repeat(9, 768))
                             .add("PLAYPAL", palette() + LumpBuilder().repeat(9, 768).content())
                             .add("F_START")
                             .add("A", flatOf(200))
                             .add("F_END"));
  EXPECT_EQ(read(wad).flat("A")->image.at(0, 0), colorOf(200));
}

TEST(WallTexture, hasItsPatchesOneOverTheOther) {
  const Wad wad = opened(withTextures({definition("T", 3, 2, {{0, 0, 0}, {2, 0, 0}, {1, 0, 1}})}));
  const Pictures pictures = read(wad);
  EXPECT_EQ(pictures.sizeOfWall("T"), (ImageSize{3, 2}));
  const auto wall = pictures.wall("T");
  ASSERT_TRUE(wall) << wall.error();
  EXPECT_EQ(wall->mistakes, Sentences{});
  Image expected(3, 2, colorOf(1));
  expected.at(1, 0) = colorOf(2);
  expected.at(2, 0) = colorOf(2);
  expected.at(1, 1) = colorOf(0);
  EXPECT_EQ(wall->image, expected);
  EXPECT_EQ(wall->isOpaque, (std::vector<bool>{true, true, true, true, false, true}));
  EXPECT_TRUE(wall->hasHoles());
}

TEST(WallTexture, hasNoHolesWherePatchesCoverIt) {
  const Wad wad =
      opened(withTextures({definition("T", 2, 2, {{0, 0, 0}, {1, -1, 0}, {0, 1, 1}, {1, 0, 1}})}));
  const auto wall = read(wad).wall("T");
  ASSERT_TRUE(wall) << wall.error();
  EXPECT_FALSE(wall->hasHoles());
}

/// With the patch LETTERS, 1 x 3 of the colours 3, 4, 5.
Image imageOf(int width, const std::vector<Placed>& patches) {
  const Wad wad = opened(WadBuilder()
                             .add("PLAYPAL", palette())
                             .add("PNAMES", patchNames({"LETTERS", "BLUE"}))
                             .add("LETTERS", patchOf(3, {{{0, {3, 4, 5}}}}))
                             .add("BLUE", plainPatch(2, 1, 2))
                             .add("TEXTURE1", texturesOf({definition("T", width, 4, patches)})));
  auto wall = read(wad).wall("T");
  if (!wall) ADD_FAILURE() << wall.error();
  return wall->image;
}

/// The numbers of its colours, from top to bottom.
std::vector<int> columnOf(const Image& image, int x) {
  std::vector<int> colors;
  for (int y = 0; y < image.height(); ++y) colors.push_back(image.at(x, y).r);
  return colors;
}

TEST(WallTexture, hasAPatchAtTheTopWhereItIsAloneInAColumnAsInDoom) {
  for (const int top : {-2, 0, 1})
    EXPECT_EQ(columnOf(imageOf(1, {{0, top, 0}}), 0), (std::vector<int>{3, 4, 5, 0})) << top;
}

TEST(WallTexture, hasPatchesInTheirPlacesWhereTheyShareAColumn) {
  const Image image = imageOf(3, {{0, 1, 0}, {2, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(columnOf(image, 0), (std::vector<int>{2, 3, 4, 5}));
  EXPECT_EQ(columnOf(image, 1), (std::vector<int>{2, 0, 0, 0}));
  EXPECT_EQ(columnOf(image, 2), (std::vector<int>{3, 4, 5, 0}));
}

TEST(WallTexture, isAllHolesWithoutPatches) {
  const Wad wad = opened(withTextures({definition("T", 2, 2, {})}));
  const auto wall = read(wad).wall("T");
  ASSERT_TRUE(wall) << wall.error();
  EXPECT_EQ(wall->image, Image(2, 2, colorOf(0)));
  EXPECT_EQ(wall->isOpaque, std::vector<bool>(4, false));
}

TEST(WallTexture, mayStandInEitherLumpInLowerCase) {
  const Wad wad = opened(withTextures({definition("One", 1, 1, {})})
                             .add("TEXTURE2", texturesOf({definition("two", 2, 2, {})})));
  const Pictures pictures = read(wad);
  EXPECT_EQ(pictures.walls().size(), 2U);
  EXPECT_EQ(pictures.sizeOfWall("ONE"), (ImageSize{1, 1}));
  EXPECT_EQ(pictures.sizeOfWall("TWO"), (ImageSize{2, 2}));
}

TEST(WallTexture, countsAsItIsDefinedFirst) {
  const Wad wad = opened(withTextures({definition("T", 1, 1, {}), definition("t", 2, 2, {})})
                             .add("TEXTURE2", texturesOf({definition("T", 3, 3, {})})));
  EXPECT_EQ(read(wad).sizeOfWall("T"), (ImageSize{1, 1}));
}

TEST(WallTexture, isTakenFromTheLastLumpOfItsName) {
  const Wad wad = opened(withTextures({definition("OLD", 1, 1, {}), definition("T", 1, 1, {})})
                             .add("TEXTURE1", texturesOf({definition("T", 2, 2, {})})));
  const Pictures pictures = read(wad);
  EXPECT_FALSE(pictures.hasWall("OLD"));
  EXPECT_EQ(pictures.sizeOfWall("T"), (ImageSize{2, 2}));
}

TEST(WallTexture, takesTheLastPatchOfANameThatIsNoFlat) {
  const Wad wad = opened(withTextures({definition("T", 1, 1, {{0, 0, 0}})})
                             .add("RED", plainPatch(1, 1, 7))
                             .add("F_START")
                             .add("RED", flatOf(9))
                             .add("F_END"));
  const auto wall = read(wad).wall("T");
  ASSERT_TRUE(wall) << wall.error();
  EXPECT_EQ(wall->image.at(0, 0), colorOf(7));
}

TEST(WallTexture, losesOnlyThePatchesThatAreMissingOrBroken) {
  const Wad wad = opened(withTextures(
      {definition("T", 1, 2, {{0, 0, 2}, {0, 0, 3}, {0, 0, 4}, {0, 0, -1}, {0, 0, 0}})}));
  const auto wall = read(wad).wall("T");
  ASSERT_TRUE(wall) << wall.error();
  EXPECT_EQ(wall->image, Image(1, 2, colorOf(1)));
  EXPECT_FALSE(wall->hasHoles());
  EXPECT_EQ(wall->mistakes,
            (Sentences{"wall texture T: its patch 0, NONE, is missing",
                       "wall texture T: its patch 1, BROKEN, has 3 bytes, too few for a patch",
                       "wall texture T: its patch 2 has number 4: PNAMES has 4 names",
                       "wall texture T: its patch 3 has number -1: PNAMES has 4 names"}));
}

TEST(WallTexture, hasNoPatchesWithoutTheirNames) {
  const Wad wad = opened(WadBuilder()
                             .add("PLAYPAL", palette())
                             .add("TEXTURE1", texturesOf({definition("T", 1, 1, {{0, 0, 0}})})));
  const auto wall = read(wad).wall("T");
  ASSERT_TRUE(wall) << wall.error();
  EXPECT_EQ(wall->mistakes,
            Sentences{"wall texture T: its patch 0 has number 0: PNAMES has 0 names"});
}

TEST(WallTexture, isRefusedWhenItsSizeMakesNoSense) {
  EXPECT_EQ(refusalOf(definition("T", 0, 8, {})),
            "wall texture T has a side of 0 x 8 pixels that is not within 1..4096");
  EXPECT_EQ(refusalOf(definition("T", 8, -8, {})),
            "wall texture T has a side of 8 x -8 pixels that is not within 1..4096");
  EXPECT_EQ(refusalOf(definition("T", 32767, 32767, {})),
            "wall texture T has a side of 32767 x 32767 pixels that is not within 1..4096");
  EXPECT_EQ(refusalOf(definition("T", 8, 4097, {})),
            "wall texture T has a side of 8 x 4097 pixels that is not within 1..4096");
}

TEST(WallTexture, mayBeAsLargeAsTheLimit) {
  const Wad wad = opened(withTextures({definition("T", 4096, 4096, {})}));
  const auto wall = read(wad).wall("T");
  ASSERT_TRUE(wall) << wall.error();
  EXPECT_EQ(wall->image.width(), 4096);
  EXPECT_EQ(wall->image.height(), 4096);
}

TEST(WallTexture, isRefusedWhenItsPatchesDoNotFitInTheLump) {
  EXPECT_EQ(refusalOf(definition("T", 8, 8, {{0, 0, 0}}, 2)),
            "wall texture T is cut short: its 2 patches do not fit in 10 bytes");
  EXPECT_EQ(refusalOf(definition("T", 8, 8, {{0, 0, 0}}, -1)),
            "wall texture T is cut short: its -1 patches do not fit in 10 bytes");
}

TEST(WallTexture, isRefusedWhenItsPatchesAreTooMany) {
  EXPECT_EQ(refusalOf(definition("T", 4096, 8, std::vector<Placed>(17))),
            "wall texture T has too many patches: 17 for a width of 4096 pixels");
  const Wad wad = opened(withTextures({definition("T", 4096, 8, std::vector<Placed>(16))}));
  EXPECT_TRUE(read(wad).wall("T"));
}

TEST(WallTexture, isReadWhereAnotherOneIsRefused) {
  const Wad wad = opened(withTextures({definition("BAD", 0, 0, {}), definition("T", 2, 2, {})}));
  EXPECT_TRUE(read(wad).wall("T"));
}

TEST(WallTextures, areRefusedWhenTheirCountMakesNoSense) {
  const auto mistake = [](const LumpBuilder& lump) {
    return mistakeOf(withPatches().add("TEXTURE2", lump));
  };
  EXPECT_EQ(mistake(LumpBuilder().repeat(0, 3)), "TEXTURE2 is cut short: it has no count");
  EXPECT_EQ(mistake(LumpBuilder().int32(-1)),
            "TEXTURE2 is cut short: -1 textures do not fit in 4 bytes");
  EXPECT_EQ(mistake(LumpBuilder().int32(2).int32(0)),
            "TEXTURE2 is cut short: 2 textures do not fit in 8 bytes");
  EXPECT_EQ(mistake(LumpBuilder().int32(65537).repeat(0, 4 * 65537)),
            "TEXTURE2 has 65537 textures, more than 65536");
}

TEST(WallTextures, areRefusedWhenOneLiesOutside) {
  const std::string whole = definition("T", 1, 1, {});
  for (const std::int64_t begin : {std::int64_t{-1}, std::int64_t{9}, std::int64_t{INT32_MAX}})
    EXPECT_EQ(
        mistakeOf(withPatches().add("TEXTURE1", LumpBuilder().int32(1).int32(begin).append(whole))),
        fmt::format("TEXTURE1 has texture 0 at byte {} of 30", begin));
}

TEST(PatchNames, areRefusedWhenTheyAreCutShort) {
  const auto mistake = [](const LumpBuilder& lump) {
    return mistakeOf(withPatches().add("PNAMES", lump));
  };
  EXPECT_EQ(mistake(LumpBuilder()), "PNAMES is cut short: it has no count");
  EXPECT_EQ(mistake(LumpBuilder().int32(-1)),
            "PNAMES is cut short: -1 names do not fit in 4 bytes");
  EXPECT_EQ(mistake(LumpBuilder().int32(2).repeat('A', 15)),
            "PNAMES is cut short: 2 names do not fit in 19 bytes");
  EXPECT_EQ(mistake(LumpBuilder().int32(INT32_MAX)),
            "PNAMES is cut short: 2147483647 names do not fit in 4 bytes");
}

TEST(Flat, hasRowsOf64Pixels) {
  LumpBuilder lump;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) lump.bytes({(3 * y + x) & 255});
  const Wad wad =
      opened(WadBuilder().add("PLAYPAL", palette()).add("F_START").add("grass", lump).add("F_END"));
  const auto flat = read(wad).flat("GRASS");
  ASSERT_TRUE(flat) << flat.error();
  EXPECT_FALSE(flat->hasHoles());
  ASSERT_EQ(flat->image.width(), 64);
  ASSERT_EQ(flat->image.height(), 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) ASSERT_EQ(flat->image.at(x, y), colorOf((3 * y + x) & 255));
}

TEST(Flat, isFoundOnlyBetweenMarkers) {
  const Wad wad = opened(WadBuilder()
                             .add("PLAYPAL", palette())
                             .add("BEFORE", flatOf(1))
                             .add("F_START")
                             .add("F1_START")
                             .add("INNER", flatOf(2))
                             .add("F1_END")
                             .add("OUTER", flatOf(3))
                             .add("F_END")
                             .add("BETWEEN", flatOf(4))
                             .add("FF_START")
                             .add("ADDED", flatOf(5))
                             .add("FF_END")
                             .add("AFTER", flatOf(6)));
  const Pictures pictures = read(wad);
  EXPECT_EQ(pictures.flats().size(), 3U);
  for (const auto& [name, color] : {std::pair("INNER", 2), {"OUTER", 3}, {"ADDED", 5}}) {
    ASSERT_TRUE(pictures.hasFlat(name)) << name;
    EXPECT_EQ(pictures.flat(name)->image, Image(64, 64, colorOf(color))) << name;
  }
}

TEST(Flat, isFoundWhicheverMarkersAreAround) {
  for (const auto& [begins, ends] : std::initializer_list<std::pair<Sentences, Sentences>>{
           {{"FF_START"}, {"F_END"}},
           {{"FF_START"}, {"FF_END", "F_END"}},
           {{"F_START", "FF_START"}, {"FF_END", "F_END"}},
           {{"FF_START", "F_START"}, {"F_END", "FF_END"}}}) {
    WadBuilder builder;
    builder.add("PLAYPAL", palette());
    for (const std::string& name : begins) builder.add(name);
    builder.add("A", flatOf(1));
    for (const std::string& name : ends) builder.add(name);
    builder.add("B", flatOf(2));
    const Wad wad = opened(builder);
    EXPECT_TRUE(read(wad).hasFlat("A")) << begins[0] << ' ' << ends[0];
    EXPECT_FALSE(read(wad).hasFlat("B")) << begins[0] << ' ' << ends[0];
  }
}

TEST(Flat, isFoundUntilTheOuterMarkersEnd) {
  const Wad wad = opened(WadBuilder()
                             .add("PLAYPAL", palette())
                             .add("F_START")
                             .add("FF_START")
                             .add("A", flatOf(1))
                             .add("FF_END")
                             .add("B", flatOf(2))
                             .add("F_END")
                             .add("C", flatOf(3)));
  const Pictures pictures = read(wad);
  EXPECT_TRUE(pictures.hasFlat("A"));
  EXPECT_TRUE(pictures.hasFlat("B"));
  EXPECT_FALSE(pictures.hasFlat("C"));
}

TEST(Flat, isTheLastOfItsName) {
  const Wad wad = opened(WadBuilder()
                             .add("PLAYPAL", palette())
                             .add("F_START")
                             .add("A", flatOf(1))
                             .add("F_END")
                             .add("FF_START")
                             .add("A", flatOf(2))
                             .add("FF_END"));
  EXPECT_EQ(read(wad).flat("A")->image.at(0, 0), colorOf(2));
}

TEST(Flat, isRefusedWhenItIsTooShortAndCutWhenItIsLonger) {
  const Wad wad = opened(WadBuilder()
                             .add("PLAYPAL", palette())
                             .add("F_START")
                             .add("NONE")
                             .add("SHORT", flatOf(1, 4095))
                             .add("LONG", flatOf(1) + flatOf(2, 64))
                             .add("F_END"));
  const Pictures pictures = read(wad);
  EXPECT_EQ(pictures.flat("NONE").error(), "flat NONE has 0 bytes: 4096 are needed");
  EXPECT_EQ(pictures.flat("SHORT").error(), "flat SHORT has 4095 bytes: 4096 are needed");
  EXPECT_EQ(pictures.flat("LONG")->image, Image(64, 64, colorOf(1)));
}

/// Draws all there is. What comes of it does not matter, only that it ends well.
void drawAll(const std::string& content) {
  const auto wad = openBytes(content);
  if (!wad) return;
  const auto pictures = Pictures::read(*wad);
  if (!pictures) return;
  for (const auto& [name, definition] : pictures->walls()) {
    const auto wall = pictures->wall(name);
    ASSERT_EQ(wall.has_value(), definition.has_value());
    if (!wall) continue;
    ASSERT_EQ(wall->isOpaque.size(), wall->image.pixels().size());
    ASSERT_EQ((ImageSize{wall->image.width(), wall->image.height()}), pictures->sizeOfWall(name));
  }
  for (const auto& [name, bytes] : pictures->flats())
    ASSERT_EQ(pictures->flat(name).has_value(), bytes.size() >= 4096);
}

TEST(Pictures, surviveEveryByteThatIsWrong) {
  const std::string good =
      withTextures({definition("T", 3, 2, {{0, 0, 0}, {2, 0, 1}}), definition("U", 8, 8, {})})
          .add("F_START")
          .add("A", "short")
          .add("F_END")
          .content();
  const std::size_t palettes = good.find(palette());
  for (std::size_t i = 0; i < good.size(); ++i) {
    if (i >= palettes && i < palettes + 768) continue;  // any byte is right
    for (const int value : {0, 1, 127, 128, 255}) {
      std::string bad = good;
      bad[i] = static_cast<char>(value);
      drawAll(bad);
    }
  }
}

}  // namespace
}  // namespace hearth::doom
