// What pictures may be less accurate in: that each setting does what it says, and no more.

#include <gtest/gtest.h>

#include <string>

#include "load/load.h"
#include "pixel_blocks.h"
#include "render/pixel_kernels.h"
#include "render/renderer.h"
#include "support/canvas.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::inAllColumns;
using test::minusFraction;
using test::pixelOfRow;
using test::setRows;

/// A level that is drawn twice, as exactly as possible and with settings.
class Drawn {
 public:
  explicit Drawn(LoadedLevel loaded)
      : loaded_(std::move(loaded)), light_(bake(loaded_.scene(), loaded_.level.bake, 2)) {}

  Image with(const DrawSettings& settings, const Camera& camera,
             LightMode mode = LightMode::Both) const {
    return Renderer(loaded_.scene(), loaded_.textures, light_, settings).draw(camera, mode);
  }
  PaintStats workOf(const DrawSettings& settings, const Camera& camera) const {
    FrameScratch scratch;
    test::Canvas picture(camera.width, camera.height);
    Renderer(loaded_.scene(), loaded_.textures, light_, settings)
        .draw(camera, LightMode::Both, scratch, picture);
    return scratch.painted;
  }
  bool isSame(const DrawSettings& settings, const Camera& camera, LightMode mode) const {
    return with(settings, camera, mode) == with({}, camera, mode);
  }
  bool changesAnyShot(const DrawSettings& settings) const {
    for (const Shot& shot : loaded_.level.shots)
      if (!isSame(settings, cameraOf(shot), LightMode::Both)) return true;
    return false;
  }

 private:
  LoadedLevel loaded_;
  BakedLight light_;
};

Camera cameraAt(Vec3 eye, double angle, double pitch = 0) {
  return {SectorId(0), eye, angle, pitch, 90, 320, 200};
}

/// A room of plain colours, with a lamp, and a floor of which a few rows are seen.
Drawn room() {
  return Drawn(
      test::levelFrom("{'sectors':{" + test::sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 4) + "}}",
                      "[{'x':2,'y':3,'z':3,'falloff':0.5,'color':'#ffc080'}]"));
}

TEST(DrawSettings, EachChangesAShotOfTheTutorial) {
  const Drawn tutorial(loadLevel(test::inTree("levels/tutorial.json")).loaded.value());
  EXPECT_TRUE(tutorial.changesAnyShot({.textureFilter = TextureFilter::Bilinear}));
  EXPECT_TRUE(tutorial.changesAnyShot({.textureFilter = TextureFilter::Mipmapped}));
  EXPECT_TRUE(tutorial.changesAnyShot({.lightFilter = LightFilter::Nearest}));
  EXPECT_TRUE(tutorial.changesAnyShot({.pixelSize = 2}));
}

TEST(DrawSettings, OfLightLeaveTexturesAsTheyAre) {
  const Drawn drawn = room();
  const Camera camera = cameraAt({1, 1, 2}, 45, -20);
  EXPECT_TRUE(drawn.isSame({.lightFilter = LightFilter::Nearest}, camera, LightMode::None));
}

TEST(DrawSettings, OfTexturesLeavePlainColoursAsTheyAre) {
  const Drawn drawn = room();
  const Camera camera = cameraAt({1, 1, 2}, 45, -20);
  for (const TextureFilter filter : {TextureFilter::Bilinear, TextureFilter::Mipmapped})
    for (const LightMode mode : {LightMode::Both, LightMode::None})
      EXPECT_TRUE(drawn.isSame({.textureFilter = filter}, camera, mode));
}

/// Black and white, texel by texel.
Image chessBoard() {
  Image board(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      if ((x + y) % 2 == 0) board.at(x, y) = {255, 255, 255};
  return board;
}

TEST(DrawSettings, MipmappedShowsMeansOfWhatIsFarAndTexelsOfWhatIsNear) {
  LoadedLevel hall = test::levelFrom(
      "{'sectors':{" + test::sectorText("hall", "0,0, 90,0, 90,20, 0,20", 0, 8) + "}}");
  hall.textures = SharedImages(std::vector<Image>(hall.textures.size(), chessBoard()));
  const Drawn drawn(std::move(hall));
  const Camera camera = cameraAt({1, 10, 1}, 0);
  const Image exact = drawn.with({}, camera, LightMode::None);
  const Image means =
      drawn.with({.textureFilter = TextureFilter::Mipmapped}, camera, LightMode::None);
  for (int column = 0; column < camera.width; ++column) {
    EXPECT_EQ(means.at(column, 199), exact.at(column, 199)) << column;  // 1.6 m off
    EXPECT_EQ(means.at(column, 104), (Rgb{128, 128, 128})) << column;   // 36 m off
  }
}

TEST(DrawSettings, MixTexelsBetweenTheirCentresAndAroundTheEdge) {
  PixelBlock block{};
  setRows(block, {0.5, 1.0, 7.75, -0.25});
  pixelKernels().findTexelsAround(block,
                                  inAllColumns({.u = {.place = {0, 1}}, .v = {.place = {0.5, 0}}}),
                                  Texture(Image(8, 1)));
  const std::uint32_t left[] = {0, 0, 7, 7};
  const std::uint32_t right[] = {1, 1, 0, 0};
  const double fractions[] = {0, 0.5, 0.25, 0.25};
  const auto& [upperLeft, upperRight, lowerLeft, lowerRight] = block.texels;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t pixel = pixelOfRow(k);
    EXPECT_EQ(upperLeft[pixel], left[k]) << k;
    EXPECT_EQ(upperRight[pixel], right[k]) << k;
    EXPECT_EQ(lowerLeft[pixel], left[k]) << k;
    EXPECT_EQ(lowerRight[pixel], right[k]) << k;
    EXPECT_EQ(block.betweenTexels.across[pixel], minusFraction(fractions[k])) << k;
    EXPECT_EQ(block.betweenTexels.down[pixel], 0U);
  }
}

TEST(DrawSettings, KeepSkiesWithinTheirImage) {
  PixelBlock block{};
  setRows(block, {-5.0, 1.25, 50.0});
  for (const std::uint32_t height : {1U, 4U}) {
    pixelKernels().findTexelsAround(block, inAllColumns({.isSky = true, .v = {.place = {0, 1}}}),
                                    Texture(Image(1, static_cast<int>(height))));
    const auto& [upperLeft, upperRight, lowerLeft, lowerRight] = block.texels;
    for (std::size_t k = 0; k < block.count(); ++k) {
      EXPECT_GE(lowerLeft[k], upperLeft[k]);
      EXPECT_LT(lowerLeft[k], height);
    }
  }
}

TEST(DrawSettings, SquaresOfPixelsShowWhatTheirMiddlesSee) {
  const Drawn drawn = room();
  Camera camera = cameraAt({6, 6, 2}, 225, 10);
  camera.width = 203;  // 67 squares and two pixels
  camera.height = 149;
  const Image all = drawn.with({}, camera);
  const Image squares = drawn.with({.pixelSize = 3}, camera);
  int differing = 0;
  for (int j = 0; j < camera.height; ++j)
    for (int i = 0; i < camera.width; ++i) {
      const int middleI = i / 3 * 3 + 1;
      const int middleJ = j / 3 * 3 + 1;
      ASSERT_EQ(squares.at(i, j), squares.at(i / 3 * 3, j / 3 * 3)) << i << ' ' << j;
      if (middleI >= camera.width || middleJ >= camera.height) continue;
      differing += squares.at(i, j) == all.at(middleI, middleJ) ? 0 : 1;
    }
  // The same rays, apart from rounding: at the edges of texels that can show the next one.
  EXPECT_LE(differing, camera.width * camera.height / 1000);
}

TEST(DrawSettings, CountThePixelsThatAreSaved) {
  const Drawn drawn = room();
  const Camera camera = cameraAt({6, 6, 2}, 225, 0);
  EXPECT_EQ(drawn.workOf({}, camera).pixels, 320U * 200);
  EXPECT_EQ(drawn.workOf({.pixelSize = 2}, camera).pixels, 160U * 100);
}

}  // namespace
}  // namespace hearth
