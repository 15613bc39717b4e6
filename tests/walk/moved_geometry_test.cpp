#include "level/moved_geometry.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/hall_and_cellar.h"

namespace hearth {
namespace {

enum Movers { Gate, Lift };

/// With a barrel, which is solid, on the lift, a lamp that hangs above it, and a barrel in the
/// hall.
SourcedResult hallWithBarrels() {
  const std::string barrel = "{'sprite':'#604020','size':[0.5,0.9],'radius':0.25,'height':0.9,";
  return test::hallAndCellar("[" + barrel + "'x':2,'y':1}," +
                             "{'sprite':'#ffff80','size':[0.2,0.2],'x':-1,'y':2,'z':2.5}," +
                             barrel + "'x':-1,'y':2}]");
}

void expectThingsAsIn(const Level& expected, const Level& level) {
  ASSERT_EQ(level.sprites.size(), expected.sprites.size());
  for (std::size_t i = 0; i < level.sprites.size(); ++i)
    EXPECT_EQ(level.sprites[i].position, expected.sprites[i].position) << i;
  ASSERT_EQ(level.bodies.size(), expected.bodies.size());
  for (std::size_t i = 0; i < level.bodies.size(); ++i) {
    EXPECT_EQ(level.bodies[i].zBottom, expected.bodies[i].zBottom) << i;
    EXPECT_EQ(level.bodies[i].zTop, expected.bodies[i].zTop) << i;
  }
}

TEST(MovedGeometries, MoveWhatStandsOnAFloorAndNothingElse) {
  const SourcedResult sourced = hallWithBarrels();
  const LoadedLevel& authored = *sourced.result.loaded;
  MovedGeometry moved(authored.level, authored.geometry);
  for (const double share : {0.0, 0.3, 1.0, 0.7, 0.0}) {
    const std::vector<double> shares{0.5, share};
    moved.setShares(shares);
    const LoadedLevel there = *levelAt(authored, sourced.source, shares).loaded;
    expectThingsAsIn(there.level, moved.level());
    EXPECT_EQ(moved.scene().geometry().sectors, there.geometry.sectors) << share;
  }
  EXPECT_EQ(authored.level.sprites[2].position.z, 0) << "the level itself stays";
}

TEST(MovedGeometries, CopyNoLevelWhereNothingStandsOnAFloorThatMoves) {
  const SourcedResult sourced = test::hallAndCellar();
  const LoadedLevel& authored = *sourced.result.loaded;
  const MovedGeometry moved(authored.level, authored.geometry);
  EXPECT_EQ(&moved.level(), &authored.level);
}

}  // namespace
}  // namespace hearth
