#include <gtest/gtest.h>

#include "load_text.h"
#include "random_levels/random_level.h"
#include "support/temporary_folder.h"

namespace hearth {
namespace {

TEST(RandomLevels, loadWithoutAnErrorAndFitTogetherToTheBit) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRandomLevelTextures(folder.path() / "textures"));
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const RandomLevel level = makeRandomLevel(seed);
    ASSERT_TRUE(writeRandomLevel(folder.path(), level));
    const LoadResult result = loadLevel(folder.path() / (level.name + ".json"));
    ASSERT_TRUE(result.loaded) << listed(result);
    expectTwins(result.loaded->scene());
  }
}

}  // namespace
}  // namespace hearth
