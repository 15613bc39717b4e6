#include "cli/info/engine_features.h"

#include <gtest/gtest.h>

#include <map>
#include <string_view>

#include "light/bakery.h"
#include "loaded.h"

namespace hearth {
namespace {

TEST(EngineFeatures, CountWallsAsTheyWereWritten) {
  const LoadedLevel tutorial = loaded("levels/tutorial.json");
  const BakedLight light = bake(tutorial.scene(), {.texel = 0.5}, 2);
  std::map<std::string_view, EngineFeatureUse> uses;
  for (const EngineFeatureUse& use :
       engineFeatureUses(tutorial, lightReport(tutorial.scene(), light)))
    uses.insert({use.name, use});
  EXPECT_EQ(uses.at("walls that are stacks").used, 18);
  EXPECT_EQ(uses.at("sectors with a slope").of, std::ssize(tutorial.level.sectors));
  EXPECT_LT(uses.at("walls that are stacks").of, std::ssize(tutorial.level.segments));
  EXPECT_EQ(uses.at("images that a surface wears").used, 6);
  EXPECT_EQ(uses.at("images that a surface wears").of, 6);
  for (const auto& [name, use] : uses) {
    EXPECT_LE(0, use.used) << name;
    EXPECT_LE(use.used, use.of) << name;
  }
}

}  // namespace
}  // namespace hearth
