// Rebakes of levels with meshes: only those are lit anew on which a change can show.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "light/lit_mesh.h"
#include "light/rebake.h"
#include "same_bakes.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

/// A lamp in each of two halls that nothing joins, and boxes.
struct TwoHalls {
  double nearLamp = 2;  ///< its x
  double farCeiling = 6;
  std::string things;

  LoadedLevel loaded() const {
    return test::levelFrom(
        fmt::format("{{'things':[{}],'sectors':{{{},{}}}}}", things,
                    test::sectorText("near", "0,0, 12,0, 12,8, 0,8", 0, 6),
                    test::sectorText("far", "20,0, 32,0, 32,8, 20,8", 0, farCeiling)),
        fmt::format("[{{'x':{},'y':4,'z':3,'sector':'near'}},"
                    "{{'x':22,'y':4,'z':3,'sector':'far'}}]",
                    nearLamp),
        {{"box.obj", test::kBoxModel}});
  }
};

// In the air: samples that lie in a mesh make all lights of a sector depend on it.
constexpr std::string_view kNearBox = "{'mesh':'box.obj','x':4,'y':4,'z':1}";
constexpr std::string_view kFarBox = "{'mesh':'box.obj','x':24,'y':4,'z':1,'angle':30}";

/// Bakes what has changed; the texels that are left, once for each light.
std::int64_t rebaked(LightMemory& memory, const LoadedLevel& loaded) {
  Rebake rebake(memory, loaded.scene(), loaded.level.bake, 2);
  const std::int64_t left = rebake.texelLightsLeft();
  const std::optional<BakedLight> light = rebake.finish();
  EXPECT_TRUE(light);
  if (light) test::expectSame(loaded.scene(), *light, bake(loaded.scene(), loaded.level.bake, 2));
  return left;
}

/// Of an edit from `before` to `after`, the texels of meshes alone.
std::int64_t texelsOfMeshesLeft(TwoHalls before, TwoHalls after) {
  LightMemory memory;
  rebaked(memory, before.loaded());
  const std::int64_t left = rebaked(memory, after.loaded());
  before.things.clear();
  after.things.clear();
  LightMemory withoutMeshes;
  rebaked(withoutMeshes, before.loaded());
  return left - rebaked(withoutMeshes, after.loaded());
}

TwoHalls hallsWithBoxes() { return {.things = fmt::format("{},{}", kNearBox, kFarBox)}; }

std::int64_t texelsOf(const TwoHalls& halls, std::size_t mesh) {
  const LoadedLevel loaded = halls.loaded();
  return bake(loaded.scene(), loaded.level.bake, 2).meshes[mesh].texels.count();
}

TEST(MeshRebake, asksForNothingWhereNothingHasChanged) {
  LightMemory memory;
  EXPECT_GT(rebaked(memory, hallsWithBoxes().loaded()), 0);
  EXPECT_EQ(rebaked(memory, hallsWithBoxes().loaded()), 0);
}

TEST(MeshRebake, lightsOnlyTheMeshOnWhichAChangedLightShines) {
  TwoHalls moved = hallsWithBoxes();
  moved.nearLamp = 2.5;
  EXPECT_EQ(texelsOfMeshesLeft(hallsWithBoxes(), moved), texelsOf(moved, 0));
}

TEST(MeshRebake, lightsOnlyTheMeshWhoseSectorHasChanged) {
  TwoHalls higher = hallsWithBoxes();
  higher.farCeiling = 7;
  EXPECT_EQ(texelsOfMeshesLeft(hallsWithBoxes(), higher), texelsOf(higher, 1));
}

TEST(MeshRebake, draftsMeshesWithTheirLightWhereThatIsKnown) {
  LightMemory memory;
  rebaked(memory, hallsWithBoxes().loaded());
  TwoHalls moved = hallsWithBoxes();
  moved.nearLamp = 2.5;
  const LoadedLevel loaded = moved.loaded();
  const BakedLight draft = Rebake(memory, loaded.scene(), loaded.level.bake, 2).draft();
  const BakedLight whole = bake(loaded.scene(), loaded.level.bake, 2);
  for (const Mesh& mesh : loaded.level.meshes) {
    ASSERT_TRUE(draft.lightmaps[mesh.surface.index()]);
    EXPECT_EQ(draft.lightmaps[mesh.surface.index()]->levels,
              whole.lightmaps[mesh.surface.index()]->levels);
  }
}

/// Of 80 boxes most are left when the surfaces of the halls are lit.
TEST(MeshRebake, goesOnFromTheMeshAtWhichItWasStopped) {
  TwoHalls halls;
  for (int i = 0; i < 80; ++i)
    halls.things += fmt::format("{}{{'mesh':'box.obj','x':{},'y':{},'scale':0.3,'angle':{}}}",
                                i > 0 ? "," : "", 1 + (i % 10), 1 + 0.7 * (i / 10), i);
  const LoadedLevel loaded = halls.loaded();
  std::int64_t texelsOfBoxes = 0;
  for (const LitMesh& box : makeLitMeshes(loaded.level, loaded.level.bake.texel, 1))
    texelsOfBoxes += box.texels.count();
  // On a busy machine the thread that stops a bake may come too late; then another bake is begun.
  std::unique_ptr<LightMemory> memory;
  std::int64_t all = 0;
  bool isStopped = false;
  for (int tries = 0; tries < 100 && !isStopped; ++tries) {
    memory = std::make_unique<LightMemory>();
    Rebake first(*memory, loaded.scene(), loaded.level.bake, 1);
    all = first.texelLightsLeft();
    BakeProgress progress;
    std::stop_source stop;
    const std::jthread stopper([&](const std::stop_token& isOver) {
      while (!isOver.stop_requested() &&
             (progress.texels() == 0 ||
              progress.texelsDone() <= progress.texels() - texelsOfBoxes / 2))
        std::this_thread::yield();
      stop.request_stop();
    });
    isStopped =
        !first.finish(&progress, stop.get_token()) && progress.texelsDone() < progress.texels();
  }
  ASSERT_TRUE(isStopped);
  Rebake rebake(*memory, loaded.scene(), loaded.level.bake, 2);
  EXPECT_LT(2 * rebake.texelLightsLeft(), all);
  const std::optional<BakedLight> light = rebake.finish();
  ASSERT_TRUE(light);
  test::expectSame(loaded.scene(), *light, bake(loaded.scene(), loaded.level.bake, 2));
}

/// Light comes into two sectors at one place, into each through a part of the opening.
TEST(MeshRebake, tellsMeshesAtOnePlaceApartByTheirSectors) {
  const LoadedLevel loaded = test::levelFrom(
      "{'things':[{'mesh':'box.obj','x':9,'y':4,'sector':'low'},"
      "{'mesh':'box.obj','x':9,'y':4,'sector':'high'}],'sectors':{" +
          test::sectorText("west", "0,0, 6,0, 6,8, 0,8", 0, 6,
                           "[{'texture':'#808080'},"
                           "{'walls':[{'next':'low','z':1.5},{'next':'high'}]},"
                           "{'texture':'#808080'},{'texture':'#808080'}]") +
          "," + test::sectorText("low", "6,0, 12,0, 12,8, 6,8", 0, 6) + "," +
          test::sectorText("high", "6,0, 12,0, 12,8, 6,8", 0, 6) + "}}",
      "[{'x':2,'y':4,'z':3,'sector':'west'}]", {{"box.obj", test::kBoxModel}});
  LightMemory memory;
  for (int i = 0; i < 3; ++i) rebaked(memory, loaded);
}

/// A narrow strip along the x axis, and at its end a square across that axis with its back to it.
constexpr std::string_view kFarPanel =
    "v 0 5 0\nv 9 5 0\nv 9 5 0.1\nv 0 5 0.1\nf 1 2 3 4\n"
    "v 9 1 3\nv 9 1 1\nv 9 3 1\nv 9 3 3\nf 5 6 7 8\n";

/// A lamp in an alcove lights the wall at x = 0, and sees neither the passage opposite nor the hall
/// behind that. A mesh of the room has a face in the hall: what is before its back counts as inside
/// of the mesh, as long as the hall's ceiling leaves the way open.
LoadedLevel faceBehindAPassage(double hallCeiling) {
  const std::string plain = "{'texture':'#808080'}";
  const auto open = [](std::string_view next) {
    return fmt::format("{{'walls':[{{'next':'{}'}}]}}", next);
  };
  const auto list = [](const std::vector<std::string>& walls) {
    return fmt::format("[{}]", fmt::join(walls, ","));
  };
  const std::vector<std::string> sectors{
      test::sectorText("alcove", "0,8, 4,8, 4,16, 0,16", 0, 6,
                       list({open("room"), plain, plain, plain})),
      test::sectorText("room", "0,0, 12,0, 12,8, 4,8, 0,8", 0, 6,
                       list({plain, open("passage"), plain, open("alcove"), plain})),
      test::sectorText(
          "passage", "12,0, 15,0, 15,8, 12,8", 0, 6,
          list({plain, "{'walls':[{'upper':'#808080','next':'hall'}]}", plain, open("room")})),
      test::sectorText("hall", "15,0, 24,0, 24,8, 15,8", 0, hallCeiling,
                       list({plain, plain, plain, open("passage")}))};
  return test::levelFrom(
      fmt::format("{{'things':[{{'mesh':'far.obj','x':8,'y':4,'z':0,'sector':'room'}}],"
                  "'sectors':{{{}}}}}",
                  fmt::join(sectors, ",")),
      "[{'x':2,'y':15,'z':3,'sector':'alcove','falloff':0.1}]", {{"far.obj", kFarPanel}});
}

TEST(MeshRebake, isTheFullBakeWhereTheWayToAFaceFarBeforeAWallIsClosed) {
  LightMemory memory;
  for (const double ceiling : {6.0, 0.5, 6.0}) rebaked(memory, faceBehindAPassage(ceiling));
}

TEST(MeshRebake, isTheFullBakeWhereAMeshHasMoved) {
  LightMemory memory;
  for (const double x : {4.0, 4.0, 7.0, 5.0}) {
    const TwoHalls halls{.things = fmt::format("{{'mesh':'box.obj','x':{},'y':4}}", x)};
    rebaked(memory, halls.loaded());
  }
}

}  // namespace
}  // namespace hearth
