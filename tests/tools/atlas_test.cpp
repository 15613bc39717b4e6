#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

#include "cli/lightmap_atlas.h"
#include "loaded.h"
#include "support/canvas.h"
#include "support/level_text.h"
#include "text/drawn_text.h"

namespace hearth {

namespace {

using Counts = std::map<std::tuple<int, int, int>, std::int64_t>;

Counts texelColors(const BakedLight& light) {
  Counts counts;
  for (const auto& map : light.lightmaps)
    if (map)
      for (int j = map->rect.j0; j < map->rect.j0 + map->rect.height; ++j)
        for (int i = map->rect.i0; i < map->rect.i0 + map->rect.width; ++i)
          ++counts[{map->at(i, j, 0), map->at(i, j, 1), map->at(i, j, 2)}];
  return counts;
}

/// How often the picture has each of the colours.
Counts countIn(const Image& image, const Counts& colors) {
  Counts counts;
  for (const auto& [r, g, b] : image.pixels())
    if (colors.contains({r, g, b})) ++counts[{r, g, b}];
  return counts;
}

/// Pixels along a texel's side, if every texel shows as one square of so many.
int pixelsPerTexel(const BakedLight& light, const Image& image) {
  const Counts texels = texelColors(light);
  const Counts pixels = countIn(image, texels);
  for (int side = 1; side <= 16; ++side) {
    Counts squares = texels;
    for (auto& [color, count] : squares) count *= side * side;
    if (squares == pixels) return side;
  }
  return 0;
}

/// Places where the picture shows the text with background, that of its corner, on both sides.
int timesShown(const Image& image, const std::string& text) {
  constexpr int kAir = 8;  // pixels; more than a blank in a longer text
  const Rgb background = image.at(0, 0);
  test::Canvas wanted(textWidth(text) + 2 * kAir, kTextHeight, background);
  drawText(wanted, kAir, 0, text, {1, 2, 3});
  const auto isAt = [&](int x0, int y0) {
    for (int y = 0; y < wanted.height(); ++y)
      for (int x = 0; x < wanted.width(); ++x)
        if ((wanted.at(x, y) == background) != (image.at(x0 + x, y0 + y) == background))
          return false;
    return true;
  };
  int times = 0;
  for (int y = 0; y + wanted.height() <= image.height(); ++y)
    for (int x = 0; x + wanted.width() <= image.width(); ++x) times += isAt(x, y) ? 1 : 0;
  return times;
}

TEST(Atlas, ShowsEveryTexelOfEveryLightmapAsOneSquare) {
  const LoadedLevel rooms = loaded("tests/levels/rooms.json");
  const BakedLight light = bake(rooms.scene(), {.texel = 0.5}, 1);
  EXPECT_GT(light.stats.litSurfaces, 5U);
  const Image atlas = lightmapAtlas(rooms.level, light).value();
  EXPECT_GT(pixelsPerTexel(light, atlas), 4) << "a texel must be seen";
  EXPECT_LE(std::max(atlas.width(), atlas.height()), 1500);
}

TEST(Atlas, ShowsManyTexelsSmall) {
  const LoadedLevel rooms = loaded("tests/levels/rooms.json");
  const BakedLight light = bake(rooms.scene(), {.texel = 0.01}, 2);
  EXPECT_EQ(pixelsPerTexel(light, lightmapAtlas(rooms.level, light).value()), 1);
}

TEST(Atlas, ShowsColoredLightInColor) {
  LoadedLevel rooms = loaded("tests/levels/rooms.json");
  rooms.level.lights[0].color[1] = 30;
  const BakedLight light = bake(rooms.scene(), {.texel = 0.5}, 1);
  ASSERT_GT(light.stats.coloredSurfaces, 0U);
  EXPECT_GT(pixelsPerTexel(light, lightmapAtlas(rooms.level, light).value()), 0);
}

TEST(Atlas, LabelsEveryLightmap) {
  const LoadedLevel rooms = loaded("tests/levels/rooms.json");
  const BakedLight light = bake(rooms.scene(), {.texel = 0.5}, 1);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < light.lightmaps.size(); ++i)
    if (light.lightmaps[i])
      for (const std::string& line : labelOf(rooms.level, SurfaceId(i))) lines.push_back(line);
  const Image atlas = lightmapAtlas(rooms.level, light).value();
  for (const std::string line : {"hall", "hall 0", "sloped floor", "floor", "solid wall"}) {
    const auto endsSo = [&](const std::string& shown) {
      return shown == line || shown.ends_with(" " + line);
    };
    const auto times = std::ranges::count_if(lines, endsSo);
    EXPECT_GT(times, 0) << line;
    EXPECT_EQ(timesShown(atlas, line), times) << line;
  }
}

TEST(Atlas, OfADarkLevelIsEmptyButStillAPicture) {
  const Image image = lightmapAtlas(Level{}, BakedLight{}).value();
  EXPECT_GE(image.width(), 1);
  EXPECT_GE(image.height(), 1);
}

TEST(Atlas, IsRefusedWhereItWouldBeTooLarge) {
  const LoadedLevel rooms = loaded("tests/levels/rooms.json");
  BakedLight light = bake(rooms.scene(), {.texel = 0.5}, 1);
  for (auto& map : light.lightmaps)
    if (map) map = Lightmap{{0, 0, 2, 20000}, std::vector<std::uint8_t>(40000)};
  const auto atlas = lightmapAtlas(rooms.level, light);
  ASSERT_FALSE(atlas);
  EXPECT_NE(atlas.error().find("16384 pixels"), std::string::npos) << atlas.error();
  EXPECT_NE(atlas.error().find("--texel"), std::string::npos) << atlas.error();
}

TEST(AtlasLabel, NamesKindSectorLoopAndWall) {
  const LoadedLevel tutorial = loaded("levels/tutorial.json");
  std::map<std::vector<std::string>, int> labels;
  for (const SurfaceId id : tutorial.scene().shownSurfaces()) ++labels[labelOf(tutorial.level, id)];
  using Lines = std::vector<std::string>;
  EXPECT_EQ(labels.count(Lines{"floor", "hall"}), 1U);
  EXPECT_EQ(labels.count(Lines{"solid wall", "hall 0"}), 1U);
  EXPECT_EQ(labels.count(Lines{"solid wall", "hall/pillar 3"}), 1U);
}

TEST(Atlas, ShowsTheLightOfASprite) {
  const LoadedLevel room = test::levelFrom(
      "{'light': 0.1, 'things': [{'name': 'lamp', 'sprite': '#c04020', 'x': 1, 'y': 1},"
      "{'sprite': '#c04020', 'x': 3, 'y': 1, 'facing': 'flat'}], 'sectors': {" +
      test::sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3) + "}}");
  BakedLight light = bake(room.scene(), {.texel = 0.5}, 1);
  for (const Sprite& sprite : room.level.sprites)
    light.lightmaps[sprite.surface.index()] = Lightmap{{0, 0, 1, 1}, {200}};
  EXPECT_EQ(pixelsPerTexel(light, lightmapAtlas(room.level, light).value()), 16);
  using Lines = std::vector<std::string>;
  EXPECT_EQ(labelOf(room.level, room.level.sprites[0].surface), (Lines{"camera sprite", "lamp"}));
  EXPECT_EQ(labelOf(room.level, room.level.sprites[1].surface), (Lines{"flat sprite", "#c04020"}));
}

TEST(AtlasLabel, CutsLongNamesButNotTheNumberOfTheWall) {
  LoadedLevel rooms = loaded("tests/levels/rooms.json");
  for (Sector& sector : rooms.level.sectors) sector.name = std::string(1000, 'm');
  for (const SurfaceId id : rooms.scene().shownSurfaces()) {
    const std::string where = labelOf(rooms.level, id).at(1);
    EXPECT_LT(where.size(), 40U);
    if (const auto segment = rooms.level[id].segment)
      EXPECT_TRUE(where.ends_with(".. " + std::to_string(rooms.level[*segment].wallIndex)))
          << where;
    else
      EXPECT_TRUE(where.ends_with("..")) << where;
  }
}

TEST(Shelves, HoldRectanglesThatTouchNeitherOneAnotherNorTheBorder) {
  std::mt19937 random(5);
  const auto side = [&] { return static_cast<std::int64_t>(1 + random() % 90); };
  for (const int count : {1, 2, 50, 300}) {
    std::vector<AtlasSize> sizes;
    for (int i = 0; i < count; ++i) sizes.push_back({side(), side()});
    const Shelves shelves = placeOnShelves(sizes);
    const auto isApart = [&](std::size_t a, std::size_t b) {
      const auto& [p, q] = std::tie(shelves.places[a], shelves.places[b]);
      return p.x + sizes[a].width < q.x || q.x + sizes[b].width < p.x ||
             p.y + sizes[a].height < q.y || q.y + sizes[b].height < p.y;
    };
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      EXPECT_GT(shelves.places[i].x, 0);
      EXPECT_GT(shelves.places[i].y, 0);
      EXPECT_LT(shelves.places[i].x + sizes[i].width, shelves.size.width);
      EXPECT_LT(shelves.places[i].y + sizes[i].height, shelves.size.height);
      for (std::size_t k = 0; k < i; ++k) EXPECT_TRUE(isApart(i, k)) << i << " " << k;
    }
  }
}

TEST(Shelves, AreAboutAsWideAsHigh) {
  const std::vector<AtlasSize> sizes(400, {10, 20});
  const AtlasSize size = placeOnShelves(sizes).size;
  EXPECT_LT(size.width, 2 * size.height);
  EXPECT_LT(size.height, 2 * size.width);
}

TEST(TextImage, DrawsEverySignInsideItsWidthAndHeight) {
  for (int sign = 0; sign < 256; ++sign) {
    const std::string text(1, static_cast<char>(sign));
    test::Canvas image(40, 40);
    drawText(image, 10, 10, text, {255, 255, 255});
    int drawn = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        if (image.at(x, y) == Rgb{}) continue;
        ++drawn;
        EXPECT_TRUE(x >= 10 && x < 10 + textWidth(text)) << sign;
        EXPECT_TRUE(y >= 10 && y < 10 + kTextHeight) << sign;
      }
    EXPECT_EQ(drawn > 0, text != " ") << sign;
  }
}

TEST(TextImage, IsCutOffAtTheImagesBorder) {
  test::Canvas image(5, 5);
  drawText(image, -3, -3, "WWWW", {255, 255, 255});
  drawText(image, 100, 100, "W", {255, 255, 255});
  EXPECT_NE(image.image(), Image(5, 5));
}

}  // namespace

}  // namespace hearth
