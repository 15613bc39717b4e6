#include "level/moved_geometry.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/hall_and_cellar.h"
#include "support/models.h"

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

TEST(MovedGeometries, MoveAMeshThatStandsOnAFloorWithItsBodyAndForRays) {
  const SourcedResult sourced = test::levelWithSourceFrom(
      test::hallAndCellarText("[{'mesh':'box.obj','x':-1,'y':2},{'mesh':'box.obj','x':2,'y':1}]"),
      "[]", {{"box.obj", test::kBoxModel}});
  const Level& authored = sourced.result.loaded->level;
  MovedGeometry moved(authored, sourced.result.loaded->geometry);
  const Level& level = moved.level();
  for (const double share : {0.3, 1.0, 0.5}) {
    moved.setShare(Lift, share);
    EXPECT_EQ(level.meshes[0].position.z, share);
    EXPECT_EQ(level.meshes[1].position.z, 0);
    for (std::size_t mesh = 0; mesh < 2; ++mesh) {
      const double rise = mesh == 0 ? share : 0;
      const auto faces = level.facesOf(level.meshes[mesh]);
      const auto before = authored.facesOf(authored.meshes[mesh]);
      for (std::size_t i = 0; i < faces.size(); ++i)
        EXPECT_EQ(faces[i].corners[1], before[i].corners[1] + Vec3(0, 0, rise)) << i;
      EXPECT_EQ(level.bodies[mesh].zBottom, rise);
      EXPECT_EQ(level.bodies[mesh].zTop, rise + 1);
      EXPECT_EQ(level.faceTrees[mesh].box().max.z, authored.faceTrees[mesh].box().max.z + rise);
      const FaceRay down({level.meshes[mesh].position.x + 0.1, mesh == 0 ? 2.1 : 1.1, 3},
                         {0, 0, -1});
      const auto met = level.faceTrees[mesh].nearest(faces, down, 0, 10, 0);
      ASSERT_TRUE(met);
      EXPECT_DOUBLE_EQ(met->t, 2 - rise);
    }
  }
}

TEST(MovedGeometries, ShowTheTexturesOfSwitches) {
  std::string text = test::hallAndCellarText();
  const std::string plain = "[{'texture':'#808080'},";
  text.replace(text.find(plain), plain.size(),
               "[{'texture':'#808080','use':'gate','on':{'#808080':'#ff0000'}},");
  const SourcedResult sourced = test::levelWithSourceFrom(text);
  const LoadedLevel& authored = *sourced.result.loaded;
  MovedGeometry moved(authored.level, authored.geometry);
  for (const double share : {0.0, 0.25, 1.0, 0.5, 0.0}) {
    const std::vector<double> shares{share, 0.5};
    moved.setShares(shares);
    const LoadedLevel there = *levelAt(authored, sourced.source, shares).loaded;
    for (std::size_t i = 0; i < there.level.surfaces.size(); ++i)
      EXPECT_EQ(moved.level().surfaces[i].mapping.texture, there.level.surfaces[i].mapping.texture);
    const SurfaceId lever = there.level.switchTextures.at(0).surface;
    EXPECT_EQ(moved.level().textures[moved.level()[lever].mapping.texture.index()],
              share > 0 ? "#ff0000" : "#808080");
  }
}

TEST(MovedGeometries, CopyNoLevelWhereNothingStandsOnAFloorThatMoves) {
  const SourcedResult sourced = test::hallAndCellar();
  const LoadedLevel& authored = *sourced.result.loaded;
  const MovedGeometry moved(authored.level, authored.geometry);
  EXPECT_EQ(&moved.level(), &authored.level);
}

}  // namespace
}  // namespace hearth
