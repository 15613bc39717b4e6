#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/image_file.h"
#include "load_text.h"
#include "support/temporary_folder.h"

namespace hearth {
namespace {

const std::string kRoom = "0,0, 4,0, 4,4, 0,4";

TextureMapping mappingOf(const std::string& texture) {
  const Level level = loadSectors(sectorText("a", kRoom, "{'texture': " + texture + "}")).level;
  return std::get<Solid>(level.segments[0].wall).texture;
}

TEST(Texture, isReadInAllItsForms) {
  const TextureMapping plain = mappingOf("'#010203'");
  EXPECT_EQ(plain.repeat, (Vec2{1, 1}));
  EXPECT_EQ(plain.offsetTexels, (Vec2{0, 0}));
  EXPECT_EQ(plain.along, 0);
  EXPECT_FALSE(plain.zRef);
  EXPECT_EQ(mappingOf("'#010203 2,0.5'").repeat, (Vec2{2, 0.5}));
  EXPECT_EQ(mappingOf("'#010203 2,0.5 -3,1e9'").offsetTexels, (Vec2{-3, 1e9}));
  const TextureMapping full =
      mappingOf("{'name': '#010203', 'scale': [2, 3], 'offset': [4, 5.5], 'along': -6, 'zref': 0}");
  EXPECT_EQ(full.repeat, (Vec2{2, 3}));
  EXPECT_EQ(full.offsetTexels, (Vec2{4, 5.5}));
  EXPECT_EQ(full.along, -6);
  EXPECT_EQ(full.zRef, 0.0);
}

TEST(Texture, ofAPortalIsThatOfBothItsSteps) {
  const Level level =
      loadSectors(sectorText("a", kRoom,
                             "[{'texture': '#808080'}, {'next': 'b', 'texture': '#123456'}, "
                             "{'texture': '#808080'}, {'texture': '#808080'}]") +
                  "," +
                  sectorText("b", "4,0, 8,0, 8,4, 4,4",
                             "[{'texture': '#808080'}, {'texture': '#808080'}, {'texture': "
                             "'#808080'}, {'next': 'a'}]",
                             "'floor': {'z': 1, 'texture': '#111111'}, 'ceiling': {'z': 3, "
                             "'texture': '#111111'}"))
          .level;
  const Portal& portal = std::get<Portal>(level.segments[1].wall);
  EXPECT_EQ(level.textures[portal.upper.value().texture.index()], "#123456");
  EXPECT_EQ(level.textures[portal.lower.value().texture.index()], "#123456");
}

TEST(Texture, ofAnOpeningIsNoneOfItsSteps) {
  const Level level =
      loadSectors(sectorText("a", kRoom,
                             "[{'texture': '#808080'}, {'next': 'b', 'middle': '#123456 2,2'}, "
                             "{'texture': '#808080'}, {'texture': '#808080'}]") +
                  "," +
                  sectorText("b", "4,0, 8,0, 8,4, 4,4",
                             "[{'texture': '#808080'}, {'texture': '#808080'}, {'texture': "
                             "'#808080'}, {'walls': [{'z': 1, 'texture': '#808080'}, {'next': 'a', "
                             "'middle': '#654321'}]}]"))
          .level;
  const Portal& portal = std::get<Portal>(level.segments[1].wall);
  EXPECT_EQ(level.textures[portal.maskedMiddle.value().texture.index()], "#123456");
  EXPECT_FALSE(portal.upper);
  const Stack& stack = std::get<Stack>(level.segments[7].wall);
  const Portal& inStack = std::get<Portal>(stack.subWalls[1].kind);
  EXPECT_EQ(level.textures[inStack.maskedMiddle.value().texture.index()], "#654321");
}

TEST(Texture, ofAPlainColourIsOnePixel) {
  const LoadedLevel loaded = loadSectors(sectorText("a", kRoom, "{'texture': '#0a0B0c'}"));
  ASSERT_EQ(loaded.textures.size(), loaded.level.textures.size());
  const TextureId id = std::get<Solid>(loaded.level.segments[0].wall).texture.texture;
  EXPECT_EQ(loaded.textures[id.index()], Image(1, 1, {10, 11, 12}));
}

TEST(Texture, ofOneNameIsLoadedOnce) {
  const LoadedLevel loaded =
      loadSectors(sectorText("a", kRoom,
                             "[{'texture': '#808080'}, {'texture': '#808080 2,2'}, {'texture': "
                             "'#808080'}, {'texture': {'name': '#404040'}}]"));
  EXPECT_EQ(loaded.level.textures.size(), 2U);
}

/// A level in `levels/` of a folder of its own, whose only image is called "wall".
class TextureSearch : public testing::Test {
 protected:
  void addImage(const std::filesystem::path& path, Rgb color) {
    std::filesystem::create_directories((folder_.path() / path).parent_path());
    ASSERT_TRUE(writePng(folder_.path() / path, Image(1, 1, color)));
  }

  Rgb load(const std::string& more = "") {
    const LoadResult result = loadLevel(folder_.write(
        "levels/level.json",
        "{\"light\": 1, " + more +
            "\"sectors\": {\"a\": {\"floor\": {\"texture\": \"wall\"}, \"ceiling\": {\"texture\": "
            "\"wall\"}, \"loops\": {\"border\": {\"v\": [0,0, 1,0, 1,1], \"walls\": {\"texture\": "
            "\"wall\"}}}}}}"));
    EXPECT_TRUE(result.loaded) << listed(result);
    return result.loaded ? result.loaded->textures[0].at(0, 0) : Rgb{};
  }

 private:
  test::TemporaryFolder folder_;
};

/// Two rooms whose portal has a texture for a step up.
class TextureOfAStep : public testing::Test {
 protected:
  LoadResult load(double nextFloor, const std::string& more = "") {
    const auto sector = [](const std::string& name, const std::string& v, double floor,
                           const std::string& walls) {
      return fmt::format(
          R"("{}": {{"floor": {{"z": {}, "texture": "wall"}}, "ceiling": {{"texture": "wall"}},)"
          R"( "loops": {{"border": {{"v": [{}], "walls": [{}]}}}}}})",
          name, floor, v, walls);
    };
    const std::string solid = R"({"texture": "wall"})";
    return loadLevel(folder_.write(
        "levels/level.json",
        R"({"light": 1, "sectors": {)" +
            sector(
                "a", "0,0, 4,0, 4,4, 0,4", 0,
                fmt::format(R"({0}, {{"next": "b", "lower": "step"{1}}}, {0}, {0})", solid, more)) +
            ", " +
            sector("b", "4,0, 8,0, 8,4, 4,4", nextFloor,
                   fmt::format(R"({0}, {0}, {0}, {{"next": "a"}})", solid)) +
            "}}"));
  }

  void addImage(const std::string& name, const Image& image) {
    const auto file = folder_.path() / "textures" / name;
    std::filesystem::create_directories(file.parent_path());
    ASSERT_TRUE(writePng(file, image));
  }

  test::TemporaryFolder folder_;
};

TEST_F(TextureOfAStep, hasItsHolesWhereItHangsInTheOpening) {
  Image grille(3, 2);
  grille.makeHole(2, 1);
  addImage("wall.png", grille);
  addImage("step.png", grille);
  const LoadResult level = load(1, R"(, "middle": "step")");
  ASSERT_TRUE(level.loaded) << listed(level);
  const Level& found = level.loaded->level;
  ASSERT_EQ(found.holes.size(), found.textures.size());
  for (std::size_t i = 0; i < found.textures.size(); ++i) {
    EXPECT_EQ(found.holes[i].isHole(2, 1), found.textures[i] == "step") << "walls have none";
    EXPECT_FALSE(found.holes[i].isHole(1, 1));
  }
}

TEST_F(TextureOfAStep, isDecodedOnlyWhereTheStepIs) {
  addImage("wall.png", Image(3, 2));
  addImage("step.png", Image(5, 4));
  const LoadResult level = load(0);
  ASSERT_TRUE(level.loaded) << listed(level);
  EXPECT_EQ(level.loaded->decodedImages, 1U) << "once, though many surfaces wear it";
  EXPECT_EQ(level.loaded->files.size(), 3U) << "all are to be watched";
  const LoadResult stepped = load(1);
  ASSERT_TRUE(stepped.loaded) << listed(stepped);
  EXPECT_EQ(stepped.loaded->decodedImages, 2U);
  const auto hasSize = [](int width, int height) {
    return [=](const Image& image) { return image.width() == width && image.height() == height; };
  };
  EXPECT_TRUE(std::ranges::any_of(level.loaded->textures, hasSize(1, 1)));
  EXPECT_TRUE(std::ranges::any_of(stepped.loaded->textures, hasSize(5, 4)));
}

TEST_F(TextureOfAStep, mustBeAnImageThoughNoStepIsThere) {
  addImage("wall.png", Image(3, 2));
  EXPECT_EQ(countErrors(load(0)), 1U) << "there is none";
  folder_.write("textures/step.png", "no image");
  EXPECT_EQ(countErrors(load(0)), 1U);
}

TEST_F(TextureSearch, looksIntoTexturesBesideTheLevelsFolderThenIntoThatItself) {
  addImage("levels/wall.png", {1, 0, 0});
  EXPECT_EQ(load(), (Rgb{1, 0, 0}));
  addImage("textures/wall.png", {2, 0, 0});
  EXPECT_EQ(load(), (Rgb{2, 0, 0}));
}

TEST_F(TextureSearch, looksOnlyIntoTheFolderThatTheLevelNames) {
  addImage("textures/wall.png", {2, 0, 0});
  addImage("mine/wall.png", {3, 0, 0});
  EXPECT_EQ(load("\"textures\": \"../mine\", "), (Rgb{3, 0, 0}));
}

TEST_F(TextureSearch, prefersPngToTheOtherKinds) {
  addImage("textures/wall.bmp", {4, 0, 0});  // its content tells that it is a PNG
  EXPECT_EQ(load(), (Rgb{4, 0, 0}));
  addImage("textures/wall.jpg", {5, 0, 0});
  EXPECT_EQ(load(), (Rgb{5, 0, 0}));
  addImage("textures/wall.png", {6, 0, 0});
  EXPECT_EQ(load(), (Rgb{6, 0, 0}));
}

/// A room of 40 walls with an image on each, "image0" to "image39".
class TexturesReadInThreads : public testing::Test {
 protected:
  static constexpr int kImages = 40;

  void write(int image, std::string_view content) {
    folder_.write(fmt::format("textures/image{}.png", image), content);
  }
  void writeAll() {
    std::filesystem::create_directories(folder_.path() / "textures");
    for (int i = 0; i < kImages; ++i)
      ASSERT_TRUE(writePng(folder_.path() / fmt::format("textures/image{}.png", i),
                           Image(1 + i, 2, {static_cast<std::uint8_t>(i), 0, 0})));
  }

  LoadResult load() {
    std::string vertices;
    std::string walls;
    for (int i = 0; i < kImages; ++i) {
      const double angle = 2 * std::numbers::pi * i / kImages;
      vertices += fmt::format("{}{:.3f},{:.3f}", i == 0 ? "" : ", ", 9 * std::cos(angle),
                              9 * std::sin(angle));
      walls += fmt::format("{}{{\"texture\": \"image{}\"}}", i == 0 ? "" : ",\n", i);
    }
    return loadLevel(folder_.write(
        "levels/level.json",
        fmt::format(R"({{"light": 1, "sectors": {{"a": {{"floor": {{"texture": "#000000"}},)"
                    R"( "ceiling": {{"texture": "#000000"}}, "loops": {{"border": {{"v": [{}],)"
                    R"( "walls": [{}]}}}}}}}}}})",
                    vertices, walls)));
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(TexturesReadInThreads, areThoseOfTheirNames) {
  writeAll();
  const LoadResult room = load();
  ASSERT_TRUE(room.loaded) << listed(room);
  EXPECT_EQ(room.loaded->decodedImages, kImages);
  for (std::size_t i = 0; i < room.loaded->textures.size(); ++i) {
    const std::string& name = room.loaded->level.textures[i];
    if (name.starts_with('#')) continue;
    const Image& image = room.loaded->textures[i];
    EXPECT_EQ(fmt::format("image{}", image.width() - 1), name);
    EXPECT_EQ(image.at(0, 0).r, image.width() - 1);
  }
}

TEST_F(TexturesReadInThreads, areReportedInTheOrderOfTheFile) {
  writeAll();
  for (int i = 0; i < kImages; i += 3) write(i, "no image");
  for (int i = 1; i < kImages; i += 3) write(i, std::string("\x89PNG\r\n\x1a\n", 8));
  const LoadResult room = load();
  EXPECT_EQ(countErrors(room), 27U) << listed(room);
  int last = 0;
  for (const Diagnostic& diagnostic : room.diagnostics) {
    EXPECT_GT(diagnostic.line, last) << format(diagnostic);
    last = diagnostic.line;
  }
}

}  // namespace
}  // namespace hearth
