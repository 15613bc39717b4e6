// Walls, flats and slopes of extreme lengths, heights and textures.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "as_truth.h"
#include "render/segment_columns.h"
#include "rooms.h"
#include "support/canvas.h"

namespace hearth::extremes {
namespace {

using test::levelFrom;

Camera cameraAt(Vec3 eye, double angle, double pitch = 0) {
  return {SectorId(0), eye, angle, pitch, 90, 64, 40};
}

/// Metres along the authored wall in each column of a picture that shows one wall.
std::vector<double> placesAlongWall(const LoadedLevel& loaded, const Camera& camera) {
  const BakedLight light = noLightOf(loaded.level);
  FrameScratch scratch;
  test::Canvas picture(camera.width, camera.height);
  Renderer(loaded.scene(), loaded.textures, light).draw(camera, LightMode::None, scratch, picture);
  std::vector<double> places(static_cast<std::size_t>(camera.width), -1);
  const SegmentId wall(0);
  scratch.forEachSpan([&](const Span& span) {
    if (loaded.level[span.surface].segment == wall)
      places[static_cast<std::size_t>(span.column)] = span.fraction * loaded.level[wall].length;
  });
  return places;
}

TEST(Wall, ofAnyLengthShowsItsTextureWhereItIs) {
  constexpr double kTexel = 1.0 / 64;  // metres: of an image of 64 x 64 a metre wide
  for (const double length : {1e3, 1e4, 1e5}) {
    const LoadedLevel hall = levelFrom(
        levelOf(BoxRoom{.x1 = length, .ceiling = 10, .wallTexture = "'brick'"}.sector("hall")));
    for (const double fraction : {0.0, 0.1, 0.33, 0.77, 0.999}) {
      const Camera camera =
          cameraAt({fraction * length + 1, 3, 1.5}, -90 + 0.5);  // at the wall y = 0
      const std::vector<double> places = placesAlongWall(hall, camera);
      const Projection projection(camera, camera.eye);
      for (std::size_t column = 0; column < places.size(); ++column) {
        const Vec2 ray = projection.rayOf(static_cast<double>(column) + 0.5);
        const double exact = camera.eye.x + ray.x * (camera.eye.y / -ray.y);
        if (exact < 0 || exact > length) continue;
        EXPECT_NEAR(places[column], exact, 0.25 * kTexel) << length << ' ' << fraction;
        if (column > 0 && places[column - 1] >= 0) {
          EXPECT_GT(places[column], places[column - 1]);
        }
      }
    }
  }
}

TEST(Wall, thatAShortRayMeetsAtOneDegreeFarOutIsMetWhereItIs) {
  // A segment of 1 cm, a metre away, which the ray straight ahead cuts at 1 degree.
  for (const double far : {1.0, 1e3, 1e6}) {
    const Vec2 eye{far + 0.125, -far + 0.375};
    const double sine = std::sin(std::numbers::pi / 180);
    Segment segment;
    segment.p0 = {eye.x + 1 - 0.005, eye.y - 0.005 * sine};
    segment.p1 = {eye.x + 1 + 0.005, eye.y + 0.006 * sine};
    const Projection projection({SectorId(0), {eye.x, eye.y, 0}, 0}, {eye.x, eye.y, 0});
    const double depth = SegmentMeetings(projection, segment).at(0).depth;
    // With the coordinates as they were rounded, in 64 bits.
    const long double y0 = static_cast<long double>(segment.p0.y) - eye.y;
    const long double y1 = static_cast<long double>(segment.p1.y) - eye.y;
    const long double x0 = static_cast<long double>(segment.p0.x) - eye.x;
    const long double x1 = static_cast<long double>(segment.p1.x) - eye.x;
    const long double exact = x0 + (x1 - x0) * (y0 / (y0 - y1));
    EXPECT_NEAR(depth, static_cast<double>(exact), 4 * std::numeric_limits<double>::epsilon());
  }
}

TEST(Wall, slantedWithAVertexThatWasRoundedHidesTheFloorBehindIt) {
  // A vertex at a third of the way, as a file of four decimals has it; seen along the wall.
  const LoadedLevel room = levelFrom(levelOf(
      "'room': {'floor': {'texture': '#00ff00'}, 'ceiling': {'z': 3, 'texture': '#0000ff'}, "
      "'loops': {'border': {'v': [0,0, 3.3333,1.2333, 10,3.7, 0,9], 'walls': {'texture': "
      "'#ff0000'}}}}"));
  for (const double side : {1e-4, 1e-3, 0.01, 0.1, 1.0})
    for (double angle = 10; angle <= 30; angle += 0.37) {
      const BakedLight light = noLightOf(room.level);
      const Camera camera = cameraAt({0.2, 0.074 + side, 1.5}, angle);
      const Image drawn =
          Renderer(room.scene(), room.textures, light).draw(camera, LightMode::None);
      for (int i = 0; i < drawn.width(); ++i) {
        int wallBegins = 0;
        while (wallBegins < drawn.height() && drawn.at(i, wallBegins).b == 255) ++wallBegins;
        int wallEnds = wallBegins;
        while (wallEnds < drawn.height() && drawn.at(i, wallEnds).r == 255) ++wallEnds;
        for (int j = wallEnds; j < drawn.height(); ++j)
          ASSERT_EQ(drawn.at(i, j).g, 255) << i << ',' << j << " angle " << angle;
      }
    }
}

TEST(Wall, ofSolidStepsAndPlainPiecesOfOneZrefShowsEqualColumns) {
  // Side by side on x = 4: solid, a closed portal (a lower step up to 1 m, the rest upper), solid.
  const std::string texture =
      "{'name': 'brick', 'scale': [1e9, 1], 'zref': 0.37}";  // the same in every column
  const std::string solid = fmt::format("{{'texture': {}}}", texture);
  const std::string steps = fmt::format("{{'next': 'shut', 'texture': {}}}", texture);
  const LoadedLevel room = levelFrom(levelOf(
      fmt::format("'room': {{'floor': {{'texture': '#101010'}}, 'ceiling': {{'z': 3, 'texture': "
                  "'#101010'}}, 'loops': {{'border': {{'v': [0,-6, 4,-6, 4,-1, 4,1, 4,6, 0,6], "
                  "'walls': [{0}, {0}, {1}, {0}, {0}, {0}]}}}}}},",
                  solid, steps) +
      BoxRoom{.x0 = 4, .y0 = -1, .x1 = 5, .y1 = 1, .floor = 1, .ceiling = 1}.sector(
          "shut",
          fmt::format("[{0}, {0}, {0}, {1}]", solid, "{'next': 'room', 'texture': '#808080'}"))));
  const BakedLight light = noLightOf(room.level);
  const Image drawn =
      Renderer(room.scene(), room.textures, light).draw(cameraAt({0, 0, 1.5}, 0), LightMode::None);
  for (int i = 1; i < drawn.width(); ++i)
    for (int j = 0; j < drawn.height(); ++j)
      ASSERT_EQ(drawn.at(i, j), drawn.at(0, j)) << i << ',' << j;
}

TEST(Room, thatIsCutInTwoByAPortalShowsTheSamePicture) {
  const BoxRoom whole{
      .wallTexture = "'brick 2,2'", .floorTexture = "'wood'", .ceilingTexture = "'stone'"};
  const auto wall = [](double along) {
    return fmt::format("{{'texture': {{'name': 'brick', 'scale': [2, 2], 'along': {}}}}}", along);
  };
  BoxRoom west = whole;
  west.x1 = 3;
  BoxRoom east = whole;
  east.x0 = 3;
  const std::string lights = "[{'x': 2, 'y': 5, 'z': 2, 'falloff': 0.3}]";
  const LoadedLevel one = levelFrom(levelOf(whole.sector("room")), lights);
  const LoadedLevel two =
      levelFrom(levelOf(west.sector("west", fmt::format("[{}, {{'next': 'east'}}, {}, {}]", wall(0),
                                                        wall(5), wall(0))) +
                        "," +
                        east.sector("east", fmt::format("[{}, {}, {}, {{'next': 'west'}}]", wall(3),
                                                        wall(0), wall(0)))),
                lights);
  const BakedLight oneLight = bake(one.scene(), one.level.bake, 1);
  const BakedLight twoLight = bake(two.scene(), two.level.bake, 1);
  for (const Vec3 eye : {Vec3{1, 1, 1.5}, Vec3{3.1, 4, 1}, Vec3{6.7, 7, 2.9}})
    for (double angle = 0; angle < 360; angle += 20)
      for (const LightMode mode : {LightMode::None, LightMode::Only}) {
        Camera camera = cameraAt(eye, angle);
        const Image expected = Renderer(one.scene(), one.textures, oneLight).draw(camera, mode);
        camera.sector = SectorId(eye.x > 3 ? 1 : 0);
        EXPECT_EQ(Renderer(two.scene(), two.textures, twoLight).draw(camera, mode), expected)
            << eye.x << ' ' << angle;
      }
}

TEST(Texture, ofAnySizeOffsetAndScaleIsDrawnAsTruth) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{1, 1000}, std::pair{12, 100}})
    for (const char* offset : {"0,0", "-1e6,1e9", "1e9,-1e6", "0.5,-0.25"})
      for (const char* scale : {"1,1", "1e-6,1e6", "1e6,1e-6", "3.7,0.3"}) {
        const std::string texture = fmt::format("'brick {} {}'", scale, offset);
        LoadedLevel room = levelFrom(levelOf(
            BoxRoom{.wallTexture = texture, .floorTexture = texture, .ceilingTexture = texture}
                .sector("room")));
        Image image(width, height);
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(x * 20), static_cast<std::uint8_t>(y),
                              static_cast<std::uint8_t>(y >> 8)};
        std::vector<Image> images = room.textures;
        images[0] = image;
        room.textures = SharedImages(std::move(images));
        expectAsTruth(room, cameraAt({3, 3, 1.5}, 20, -20), 7);
      }
}

TEST(Height, ofNothingAndOfANanometreLeavesNoStrayPixel) {
  for (const double height : {0.0, 1e-9, 1e-7, 1e-3})
    for (const double floor : {0.0, 1.5}) {
      const BoxRoom room{.x1 = 4};
      const BoxRoom slit{.x0 = 4, .x1 = 6, .floor = floor, .ceiling = floor + height};
      const LoadedLevel rooms = levelFrom(levelOf(
          room.sector("room", fmt::format("[{0}, {1}, {0}, {0}]", kSolid, portalTo("slit"))) + "," +
          slit.sector("slit", fmt::format("[{0}, {0}, {0}, {1}]", kSolid, portalTo("room")))));
      for (const double angle : {-30.0, 0.0, 0.7, 40.0})
        for (const double pitch : {-40.0, 0.0, 20.0})
          expectAsTruth(rooms, cameraAt({1, 4, 1.5}, angle, pitch));
    }
}

/// A regular polygon of so many vertices round the origin, clockwise on a map with y down.
std::string polygon(int vertices, double radius) {
  std::string text;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / vertices;
    text += fmt::format("{}{},{}", i > 0 ? ", " : "", radius * std::cos(angle),
                        radius * std::sin(angle));
  }
  return text;
}

/// Heights of the plane `rise` * (x + radius) at those vertices.
std::string risingHeights(int vertices, double radius, double rise) {
  std::string text;
  for (int i = 0; i < vertices; ++i)
    text += fmt::format("{}{}", i > 0 ? ", " : "",
                        rise * radius * (1 + std::cos(2 * std::numbers::pi * i / vertices)));
  return text;
}

TEST(Slope, ofThreeToThirtyVerticesIsDrawnAsTruth) {
  for (const int vertices : {3, 4, 5, 30})
    for (const double rise : {0.0, 1e-9, 0.1, 0.2}) {
      const LoadedLevel room = levelFrom(levelOf(test::sectorText(
          "room", polygon(vertices, 6), 0, 3, "{'texture': 'brick'}",
          fmt::format(", 'slopeFloor': {{'z': [{}]}}", risingHeights(vertices, 6, rise)))));
      for (double angle = 0; angle < 360; angle += 40)
        for (const double pitch : {-50.0, 0.0})
          expectAsTruth(room, cameraAt({-0.5, 0.3, 2.5}, angle, pitch), 3);
    }
}

TEST(Slope, thatTouchesItsCeilingIsDrawnAsTruth) {
  const LoadedLevel room = levelFrom(levelOf(
      test::sectorText("room", "0,0, 6,0, 6,6, 0,6", 0, 3, "{'texture': 'brick'}",
                       ", 'slopeFloor': {'z': [0, 3, 3, 0]}, 'slopeCeil': {'z': [0, 0, 0, 0]}")));
  for (double angle = 0; angle < 360; angle += 15)
    expectAsTruth(room, cameraAt({1, 2, 2}, angle), 3);
}

TEST(Slope, thatIsNearlyUprightIsDrawnAsTruth) {
  // A thousand kilometres up over one metre.
  for (const double rise : {1e3, 1e6}) {
    const LoadedLevel shaft = levelFrom(levelOf(
        test::sectorText("shaft", "0,0, 1,0, 1,6, 0,6", 0, 1.5 * rise, "{'texture': 'brick'}",
                         fmt::format(", 'slopeFloor': {{'z': [0, {0}, {0}, 0]}}", rise))));
    for (const double z : {0.1 * rise, 1.2 * rise})
      for (double angle = 0; angle < 360; angle += 15)
        for (const double pitch : {-60.0, 0.0, 60.0})
          expectAsTruth(shaft, cameraAt({0.05, 3, z}, angle, pitch), 3);
  }
}

}  // namespace
}  // namespace hearth::extremes
