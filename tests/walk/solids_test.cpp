#include "walk_tests/solids.h"

#include "walks.h"

namespace hearth::random_walks {
namespace {

const std::string kSolid = "{'texture':'#808080'}";

TEST(Solids, FindsABarBetweenTheHeightsThatItAlwaysLooksAt) {
  const auto barTo = [&](const std::string& next) {
    const std::string open = "'texture':'#808080','next':'" + next + "'}";
    return "{'walls':[{'z':1," + open + ",{'z':1.2,'texture':'#808080'},{" + open + "]}";
  };
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1,'sectors':{" +
      test::sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3,
                       "[" + kSolid + "," + barTo("b") + "," + kSolid + "," + kSolid + "]") +
      "," +
      test::sectorText("b", "4,0, 8,0, 8,4, 4,4", 0, 3,
                       "[" + kSolid + "," + kSolid + "," + kSolid + "," + barTo("a") + "]") +
      "}}");
  const Solids solids(loaded.scene());
  const SectorId a = test::sectorNamed(loaded.level, "a");
  const Body body = bodyOf(loaded.level, 0);
  EXPECT_FALSE(solids.isFree(a, {3.9, 2, 0}, body, 90)) << "0.2 m high, 0.1 m off";
  EXPECT_FALSE(solids.isFree(a, {3.9, 2, 1.15}, body, 90));
  EXPECT_TRUE(solids.isFree(a, {3.9, 2, 1.2}, body, 90)) << "above it";
  EXPECT_TRUE(solids.isFree(a, {3.69, 2, 0}, body, 90));
}

TEST(Solids, FindsAWallThatIsNearerThanTheRadiusByTwoMicrometres) {
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1,'sectors':{" + test::sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3) + "}}");
  const Solids solids(loaded.scene());
  const Body body = bodyOf(loaded.level, 0);
  EXPECT_FALSE(solids.isFree(SectorId(0), {2, 0.3 - 2e-6, 0}, body, 90));
  EXPECT_TRUE(solids.isFree(SectorId(0), {2, 0.3 + 1e-9, 0}, body, 90));
}

TEST(Solids, FindsAWallWithoutThicknessThatPointsToTheAxis) {
  const auto to = [](const std::string& next) {
    return "{'texture':'#808080','next':'" + next + "'}";
  };
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1,'sectors':{" +
      test::sectorText(
          "a", "0,0, 2,0, 2,2, 2,4, 0,4", 0, 3,
          "[" + kSolid + "," + to("c") + "," + to("b") + "," + kSolid + "," + kSolid + "]") +
      "," +
      test::sectorText("b", "2,2, 4,2, 4,4, 2,4", 0, 3,
                       "[" + kSolid + "," + kSolid + "," + kSolid + "," + to("a") + "]") +
      "," +
      test::sectorText("c", "2,0, 4,0, 4,2, 2,2", 0, 3,
                       "[" + kSolid + "," + kSolid + "," + kSolid + "," + to("a") + "]") +
      "}}");
  const Solids solids(loaded.scene());
  const SectorId a = test::sectorNamed(loaded.level, "a");
  const Body body = bodyOf(loaded.level, 0);
  EXPECT_FALSE(solids.isFree(a, {1.8, 2, 0}, body, 90));
  EXPECT_TRUE(solids.isFree(a, {1.69, 2, 0}, body, 90));
}

}  // namespace
}  // namespace hearth::random_walks
