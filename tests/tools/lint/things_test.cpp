#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "places.h"
#include "support/in_tree.h"
#include "support/temporary_folder.h"

namespace hearth::test {

namespace {

/// A room of 8 x 8 m that is 3 m high, with a thing in it.
std::string roomWith(std::string_view thing) {
  return with(R"({ 'light': 0.5, 'player': {'x': 1, 'y': 1, 'z': 1.6}, 'sectors': {
  'room': { 'floor': {'texture': '#808080'}, 'ceiling': {'z': 3, 'texture': '#808080'},
    'loops': {'border': {'v': [0,0, 8,0, 8,8, 0,8], 'walls': [{'texture': '#808080'},
      {'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}]}}}},
  'things': [
    THING]})",
              "THING", thing);
}

constexpr std::string_view kFirstThing = "6:5 /things/0 [unseen-thing]";

TEST(UnseenThings, AreSpritesAboveTheCeilingOrBelowTheFloor) {
  const auto atHeight = [](std::string_view up) {
    return roomWith("{'sprite': '#ff0000', 'x': 4, 'y': 4, 'size': [1, 1], 'offset': [0, " +
                    std::string(up) + "]}");
  };
  for (const std::string_view up : {"-1.1", "3.1"})
    EXPECT_EQ(placesOf(findUnseenThings, atHeight(up)), Places{std::string(kFirstThing)}) << up;
  for (const std::string_view up : {"-0.9", "0", "2.9"})
    EXPECT_EQ(placesOf(findUnseenThings, atHeight(up)), Places{}) << up;
}

TEST(UnseenThings, AreNoneInAClosedDoor) {
  const std::string open =
      roomWith("{'sprite': '#ff0000', 'x': 4, 'y': 4, 'size': [1, 1], 'offset': [0, 4]}");
  EXPECT_EQ(placesOf(findUnseenThings, open), Places{std::string(kFirstThing)});
  const std::string closed = with(open, "'player': {'x': 1, 'y': 1, 'z': 1.6}, ", "");
  EXPECT_EQ(placesOf(findUnseenThings, with(closed, "'z': 3", "'z': 0")), Places{});
}

TEST(UnseenThings, AreSpritesOfOneTexel) {
  EXPECT_EQ(firstMessage(findUnseenThings, roomWith("{'sprite': '#ff0000', 'x': 4, 'y': 4}")),
            "the sprite \"#ff0000\" is 0.0156 m large");
  EXPECT_EQ(
      advicesOf(findUnseenThings, roomWith("{'sprite': '#ff0000', 'x': 4, 'y': 4}")),
      std::vector<std::string>{"give its \"size\" in metres; without one, 64 texels are a metre"});
}

TEST(UnseenThings, AreMeshesOutsideTheAir) {
  const TemporaryFolder folder;
  const std::filesystem::path far =
      folder.write("far.obj", "v 5000 0 0\nv 5001 0 0\nv 5000 1 0\nf 1 2 3\n");
  const auto at = [](const std::filesystem::path& model, std::string_view keys) {
    return roomWith("{'mesh': '" + model.string() + "', 'x': 4, 'y': 4" + std::string(keys) + "}");
  };
  const std::filesystem::path crate = inTree("levels/models/crate.obj");
  EXPECT_EQ(placesOf(findUnseenThings, at(far, "")), Places{std::string(kFirstThing)});
  EXPECT_EQ(placesOf(findUnseenThings, at(crate, ", 'scale': 0.001")),
            Places{std::string(kFirstThing)});
  EXPECT_EQ(placesOf(findUnseenThings, at(crate, "")), Places{});
}

TEST(StuckPlayers, AreThoseInsideASolidThing) {
  const auto lampAt = [](double x, std::string_view rest) {
    return roomWith("{'sprite': '#ff0000', 'x': " + std::to_string(x) +
                    ", 'y': 1, 'size': [1, 1], 'radius': 0.3, " + std::string(rest) + "}");
  };
  EXPECT_EQ(placesOf(findMisplacedPlayer, lampAt(1.2, "'height': 1")),
            (Places{"1:27 /player [stuck-player]"}));
  EXPECT_EQ(placesOf(findMisplacedPlayer, lampAt(2, "'height': 1")), Places{}) << "beside it";
  EXPECT_EQ(placesOf(findMisplacedPlayer, lampAt(1.2, "'height': 0.3")), Places{}) << "on a step";
  EXPECT_EQ(placesOf(findMisplacedPlayer, lampAt(1.2, "'z': 2.2, 'height': 0.5")), Places{})
      << "below a lamp";
}

}  // namespace

}  // namespace hearth::test
