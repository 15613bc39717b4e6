#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "places.h"
#include "support/level_text.h"

namespace hearth::test {

namespace {

std::string withPlayer(const std::vector<std::string>& sectors) {
  return fmt::format(
      "{{ 'light': 0.5, 'player': {{'x': 1, 'y': 1, 'z': 1.6}}, 'sectors': {{\n{} }} }}",
      fmt::join(sectors, ",\n"));
}

/// A hall of 4 x 4 m with a room of `width` x 4 m beside it.
std::string hallAndRoom(double floor, double ceiling, double width = 4) {
  const std::string steps = "'upper': '#606060', 'lower': '#606060'";
  const std::string solid = "{'texture': '#808080'}";
  const std::string hall =
      sectorText("hall", "0,0, 4,0, 4,4, 0,4", 0, 4,
                 fmt::format("[{0},\n{{'next': 'room', {1}}}, {0}, {0}]", solid, steps));
  const std::string room =
      sectorText("room", fmt::format("4,0, {0},0, {0},4, 4,4", 4 + width), floor, ceiling,
                 fmt::format("[{0}, {0}, {0},\n{{'next': 'hall', {1}}}]", solid, steps));
  return withPlayer({hall, room});
}

constexpr const char* kStep = "3:1 /sectors/hall/loops/border/walls/1 [high-step]";
constexpr const char* kWay = "3:1 /sectors/hall/loops/border/walls/1 [low-passage]";

TEST(HighSteps, AreThoseThatThePlayerJustCannotClimb) {
  for (const double rise : {0.41, 0.5, 0.6})
    EXPECT_EQ(placesOf(findImpassable, hallAndRoom(rise, 4)), (Places{kStep})) << rise;
  EXPECT_EQ(firstMessage(findImpassable, hallAndRoom(0.5, 4)),
            "the step to sector \"room\" is 0.5 m high, the player climbs 0.4 m, and nothing else "
            "leads there");
}

TEST(HighSteps, AreNoneThatHeClimbsOrThatNobodyWould) {
  for (const double rise : {0.0, 0.2, 0.4, 0.61, 1.0, 2.0})
    EXPECT_EQ(placesOf(findImpassable, hallAndRoom(rise, 4)), Places{}) << rise;
}

TEST(HighSteps, AreMeasuredOnTheStepThatTheLevelsPlayerClimbs) {
  const std::string level = with(hallAndRoom(0.5, 4), "'z': 1.6}", "'z': 1.6, 'step': 0.5}");
  EXPECT_EQ(placesOf(findImpassable, level), Places{});
}

/// Benches, plinths and beds.
TEST(HighSteps, AreNoneOntoWhatIsNoRoom) {
  EXPECT_EQ(placesOf(findImpassable, hallAndRoom(0.5, 4, 0.9)), Places{});
}

/// Along the hall and the room beside it runs a third sector, from which either can be entered.
TEST(HighSteps, AreNoneWhereSomethingElseLeadsUp) {
  const auto levelWithStair = [](double rise) {
    const std::string solid = "{'texture': '#808080'}";
    const std::string lower = "'lower': '#606060'";
    const std::string hall = sectorText(
        "hall", "0,0, 4,0, 4,4, 0,4", 0, 4,
        fmt::format("[{0}, {{'next': 'room', {1}}}, {{'next': 'stair', {1}}}, {0}]", solid, lower));
    const std::string room =
        sectorText("room", "4,0, 8,0, 8,4, 4,4", 0.5, 4,
                   fmt::format("[{0}, {0}, {{'next': 'stair'}}, {{'next': 'hall'}}]", solid));
    const std::string stair = sectorText(
        "stair", "0,4, 4,4, 8,4, 8,5, 0,5", rise, 4,
        fmt::format("[{{'next': 'hall'}}, {{'next': 'room', {1}}}, {0}, {0}, {0}]", solid, lower));
    return withPlayer({hall, room, stair});
  };
  EXPECT_EQ(placesOf(findImpassable, levelWithStair(0.25)), Places{});
  EXPECT_EQ(placesOf(findImpassable, levelWithStair(0.05)).size(), 1U);
}

TEST(HighSteps, AreNoneInGapsThatAreTooNarrowForThePlayer) {
  const auto gap = [](double width) {
    const std::string solid = "{'texture': '#808080'}";
    const std::string hall = sectorText(
        "hall", fmt::format("0,0, 4,0, 4,{}, 4,4, 0,4", width), 0, 4,
        fmt::format("[{0}, {{'next': 'room', 'lower': '#606060'}}, {0}, {0}, {0}]", solid));
    const std::string room =
        sectorText("room", fmt::format("4,0, 8,0, 8,4, 4,4, 4,{}", width), 0.5, 4,
                   fmt::format("[{0}, {0}, {0}, {0}, {{'next': 'hall'}}]", solid));
    return withPlayer({hall, room});
  };
  EXPECT_EQ(placesOf(findImpassable, gap(0.59)), Places{});
  EXPECT_EQ(placesOf(findImpassable, gap(0.61)).size(), 1U);
}

TEST(HighSteps, AreNoneWithoutAPlayer) {
  const std::string level = with(hallAndRoom(0.5, 4), "'player': {'x': 1, 'y': 1, 'z': 1.6}, ", "");
  EXPECT_EQ(placesOf(findImpassable, level), Places{});
}

TEST(HighSteps, AreNoneThatHeNeverComesTo) {
  const std::string level =
      with(hallAndRoom(0.5, 4), "{'next': 'room', 'upper': '#606060', 'lower': '#606060'}",
           "{'texture': '#808080'}");
  EXPECT_EQ(placesOf(findImpassable, level), Places{});
}

/// Who has dropped into a pit of half a metre does not come out.
TEST(HighSteps, AreFoundOutOfPits) {
  EXPECT_EQ(placesOf(findImpassable, hallAndRoom(-0.5, 4)),
            (Places{"5:1 /sectors/room/loops/border/walls/3 [high-step]"}));
}

/// Along a wall whose step grows from 0.45 to 0.6 m.
TEST(HighSteps, AreToldAsTheyAreWhereTheyAreLowest) {
  const std::string wedge =
      with(hallAndRoom(0.45, 4), "'room': {",
           "'room': { 'slopeFloor': {'z': [0, 0, 0.15, 0.15], 'sidewall': '#505050'}, ");
  EXPECT_NE(firstMessage(findImpassable, wedge).find(" is 0.45 m high"), std::string::npos);
}

/// Two pits side by side, half a metre apart in depth, with a wall between them up to the level of
/// the rooms above: over that wall the player would have to climb a metre.
TEST(HighSteps, AreNoneBetweenRoomsThatHaveNoFloor) {
  const auto room = [](std::string_view name, std::string_view pit, std::string_view vertices,
                       std::string_view walls) {
    return fmt::format(
        "'{}': {{ 'floor': {{'z': 0, 'next': '{}-{}'}}, 'ceiling': {{'texture': '#808080'}}, "
        "'loops': {{'border': {{'v': [{}], 'walls': [{}]}}}} }}",
        name, name, pit, vertices, walls);
  };
  const auto pit = [](std::string_view name, std::string_view above, std::string_view vertices,
                      double floor) {
    return fmt::format(
        "'{}': {{ 'floor': {{'z': {}, 'texture': '#808080'}}, 'ceiling': {{'z': 0, 'next': "
        "'{}-{}'}}, 'loops': {{'border': {{'v': [{}], 'walls': {{'texture': '#808080'}}}}}} }}",
        name, floor, above, name, vertices);
  };
  const std::string solid = "{'texture': '#808080'}";
  const std::string left = "0,0, 4,0, 4,4, 0,4";
  const std::string right = "4,0, 8,0, 8,4, 4,4";
  const std::string level =
      withPlayer({room("a", "c", left, fmt::format("{0}, {{'next': 'b'}}, {0}, {0}", solid)),
                  room("b", "d", right, fmt::format("{0}, {0}, {0}, {{'next': 'a'}}", solid)),
                  pit("c", "a", left, -1), pit("d", "b", right, -0.5)});
  EXPECT_EQ(placesOf(findImpassable, level), Places{});
}

TEST(LowPassages, AreThoseThatThePlayerJustCannotWalk) {
  for (const double height : {1.55, 1.7, 1.79})
    EXPECT_EQ(placesOf(findImpassable, hallAndRoom(0, height)), (Places{kWay})) << height;
  EXPECT_EQ(firstMessage(findImpassable, hallAndRoom(0, 1.7)),
            "the way to sector \"room\" is 1.7 m high, the player 1.8 m, and nothing else leads "
            "there");
}

TEST(LowPassages, AreThoseThatHeJustCannotCrouchInto) {
  EXPECT_EQ(placesOf(findImpassable, hallAndRoom(0, 0.8)), (Places{kWay}));
  EXPECT_EQ(firstMessage(findImpassable, hallAndRoom(0, 0.8)),
            "the way to sector \"room\" is 0.8 m high, the player 0.9 m when crouching, and "
            "nothing else leads there");
}

TEST(LowPassages, AreNoneThatHeWalksOrCrouchesIntoOrThatNobodyWould) {
  for (const double height : {1.8, 1.4, 1.0, 0.9, 0.7, 0.2, 0.0})
    EXPECT_EQ(placesOf(findImpassable, hallAndRoom(0, height)), Places{}) << height;
}

TEST(LowPassages, AreNoneIntoWhatIsNoRoom) {
  EXPECT_EQ(placesOf(findImpassable, hallAndRoom(0, 1.7, 0.9)), Places{});
}

/// The hall, four steps of 0.3 m, 0.3 m deep, and a room of 4 x 4 m; what is between `heights`
/// high.
std::string hallAndStair(double rise, double headroom) {
  const std::string solid = "{'texture': '#808080'}";
  const std::string steps = "'upper': '#606060', 'lower': '#606060'";
  std::vector<std::string> sectors{
      sectorText("hall", "0,0, 4,0, 4,4, 0,4", 0, 4,
                 fmt::format("[{0},\n{{'next': 'step-1', {1}}}, {0}, {0}]", solid, steps))};
  for (int i = 1; i <= 4; ++i) {
    const double x = 4 + 0.3 * (i - 1);
    const std::string next = i == 4 ? "room" : fmt::format("step-{}", i + 1);
    const std::string back = i == 1 ? "hall" : fmt::format("step-{}", i - 1);
    sectors.push_back(
        sectorText(fmt::format("step-{}", i), fmt::format("{0},0, {1},0, {1},4, {0},4", x, x + 0.3),
                   rise * i, rise * i + headroom,
                   fmt::format("[{0}, {{'next': '{2}', {1}}}, {0}, {{'next': '{3}', {1}}}]", solid,
                               steps, next, back)));
  }
  sectors.push_back(
      sectorText("room", "5.2,0, 9,0, 9,4, 5.2,4", rise * 5, rise * 5 + 4,
                 fmt::format("[{0}, {0}, {0}, {{'next': 'step-4', {1}}}]", solid, steps)));
  return withPlayer(sectors);
}

TEST(LowPassages, AreThoseOverAStair) {
  EXPECT_EQ(placesOf(findImpassable, hallAndStair(0.2, 1.7)), (Places{kWay}));
  EXPECT_EQ(placesOf(findImpassable, hallAndStair(0.2, 2.1)), Places{});
}

TEST(HighSteps, AreThoseOfAStairToldOnce) {
  EXPECT_EQ(placesOf(findImpassable, hallAndStair(0.5, 4)), (Places{kStep}));
}

/// The hall and a room of 4 x 4 m, with a wall 0.2 m thick and a doorway between.
std::string hallAndDoorway(double width) {
  const std::string solid = "{'texture': '#808080'}";
  const std::string hall =
      sectorText("hall", fmt::format("0,0, 4,0, 4,1, 4,{}, 4,4, 0,4", 1 + width), 0, 4,
                 fmt::format("[{0}, {0},\n{{'next': 'doorway'}}, {0}, {0}, {0}]", solid));
  const std::string doorway =
      sectorText("doorway", fmt::format("4,1, 4.2,1, 4.2,{0}, 4,{0}", 1 + width), 0, 4,
                 fmt::format("[{0}, {{'next': 'room'}}, {0}, {{'next': 'hall'}}]", solid));
  const std::string room =
      sectorText("room", fmt::format("4.2,0, 8,0, 8,4, 4.2,4, 4.2,{}, 4.2,1", 1 + width), 0, 4,
                 fmt::format("[{0}, {0}, {0}, {0}, {{'next': 'doorway'}}, {0}]", solid));
  return withPlayer({hall, doorway, room});
}

TEST(NarrowPassages, AreThoseThatThePlayerJustCannotPass) {
  for (const double width : {0.3, 0.5, 0.59})
    EXPECT_EQ(placesOf(findImpassable, hallAndDoorway(width)),
              (Places{"3:1 /sectors/hall/loops/border/walls/2 [narrow-passage]"}))
        << width;
  EXPECT_EQ(firstMessage(findImpassable, hallAndDoorway(0.5)),
            "the way to sector \"doorway\" is 0.5 m wide, the player 0.6 m, and nothing else leads "
            "there");
}

TEST(NarrowPassages, AreNoneThatHePassesOrThatNobodyWould) {
  for (const double width : {0.1, 0.29, 0.6, 1.0})
    EXPECT_EQ(placesOf(findImpassable, hallAndDoorway(width)), Places{}) << width;
}

/// A sector that is cut in parts, each of which is narrow: floors have such patterns.
TEST(NarrowPassages, AreNoneBesideOthersThatAreOpen) {
  std::vector<std::string> sectors{sectorText(
      "hall", "0,0, 4,0, 4,1, 4,1.4, 4,1.8, 4,4, 0,4", 0, 4,
      "[{'texture': '#808080'}, {'texture': '#808080'}, {'next': 'one'}, {'next': 'other'},"
      "{'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}]")};
  sectors.push_back(
      sectorText("one", "4,1, 8,1, 8,1.4, 4,1.4", 0, 4,
                 "[{'texture': '#808080'}, {'texture': '#808080'}, {'next': 'other'}, "
                 "{'next': 'hall'}]"));
  sectors.push_back(sectorText("other", "4,1.4, 8,1.4, 8,1.8, 4,1.8", 0, 4,
                               "[{'next': 'one'}, {'texture': '#808080'}, {'texture': '#808080'}, "
                               "{'next': 'hall'}]"));
  EXPECT_EQ(placesOf(findImpassable, withPlayer(sectors)), Places{});
}

/// The eye is 1.6 m above the feet, and the player climbs 0.4 m.
TEST(SunkenPlayers, AreThoseWhoseFeetAreFarBelowTheFloor) {
  const auto eyeAt = [](double z) {
    return with(hallAndRoom(0, 4), "'z': 1.6}", fmt::format("'z': {}}}", z));
  };
  for (const double z : {0.0, 0.5, 1.19})
    EXPECT_EQ(placesOf(findMisplacedPlayer, eyeAt(z)), (Places{"1:27 /player [sunken-player]"}))
        << z;
  for (const double z : {1.2, 1.5, 1.6, 3.0})
    EXPECT_EQ(placesOf(findMisplacedPlayer, eyeAt(z)), Places{}) << z;
  EXPECT_EQ(advicesOf(findMisplacedPlayer, eyeAt(0)),
            std::vector<std::string>{"write \"z\": 1.6, which is 1.6 m above the floor"});
}

/// What the findings above leave out as nobody would have meant it.
TEST(SectorsOutOfReach, AreThoseThatNoFeetComeTo) {
  const auto unreached = [](const std::string& text) {
    const LoadedLevel loaded = levelFrom(text);
    std::vector<std::string> names;
    for (const SectorId sector : outOfReach(loaded.scene()))
      names.push_back(loaded.level[sector].name);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(unreached(hallAndRoom(0.3, 4)), Names{});
  EXPECT_EQ(unreached(hallAndRoom(0, 1)), Names{});  // crouching
  EXPECT_EQ(unreached(hallAndRoom(0.9, 4)), Names{"room"});
  const std::string lift = "'movers': {'lift': {'sectors': 'room', 'part': 'floor', 'to': 0}},";
  EXPECT_EQ(unreached(with(hallAndRoom(0.9, 4), "'sectors':", lift + " 'sectors':")), Names{});
  EXPECT_EQ(unreached(hallAndRoom(0, 0.4)), Names{"room"});
  EXPECT_EQ(unreached(hallAndDoorway(0.2)), (Names{"doorway", "room"}));
  EXPECT_EQ(unreached(hallAndStair(0.9, 4)),
            (Names{"step-1", "step-2", "step-3", "step-4", "room"}));
}

/// Without room to stand the player crouches, and is 0.9 m high, with the eye at 0.8 m.
TEST(StuckPlayers, AreThoseWhoseHeadIsInTheCeiling) {
  const auto eyeAt = [](double z) {
    return with(hallAndRoom(0, 4), "'z': 1.6}", fmt::format("'z': {}}}", z));
  };
  for (const double z : {3.91, 3.99})
    EXPECT_EQ(placesOf(findMisplacedPlayer, eyeAt(z)), (Places{"1:27 /player [stuck-player]"}))
        << z;
  EXPECT_EQ(placesOf(findMisplacedPlayer, eyeAt(3.9)), Places{});
  EXPECT_EQ(advicesOf(findMisplacedPlayer, eyeAt(3.95)),
            std::vector<std::string>{"write \"z\": 1.6, which is 1.6 m above the floor"});
}

}  // namespace

}  // namespace hearth::test
