// What shows of meshes, and before and behind them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "support/in_tree.h"
#include "support/level_text.h"
#include "things_in_halls.h"

namespace hearth {
namespace {

using test::count;
using test::drawn;
using test::hall;
using test::halves;
using test::kGreen;
using test::kRed;
using test::kSize;
using test::kWall;
using test::lookingEast;
using test::sectorText;

constexpr Rgb kBlue = {0, 0, 200};

/// Red sides, a blue top and a green bottom, 1 m each way around its centre below.
constexpr std::string_view kBox =
    "mtllib box.mtl\n"
    "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\n"
    "v -0.5 1 -0.5\nv 0.5 1 -0.5\nv 0.5 1 0.5\nv -0.5 1 0.5\n"
    "usemtl side\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n"
    "usemtl top\nf 8 7 6 5\nusemtl bottom\nf 1 2 3 4\n";
constexpr std::string_view kBoxColors =
    "newmtl side\nKd 0.784314 0 0\nnewmtl top\nKd 0 0 0.784314\nnewmtl bottom\nKd 0 0.784314 0\n";
/// A square, 1 m each way, that faces x < 0. Its corners of the image are those of its picture.
constexpr std::string_view kPanel =
    "v 0 0 0.5\nv 0 0 -0.5\nv 0 1 -0.5\nv 0 1 0.5\n"
    "vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nf 1/1 4/4 3/3 2/2\n";

/// A level of rooms with these things, of which one may be "more.obj".
LoadedLevel levelWith(std::string_view things, std::string_view sectors,
                      std::string_view more = "") {
  return test::levelWith(
      things, sectors,
      {{"box.obj", kBox}, {"box.mtl", kBoxColors}, {"panel.obj", kPanel}, {"more.obj", more}});
}

int differences(const Image& a, const Image& b) {
  int pixels = 0;
  for (int row = 0; row < a.height(); ++row)
    for (int column = 0; column < a.width(); ++column)
      pixels += a.at(column, row) != b.at(column, row) ? 1 : 0;
  return pixels;
}

TEST(Meshes, standWhereTheyArePlaced) {
  // Its front is 4 m deep: a metre is 8 pixels. Its lower edge is 2 m below the eye.
  const Image picture = drawn(levelWith("{'mesh':'box.obj','x':5,'y':0}", hall()), lookingEast());
  for (int row = 44; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const bool covered = column >= 28 && column < 36 && row < 48;
      ASSERT_EQ(picture.at(column, row) == kRed, covered) << column << ' ' << row;
    }
  EXPECT_GT(count(picture, kBlue), 0) << "its top";
  EXPECT_EQ(count(picture, kGreen), 0) << "its bottom";
}

TEST(Meshes, areScaledTurnedAndMoved) {
  const Image picture =
      drawn(levelWith("{'mesh':'box.obj','x':5,'y':1,'z':1,'scale':[4,2,0.5],'angle':90}", hall()),
            lookingEast());
  // After the turn 2 m along x and 4 m along y: from x = 4 on, 3.5 m deep.
  for (int row = 32; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const double y = (column + 0.5 - 32) / 32 * 3.5 + 0.001;
      const double z = 2 - (row + 0.5 - 32) / 32 * 3.5;
      const bool covered = y > -1 && y < 3 && z > 1 && z < 1.5;
      ASSERT_EQ(picture.at(column, row) == kRed, covered) << column << ' ' << row;
    }
}

TEST(Meshes, equalAColumnOfWallsWithAStep) {
  const std::string pillar =
      "'hall': { 'floor': {'z': 0, 'texture': '#808080'}, 'ceiling': {'z': 4, 'texture': "
      "'#808080'}, 'loops': {'border': {'v': [0,-4, 8,-4, 8,4, 0,4], 'walls': {'texture': "
      "'#808080'}}, 'hole': {'v': [4.5,-0.5, 4.5,0.5, 5.5,0.5, 5.5,-0.5], 'walls': "
      "{'next':'pillar','lower':'#c80000'}}}},"
      "'pillar': { 'floor': {'z': 1, 'texture': '#0000c8'}, 'ceiling': {'z': 4, 'texture': "
      "'#808080'}, 'loops': {'border': {'v': [4.5,-0.5, 5.5,-0.5, 5.5,0.5, 4.5,0.5], 'walls': "
      "{'next':'hall'}}}}";
  const LoadedLevel walls = test::levelFrom("{'light':1,'sectors':{" + pillar + "}}");
  const LoadedLevel box = levelWith("{'mesh':'box.obj','x':5,'y':0}", hall());
  for (const double angle : {0.0, 17.0, -33.0, 41.0})
    for (const double pitch : {0.0, -30.0})
      for (const Vec3 eye : {Vec3{0.5, 0.003, 2}, Vec3{3.3, 1.1, 1.7}, Vec3{3.9, -0.4, 1.001}}) {
        Camera camera = lookingEast();
        camera.eye = eye;
        camera.angle = angle;
        camera.pitch = pitch;
        camera.width = camera.height = 200;
        EXPECT_EQ(differences(drawn(box, camera), drawn(walls, camera)), 0)
            << angle << ' ' << eye.x;
      }
}

TEST(Meshes, showTheirFrontsAndIfTwoSidedTheirBacks) {
  const auto reds = [](std::string_view more) {
    return count(drawn(levelWith(fmt::format("{{'mesh':'panel.obj','x':4.5,'y':0,"
                                             "'texture':'#c80000'{}}}",
                                             more),
                                 hall()),
                       lookingEast()),
                 kRed);
  };
  EXPECT_EQ(reds(""), 64);
  EXPECT_EQ(reds(",'angle':180"), 0);
  EXPECT_EQ(reds(",'angle':180,'twoSided':true"), 64);
}

TEST(Meshes, showOnceWhereAnOpeningDividesThem) {
  for (const std::string_view thing :
       {"{'mesh':'box.obj','x':3.8,'y':0.7}", "{'mesh':'box.obj','x':3.6,'y':0.7,'angle':33}",
        "{'mesh':'box.obj','x':4.3,'y':-1,'z':0.3,'scale':[3,1,0.4]}"}) {
    for (const double angle : {0.0, 30.0, -30.0}) {
      Camera camera = lookingEast();
      camera.angle = angle;
      const Image picture = drawn(levelWith(thing, halves()), camera);
      EXPECT_EQ(picture, drawn(levelWith(thing, hall()), camera)) << thing << ' ' << angle;
    }
  }
}

TEST(Meshes, doNotShowBehindASolidWallThatTheyReachThrough) {
  const std::string rooms = sectorText("west", "0,-4, 4,-4, 4,4, 0,4", 0, 4) + "," +
                            sectorText("east", "4,-4, 8,-4, 8,4, 4,4", 0, 4);
  const std::string box = "{'mesh':'box.obj','x':3.8,'y':0,'z':1.5}";
  EXPECT_GT(count(drawn(levelWith(box, rooms), lookingEast()), kRed), 0);
  Camera behind = lookingEast(7);
  behind.sector = SectorId(1);
  behind.angle = 180;
  EXPECT_EQ(count(drawn(levelWith(box, rooms), behind), kRed), 0);
  EXPECT_EQ(count(drawn(levelWith(box, rooms), behind), kWall), kSize * kSize);
}

TEST(Meshes, areCutWhereTheyReachIntoFloorAndWall) {
  const Image whole =
      drawn(levelWith("{'mesh':'box.obj','x':7,'y':3,'z':0}", hall()), lookingEast());
  const Image sunk = drawn(levelWith("{'mesh':'box.obj','x':7,'y':3,'z':0,'scale':[1,1,1]},"
                                     "{'mesh':'box.obj','x':7.8,'y':3.8,'z':0,'scale':[1,1,0.9]}",
                                     hall()),
                           lookingEast());
  EXPECT_LT(differences(whole, sunk), 40) << "the second one is nearly in the corner";
  const Image low = drawn(levelWith("{'mesh':'box.obj','x':5,'y':0,'z':0,'scale':[1,1,8]}", hall()),
                          lookingEast());
  EXPECT_EQ(count(low, kBlue), 0) << "the top is above the ceiling";
  EXPECT_EQ(low.at(32, 0), kWall) << "the ceiling is before it";
}

TEST(Meshes, areBeforeAndBehindSpritesByTheirDepth) {
  const std::string panel = "{'mesh':'panel.obj','x':4.5,'y':0,'z':1.5,'texture':'#c80000'}";
  const auto pixel = [&](std::string_view sprite) {
    return drawn(levelWith(panel + "," + std::string(sprite), hall()), lookingEast()).at(32, 32);
  };
  EXPECT_EQ(pixel("{'sprite':'#00c800','x':4,'y':0,'z':1.5,'size':[1,1]}"), kGreen);
  EXPECT_EQ(pixel("{'sprite':'#00c800','x':5,'y':0,'z':1.5,'size':[1,1]}"), kRed);
  EXPECT_EQ(pixel("{'sprite':'#00c800','x':4.5,'y':0,'z':1.5,'size':[1,1]}"), kGreen)
      << "at one depth the later thing is seen";
  EXPECT_EQ(
      drawn(levelWith("{'sprite':'#00c800','x':4.5,'y':0,'z':1.5,'size':[1,1]}," + panel, hall()),
            lookingEast())
          .at(32, 32),
      kRed);
  // What lies 1 m below the eye crosses the panel 4 m before it.
  const Image crossed =
      drawn(levelWith("{'mesh':'panel.obj','x':4.5,'y':0,'z':0.5,'texture':'#c80000'},"
                      "{'sprite':'#00c800','x':4.5,'y':0,'z':1,'size':[2,2],'facing':'flat'}",
                      hall()),
            lookingEast());
  EXPECT_EQ(crossed.at(32, 39), kRed) << "it is before what lies behind it";
  EXPECT_EQ(crossed.at(32, 40), kGreen) << "and behind what lies before it";
}

TEST(Meshes, areHiddenByNearerOnesWhateverTheirOrder) {
  const std::string near = "{'mesh':'panel.obj','x':3,'y':0,'z':1.5,'texture':'#c80000'}";
  const std::string far = "{'mesh':'panel.obj','x':5,'y':0,'z':1.5,'texture':'#00c800'}";
  for (const std::string& both : {near + "," + far, far + "," + near}) {
    const Image picture = drawn(levelWith(both, hall()), lookingEast());
    EXPECT_EQ(picture.at(32, 32), kRed);
    EXPECT_EQ(count(picture, kGreen), 0);
  }
}

TEST(Meshes, hideWhatIsInTheSamePlaneOfTheLevel) {
  // At the wall of x = 8.
  const Image picture =
      drawn(levelWith("{'mesh':'panel.obj','x':8,'y':0,'z':1.5,'texture':'#c80000'}", hall()),
            lookingEast());
  EXPECT_EQ(count(picture, kRed), 4 * 4);
}

/// 8 m wide and 4 m high, of so many squares each way, with an image that repeats once a metre.
std::string sheetOf(int squares) {
  std::string sheet;
  for (int i = 0; i <= squares; ++i)
    for (int k = 0; k <= squares; ++k)
      sheet += fmt::format("v 0 {1} {0}\nvt {2} {1}\n", 4 - 8.0 * i / squares, 4.0 * k / squares,
                           8 - 8.0 * i / squares);
  for (int i = 0; i < squares; ++i)
    for (int k = 0; k < squares; ++k) {
      const int corner = i * (squares + 1) + k + 1;
      const int next = corner + squares + 1;
      sheet +=
          fmt::format("f {0}/{0} {1}/{1} {2}/{2} {3}/{3}\n", corner, corner + 1, next + 1, next);
    }
  return sheet;
}

/// One square is a wide face, twelve have narrow ones: these are painted in another way.
class MeshOfSquares : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(WideAndNarrow, MeshOfSquares, testing::Values(1, 12));

TEST_P(MeshOfSquares, wearsItsImageAsAWallDoes) {
  const auto textured = [](std::string_view east) {
    return sectorText("hall", "0,-4, 8,-4, 8,4, 0,4", 0, 4,
                      fmt::format("[{{'texture':'#808080'}},{{'texture':{}}},"
                                  "{{'texture':'#808080'}},{{'texture':'#808080'}}]",
                                  east));
  };
  const std::string folder = test::inTree("textures").string();
  const LoadedLevel worn = test::levelFrom("{'light':1,'textures':'" + folder + "','sectors':{" +
                                           textured("{'name':'brick','scale':[1,1]}") + "}}");
  const LoadedLevel mesh = test::levelFrom(
      "{'light':1,'textures':'" + folder +
          "','things':[{'mesh':'sheet.obj','x':8,'y':0,'z':0,'texture':'brick'}],'sectors':{" +
          textured("'#808080'") + "}}",
      "[]", {{"sheet.obj", sheetOf(GetParam())}});
  std::vector<TextureFilter> filters = {TextureFilter::Nearest, TextureFilter::Bilinear};
  // Walls have one mip level in eight columns, narrow faces one in each: they are not alike.
  if (GetParam() == 1) filters.push_back(TextureFilter::Mipmapped);
  for (const TextureFilter filter : filters)
    for (const double angle : {0.0, 25.0, -40.0}) {
      Camera camera = lookingEast(5.013);
      camera.angle = angle;
      DrawSettings settings;
      settings.textureFilter = filter;
      const int pixels = differences(drawn(mesh, camera, LightMode::Both, settings),
                                     drawn(worn, camera, LightMode::Both, settings));
      EXPECT_LE(pixels, kSize * kSize / 200)
          << static_cast<int>(filter) << " at " << angle << ": rounding at edges of texels";
    }
}

TEST(Meshes, leaveNoHoleBetweenTheirFaces) {
  // A bumpy sheet of 40 x 40 squares before the far wall.
  std::string sheet;
  constexpr int kCells = 40;
  for (int i = 0; i <= kCells; ++i)
    for (int k = 0; k <= kCells; ++k)
      sheet += fmt::format("v {} {} {}\n", 0.3 * ((i * 7 + k * 13) % 11) / 11.0, -0.5 + 0.13 * i,
                           4.7 - 0.235 * k);
  for (int i = 0; i < kCells; ++i)
    for (int k = 0; k < kCells; ++k) {
      const int corner = i * (kCells + 1) + k + 1;
      sheet += fmt::format("f {} {} {} {}\n", corner, corner + 1, corner + kCells + 2,
                           corner + kCells + 1);
    }
  const LoadedLevel loaded = levelWith(
      "{'mesh':'more.obj','x':7,'y':0,'z':0,'texture':'#c80000','twoSided':true}", hall(), sheet);
  for (const double angle : {0.0, 11.0, -23.0})
    for (const double x : {0.5, 4.0, 6.5}) {
      Camera camera = lookingEast(x);
      camera.angle = angle;
      camera.fov = 60;
      camera.width = 333;
      camera.height = 177;
      const Image picture = drawn(loaded, camera);
      const auto isRed = [&](int column, int row) { return picture.at(column, row) == kRed; };
      for (int row = 1; row + 1 < camera.height; ++row)
        for (int column = 1; column + 1 < camera.width; ++column)
          ASSERT_FALSE(!isRed(column, row) && isRed(column - 1, row) && isRed(column + 1, row) &&
                       isRed(column, row - 1) && isRed(column, row + 1))
              << angle << ' ' << x << ": " << column << ' ' << row;
    }
}

TEST(Meshes, coverEachPixelOfAnEdgeOnce) {
  // Four squares that meet straight before the eye, in the centre of a pixel: their left and upper
  // edges belong to them.
  const std::string squares =
      "mtllib box.mtl\n"
      "v 0 1 -1\nv 0 1 0\nv 0 1 1\nv 0 2 -1\nv 0 2 0\nv 0 2 1\nv 0 3 -1\nv 0 3 0\nv 0 3 1\n"
      "usemtl bottom\nf 1 2 5 4\nf 2 3 6 5\nusemtl side\nf 4 5 8 7\nusemtl top\nf 5 6 9 8\n";
  Camera camera = lookingEast();
  camera.eye.y = 0;
  camera.width = camera.height = kSize + 1;
  for (const int angle : {0, 180}) {
    const Image picture = drawn(
        levelWith(
            fmt::format("{{'mesh':'more.obj','x':4.5,'y':0,'z':0,'angle':{},'twoSided':true}}",
                        angle),
            hall(), squares),
        camera);
    const int middle = kSize / 2;
    for (int row = middle - 7; row <= middle + 7; ++row)
      for (int column = middle - 7; column <= middle + 7; ++column) {
        const Rgb above = (angle == 0 ? column < middle : column >= middle) ? kRed : kBlue;
        ASSERT_EQ(picture.at(column, row), row < middle ? above : kGreen)
            << angle << ": " << column << ' ' << row;
      }
  }
}

TEST(Meshes, areSeenFromInside) {
  const std::string box = "{'mesh':'box.obj','x':1,'y':0,'z':1.5,'scale':2,'twoSided':true}";
  Camera camera = lookingEast(1.2);
  camera.eye.z = 2.5;
  const Image picture = drawn(levelWith(box, hall()), camera);
  EXPECT_EQ(count(picture, kWall), 0) << "nothing is nearer than its sides";
  EXPECT_EQ(
      count(drawn(levelWith("{'mesh':'box.obj','x':1,'y':0,'z':1.5,'scale':2}", hall()), camera),
            kWall),
      kSize * kSize)
      << "it has no backs";
}

TEST(Meshes, haveTheSamePixelsOnAnyNumberOfThreads) {
  std::string things;
  for (int i = 0; i < 30; ++i)
    things += fmt::format("{}{{'mesh':'box.obj','x':{},'y':{},'angle':{},'scale':{}}}",
                          i > 0 ? "," : "", 1.05 + 0.2 * i, -3 + 0.2 * i, 37 * i, 0.3 + 0.05 * i);
  const LoadedLevel loaded = levelWith(things, halves());
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const Renderer renderer(loaded.scene(), loaded.textures, light);
  Camera camera = lookingEast();
  camera.width = 333;
  const Image alone = renderer.draw(camera, LightMode::Both);
  Workers workers(3);
  FrameScratch scratch;
  PixelBuffer memory;
  const PixelRows rows = memory.rows(camera.width, camera.height);
  renderer.draw(camera, LightMode::Both, scratch, rows, &workers);
  EXPECT_EQ(imageOf(rows), alone);
}

}  // namespace
}  // namespace hearth
