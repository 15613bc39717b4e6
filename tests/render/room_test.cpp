// Small levels, drawn and read at pixels worked out by hand.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr Rgb kFloor = {10, 20, 30};
constexpr Rgb kCeiling = {40, 50, 60};
constexpr Rgb kWall = {70, 80, 90};
constexpr Rgb kStep = {100, 110, 120};

class Room {
 public:
  explicit Room(std::string_view text)
      : loaded_(test::levelFrom(text)),
        light_(bake(loaded_.scene(), loaded_.level.bake, 1)),
        renderer_(loaded_.scene(), loaded_.textures, light_) {}

  Image look(Vec3 eye, double angle, double pitch = 0, LightMode mode = LightMode::None) const {
    return renderer_.draw({SectorId(0), eye, angle, pitch, 90, 320, 200}, mode);
  }

 private:
  LoadedLevel loaded_;
  BakedLight light_;
  Renderer renderer_;
};

std::string sector(std::string_view name, std::string_view vertices, double floor, double ceiling,
                   std::string_view walls) {
  return fmt::format(
      "'{}':{{'floor':{{'z':{},'texture':'#0a141e'}},'ceiling':{{'z':{},'texture':'#28323c'}},"
      "'loops':{{'border':{{'v':[{}],'walls':{}}}}}}}",
      name, floor, ceiling, vertices, walls);
}

TEST(RoomTest, showsWallsBetweenTheRowsOfTheirHeights) {
  const Room room("{'light':1,'sectors':{" +
                  sector("room", "0,-9, 8,-9, 8,9, 0,9", 0, 3, "{'texture':'#46505a'}") + "}}");
  // The wall is 4 m away: ceiling 2 m above the eye at row 100 - 160*2/4 = 20, floor at 140.
  const Image picture = room.look({4, 0, 1}, 0);
  EXPECT_EQ(picture.at(160, 19), kCeiling);
  EXPECT_EQ(picture.at(160, 20), kWall);
  EXPECT_EQ(picture.at(160, 139), kWall);
  EXPECT_EQ(picture.at(160, 140), kFloor);
}

TEST(RoomTest, showsStepsOfAPortalInTheirHeights) {
  const std::string solid = "{'texture':'#46505a'}";
  const Room room(
      "{'light':1,'sectors':{" +
      sector("near", "0,-9, 8,-9, 8,9, 0,9", 0, 3,
             fmt::format("[{0},{{'next':'far','texture':'#646e78'}},{0},{0}]", solid)) +
      "," +
      sector("far", "8,-9, 12,-9, 12,9, 8,9", 0.5, 2,
             fmt::format("[{0},{0},{0},{{'next':'near','texture':'#646e78'}}]", solid)) +
      "}}");
  // At 4 m: upper step from row 20 (3 m) to 60 (2 m), lower from 120 (0.5 m) to 140 (0 m); at 8 m
  // the far wall from row 80 to 110, with its ceiling above and its floor below.
  const Image picture = room.look({4, 0, 1}, 0);
  const std::pair<int, Rgb> expected[] = {
      {19, kCeiling}, {20, kStep},   {59, kStep},   {60, kCeiling}, {79, kCeiling}, {80, kWall},
      {109, kWall},   {110, kFloor}, {119, kFloor}, {120, kStep},   {139, kStep},   {140, kFloor}};
  for (const auto& [row, color] : expected) EXPECT_EQ(picture.at(160, row), color) << row;
}

TEST(RoomTest, looksThroughAFlatPortalAtWhatIsThere) {
  const std::string solid = "{'texture':'#46505a'}";
  const auto level = [&](std::string_view east) {
    return fmt::format(
        "{{'light':1,'sectors':{{'up':{{'floor':{{'z':0,'next':'up-west'}},'ceiling':{{'z':3,"
        "'texture':'#28323c'}},'loops':{{'border':{{'v':[0,0, 4,0, 4,4, 0,4],'walls':{0}}}}}}},"
        "'west':{{'floor':{{'z':-3,'texture':'#0a141e'}},'ceiling':{{'z':0,'next':'up-west'}},"
        "'loops':{{'border':{{'v':[0,0, 2,0, 2,4, "
        "0,4],'walls':[{0},{{'next':'east'}},{0},{0}]}}}}}},"
        "'east':{{'floor':{{'z':-3,'texture':'{1}'}},'ceiling':{{'z':0,'next':'up-west'}},"
        "'loops':{{'border':{{'v':[2,0, 4,0, 4,4, "
        "2,4],'walls':[{0},{0},{0},{{'next':'west'}}]}}}}}}}}}}",
        solid, east);
  };
  // Looking along +x and down, row r meets z = -3 at depth 3.5 * 160 / (r - horizon).
  const Image picture = Room(level("#646e78")).look({0.1, 2, 0.5}, 0, -60);
  const double horizon = 100 - 160 * std::sqrt(3.0);
  const auto rowAtDepth = [&](double depth) {
    return static_cast<int>(horizon + 3.5 * 160 / depth);
  };
  EXPECT_EQ(picture.at(160, rowAtDepth(1.7)), kFloor) << "the floor of the western half";
  EXPECT_EQ(picture.at(160, rowAtDepth(2.1)), kStep) << "the floor of the eastern half";
}

}  // namespace
}  // namespace hearth
