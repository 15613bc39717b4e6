// How surfaces that shine are drawn.

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

#include "render/renderer.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr std::string_view kEmitters =
    "{'lights':[],'emit':{'#c86432':{'intensity':51,'color':'#ff8000'},"
    "'#00c800':{'intensity':510}}}";

/// The picture of a room with that sector light, whose walls are the first emitter's, and whose
/// only light is that of its sector and of what shines.
Image pictureOf(double sectorLight, LightMode mode, std::string_view more = "",
                const std::vector<test::NamedText>& models = {}) {
  const LoadedLevel loaded = test::levelFrom(
      "{'light':" + std::to_string(sectorLight) + ",'sectors':{" +
          test::sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 4, "{'texture':'#c86432'}") +
          "},'things':[" + std::string(more) + "]}",
      kEmitters, models);
  Level dark = loaded.level;
  dark.lights.clear();
  const BakedLight none = bake({dark, loaded.geometry}, dark.bake, 2);
  const Camera camera{SectorId(0), {4, 4, 2}, 0, 0, 90, 96, 72};
  return Renderer(loaded.scene(), loaded.textures, none).draw(camera, mode);
}

Rgb middleOf(const Image& picture) { return picture.at(picture.width() / 2, picture.height() / 2); }

TEST(Glow, AddsToTheLightOfTheSectorInEachChannel) {
  EXPECT_EQ(middleOf(pictureOf(0, LightMode::Both)), (Rgb{40, 10, 0}));
  EXPECT_EQ(middleOf(pictureOf(0.5, LightMode::Both)), (Rgb{140, 60, 25}));
  EXPECT_EQ(middleOf(pictureOf(0, LightMode::Only)), (Rgb{51, 26, 0}));
  EXPECT_EQ(middleOf(pictureOf(0.25, LightMode::None)), (Rgb{200, 100, 50}));
}

TEST(Glow, IsOfNoOtherTexture) {
  const Image picture = pictureOf(0, LightMode::Only);
  EXPECT_EQ(picture.at(picture.width() / 2, picture.height() - 1), (Rgb{0, 0, 0})) << "the floor";
}

/// A panel of two faces that show the first emitter, the second, and none.
TEST(Glow, IsThatOfEachFaceOfAMesh) {
  constexpr std::string_view kPanel =
      "mtllib panel.mtl\nv 0 0 3\nv 0 0 1\nv 0 0 -1\nv 0 0 -3\nv 0 4 3\nv 0 4 1\nv 0 4 -1\nv 0 4 "
      "-3\n"
      "usemtl dim\nf 1 5 6 2\nusemtl bright\nf 2 6 7 3\nusemtl dark\nf 3 7 8 4\n";
  constexpr std::string_view kColors =
      "newmtl dim\nKd 0.784314 0.392157 0.196078\nnewmtl bright\nKd 0 0.784314 0\n"
      "newmtl dark\nKd 0 0 0.784314\n";
  // Narrow faces are painted together.
  for (const std::string scale : {"1", "0.5"}) {
    const Image picture = pictureOf(0, LightMode::Both,
                                    "{'mesh':'panel.obj','x':6,'y':4,'z':0,'scale':" + scale + "}",
                                    {{"panel.obj", kPanel}, {"panel.mtl", kColors}});
    std::set<std::tuple<int, int, int>> colors;
    for (int column = 0; column < picture.width(); ++column) {
      const Rgb color = picture.at(column, picture.height() / 2);
      colors.insert({color.r, color.g, color.b});
    }
    EXPECT_EQ(colors, (std::set<std::tuple<int, int, int>>{{40, 10, 0}, {0, 200, 0}, {0, 0, 0}}))
        << scale;
  }
}

}  // namespace
}  // namespace hearth
