// A walk in a level whose flats move: what its frames show.

#include <utility>

#include "light/blended_light.h"
#include "staged_walk.h"
#include "support/hall_and_cellar.h"

namespace hearth {
namespace {

using test::down;
using test::up;
using Walk = test::StagedWalk;

enum Movers { Gate, Lift };

/// No test needs to see it: where it stands, the view has a level of its own.
const std::string kBarrelOnLift = "[{'sprite':'#c04020','size':[0.5,0.9],'x':-1,'y':2}]";

/// The door moves for so many ticks: 2 m at 1.5 m/s.
constexpr int kTicksOfGate = 86;

class WalkMovers : public testing::Test {
 protected:
  WalkMovers()
      : authored_(test::hallAndCellar(kBarrelOnLift)),
        place_(*authored_.result.loaded),
        walk({}, place_, WalkSession::Record::No) {
    walk.stage.window = ImageSize{48, 96};  // so tall that the foot of the door shows
    walk.now(WindowEvent::Changed);
  }

  /// The level with the gate at a share, lit there.
  std::shared_ptr<const RestLight> restAt(double gate, double lift = 0) const {
    LoadedLevel level = *levelAt(place_.loaded, authored_.source, std::vector{gate, lift}).loaded;
    BakedLight light = bake(level.scene(), level.level.bake, 2);
    return std::make_shared<const RestLight>(
        RestLight{{gate, lift}, std::move(level.geometry), std::move(light)});
  }
  Scene sceneOf(const RestLight& rest) const { return {place_.loaded.level, rest.geometry}; }

  /// The picture of a level from where the player stands.
  Image drawn(const Scene& scene, const BakedLight& light, LightMode mode = LightMode::Both) const {
    const Eye eye = eyeOf(scene, walk.walker());
    return Renderer(scene, place_.loaded.textures, light)
        .draw({eye.sector, eye.point, eye.angle, eye.pitch, 90, walk.stage.window->width,
               walk.stage.window->height},
              mode);
  }
  Image drawn(const RestLight& rest) const { return drawn(sceneOf(rest), rest.light); }

  void use() {
    walk.now(down(Key::E));
    walk.now(up(Key::E));
  }

  SourcedResult authored_;
  test::Place place_;
  Walk walk;
};

TEST_F(WalkMovers, TheUseKeyOpensTheDoorAhead) {
  walk.ticks(2);
  const Image shut = walk.stage.shown;
  use();
  walk.ticks(20);
  EXPECT_NE(walk.stage.shown, shut);
  walk.ticks(kTicksOfGate);
  const int frames = walk.stage.frames;
  walk.ticks(50);
  EXPECT_EQ(walk.stage.frames, frames) << "it stays open, and nothing changes any more";
}

TEST_F(WalkMovers, FlatsStandBetweenTheLastTwoTicks) {
  walk.now(down(Key::Digit2));
  use();
  walk.ticks(10);
  walk.go(1, 0.25 / kTicksPerSecond);
  const double tick = 1.5 / kTicksPerSecond / 2;
  const std::vector<double> shares{std::lerp(9 * tick, 10 * tick, 0.25), 0};
  const LoadedLevel there = *levelAt(place_.loaded, authored_.source, shares).loaded;
  EXPECT_EQ(walk.stage.shown, drawn(there.scene(), place_.light, LightMode::None));
}

TEST_F(WalkMovers, AtRestTheLightIsThatOfALevelAuthoredSo) {
  const auto open = restAt(1);
  use();
  walk.ticks(kTicksOfGate + 3);
  EXPECT_NE(walk.stage.shown, drawn(*open)) << "its light is not known yet";
  ASSERT_EQ(walk.loop().wantedLight().size(), 1U);
  EXPECT_EQ(walk.loop().wantedLight()[0], (std::vector<double>{1, 0}));
  walk.loop().addLight(open);
  walk.now();
  EXPECT_EQ(walk.stage.shown, drawn(*open));
  EXPECT_TRUE(walk.loop().wantedLight().empty());
}

TEST_F(WalkMovers, BetweenItsEndsTheLightIsBlended) {
  const auto open = restAt(1);
  use();
  walk.ticks(30);
  walk.loop().addLight(open);
  walk.now();
  const double share = 29 * 1.5 / kTicksPerSecond / 2;  // the view is a tick late
  const LoadedLevel there =
      *levelAt(place_.loaded, authored_.source, std::vector{share, 0.0}).loaded;
  const std::vector<LightAtRest> states{{place_.loaded.scene(), &place_.light},
                                        {sceneOf(*open), &open->light}};
  const BakedLight light = blendedLight(there.scene(), states, std::vector{1 - share, share}, 2);
  EXPECT_EQ(walk.stage.shown, drawn(there.scene(), light));
}

TEST_F(WalkMovers, StatesThatWereNotNeededForLongestAreForgottenAndWantedAgain) {
  const Renderer still(place_.loaded.scene(), place_.loaded.textures, place_.light);
  MovedView view(place_.loaded.scene(), still, {.states = 2});
  const auto show = [&](std::vector<double> shares) {
    view.moveTo(shares);
    view.light(nullptr);
    const bool isWanted = !view.wanted().empty();
    if (isWanted) view.add(restAt(shares[Gate], shares[Lift]));
    view.light(nullptr);
    const auto rest = restAt(shares[Gate], shares[Lift]);
    EXPECT_EQ(drawn(view.scene(), view.renderer().light()), drawn(*rest));
    return isWanted;
  };
  EXPECT_TRUE(show({1, 0}));
  EXPECT_FALSE(show({0, 0})) << "as authored";
  EXPECT_FALSE(show({1, 0}));
  EXPECT_TRUE(show({1, 1}));
  EXPECT_TRUE(show({1, 0})) << "one state is kept";
}

TEST(MovedViews, ShowABarrelThatALiftRaises) {
  const SourcedResult sourced = test::hallAndCellar(kBarrelOnLift);
  const test::Place place(*sourced.result.loaded);
  const Renderer still(place.loaded.scene(), place.loaded.textures, place.light);
  MovedView view(place.loaded.scene(), still);
  const std::vector<double> up{0, 1};
  LoadedLevel raised = *levelAt(place.loaded, sourced.source, up).loaded;
  const BakedLight light = bake(raised.scene(), raised.level.bake, 1);
  const Camera camera{raised.level.player->sector, {3, 2, 1.6}, 180, 0, 90, 64, 40};
  const Image expected =
      Renderer(raised.scene(), raised.textures, light).draw(camera, LightMode::Both);
  view.add(std::make_shared<const RestLight>(RestLight{up, std::move(raised.geometry), light}));
  view.moveTo(up);
  view.light(nullptr);
  EXPECT_EQ(view.renderer().draw(camera, LightMode::Both), expected);
}

TEST_F(WalkMovers, ALevelThatIsLoadedAgainKeepsItsDoorsOpen) {
  use();
  walk.ticks(kTicksOfGate + 3);
  const test::Place edited(*authored_.result.loaded);
  const Renderer renderer(edited.loaded.scene(), edited.loaded.textures, edited.light);
  walk.continueIn(edited, renderer);
  walk.ticks(2);
  EXPECT_EQ(walk.shares()[Gate], 1);
}

TEST_F(WalkMovers, APictureSaysHowTheMoversStand) {
  use();
  walk.ticks(kTicksOfGate + 3);
  walk.now(down(Key::F12));
  walk.loop().awaitScreenshots();
  ASSERT_EQ(walk.stage.printed.size(), 1U);
  EXPECT_NE(walk.stage.printed[0].find("--mover gate=1 "), std::string::npos)
      << walk.stage.printed[0];
}

}  // namespace
}  // namespace hearth
