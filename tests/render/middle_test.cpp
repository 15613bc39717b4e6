// What shows of masked middle textures, and through them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/renderer.h"
#include "support/baked_room.h"
#include "support/canvas.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::sectorText;

constexpr int kSize = 64;  // pixels each way
constexpr Rgb kWall = {10, 20, 30};
constexpr Rgb kNear = {200, 0, 0};
constexpr Rgb kFar = {0, 200, 0};

std::string portalTo(std::string_view next, std::string_view more = "") {
  return fmt::format("{{'next':'{}'{}}}", next, more);
}

std::string room(std::string_view name, int from, int to, const std::string& east,
                 const std::string& west) {
  const std::string solid = "{'texture':'#0a141e'}";
  return sectorText(name, fmt::format("{0},-2, {1},-2, {1},2, {0},2", from, to), 0, 4,
                    fmt::format("[{0},{1},{0},{2}]", solid, east, west));
}

/// Three rooms in a row along x, 4 m each, which open to each other all across.
LoadedLevel rooms(std::string_view first, std::string_view second, std::string_view back = "") {
  const std::string solid = "{'texture':'#0a141e'}";
  return test::levelFrom(fmt::format("{{'light':1,'sectors':{{{},{},{}}}}}",
                                     room("a", 0, 4, portalTo("b", first), solid),
                                     room("b", 4, 8, portalTo("c", second), portalTo("a", back)),
                                     room("c", 8, 12, solid, portalTo("b"))));
}

/// The textures of a level, plain in their colours. Those that hang in openings
/// have a hole in their left half.
std::vector<Image> texturesOf(const Level& level) {
  std::vector<Image> images;
  for (const std::string& name : level.textures) {
    Image& image = images.emplace_back(2, 1,
                                       name == "#c80000"   ? kNear
                                       : name == "#00c800" ? kFar
                                                           : kWall);
    if (name == "#c80000" || name == "#00c800") image.makeHole(0, 0);
  }
  return images;
}

Image drawn(const LoadedLevel& loaded, double angle, double x, DrawSettings settings = {},
            LightMode mode = LightMode::None) {
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const SectorId sector(static_cast<std::size_t>(x / 4));
  return Renderer(loaded.scene(), texturesOf(loaded.level), light, settings)
      .draw({sector, {x, 0.001, 2}, angle, 0, 90, kSize, kSize}, mode);
}

// Looking east from x = 1 the opening at x = 4 fills the middle third of each half: 4 m of it at a
// depth of 3 m. Its left end is at y = -2.
constexpr std::string_view kNearMiddle = ",'middle':'#c80000 4,4'";
constexpr std::string_view kFarMiddle = ",'middle':'#00c800 4,4'";

TEST(MiddleTextures, showWhereTheyAreSolidAndWhatIsBehindWhereTheyAreNot) {
  const Image picture = drawn(rooms(kNearMiddle, ""), 0, 1);
  EXPECT_EQ(picture.at(kSize / 2 + 4, kSize / 2), kNear);
  EXPECT_EQ(picture.at(kSize / 2 - 4, kSize / 2), kWall) << "the far wall, through the hole";
}

TEST(MiddleTextures, showFarOnesThroughTheHolesOfNearOnes) {
  const Image picture = drawn(rooms(kNearMiddle, ",'middle':'#00c800 2,4'"), 0, 1);
  EXPECT_EQ(picture.at(kSize / 2 + 4, kSize / 2), kNear) << "what is nearer";
  // At a depth of 7 m the far one has holes for 2 m from its left end on, and again after 2 m.
  EXPECT_EQ(picture.at(kSize / 2 - 2, kSize / 2), kFar);
}

TEST(MiddleTextures, areSeenFromTheirFrontAlone) {
  const LoadedLevel loaded = rooms(kNearMiddle, "");
  const Image picture = drawn(loaded, 180, 7);
  for (const Rgb pixel : picture.pixels()) ASSERT_FALSE(pixel == kNear);
}

TEST(MiddleTextures, areSeenFromBothSidesWhereBothHaveOne) {
  const Image picture = drawn(rooms(kNearMiddle, "", kFarMiddle), 180, 7);
  EXPECT_EQ(picture.at(kSize / 2 + 4, kSize / 2), kFar);
}

TEST(MiddleTextures, haveTheSameHolesWithAllSettings) {
  const LoadedLevel loaded = rooms(kNearMiddle, kFarMiddle);
  const Image exact = drawn(loaded, 10, 1);
  for (const DrawSettings settings : {DrawSettings{.textureFilter = TextureFilter::Bilinear},
                                      DrawSettings{.textureFilter = TextureFilter::Mipmapped},
                                      DrawSettings{.lightFilter = LightFilter::Nearest}})
    EXPECT_EQ(drawn(loaded, 10, 1, settings), exact);
}

TEST(MiddleTextures, haveHolesInPicturesOfLightToo) {
  const Image picture = drawn(rooms(kNearMiddle, ""), 0, 1, {}, LightMode::Only);
  for (const Rgb pixel : picture.pixels()) ASSERT_EQ(pixel, (Rgb{255, 255, 255}));
}

TEST(MiddleTextures, areNoOverdraw) {
  const LoadedLevel loaded = rooms(kNearMiddle, kFarMiddle);
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const Renderer renderer(loaded.scene(), texturesOf(loaded.level), light);
  const Camera camera{SectorId(0), {1, 0, 2}, 0, 0, 90, kSize, kSize};
  const Image overdraw = renderer.draw(camera, Channel::Overdraw);
  for (const Rgb pixel : overdraw.pixels()) ASSERT_EQ(pixel, (Rgb{0, 160, 0}));
  const Image surfaces = renderer.draw(camera, Channel::Surface);
  EXPECT_FALSE(surfaces.at(kSize / 2 + 4, kSize / 2) == surfaces.at(kSize / 2 - 4, kSize / 2));
}

TEST(MiddleTextures, areCountedAndCostNothingWhereThereAreNone) {
  const auto spansOf = [](const LoadedLevel& loaded) {
    const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
    FrameScratch scratch;
    test::Canvas picture(kSize, kSize);
    Renderer(loaded.scene(), texturesOf(loaded.level), light)
        .draw({SectorId(0), {1, 0, 2}, 0, 0, 90, kSize, kSize}, LightMode::None, scratch, picture);
    return scratch.found().maskedSpans;
  };
  EXPECT_EQ(spansOf(rooms("", "")), 0U);
  EXPECT_EQ(spansOf(rooms(kNearMiddle, "")), 42U) << "4 m at 3 m deep, of 64 columns for 6 m";
}

}  // namespace
}  // namespace hearth
