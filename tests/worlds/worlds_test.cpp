#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <ostream>

#include "worlds/world.h"

namespace hearth::worlds {
namespace {

/// A map, and which of Freedoom's archives has it.
struct MapOf {
  const char* archive;
  const char* map;

  friend void PrintTo(const MapOf& of, std::ostream* out) { *out << of.archive << ' ' << of.map; }
};

class Worlds : public testing::TestWithParam<MapOf> {};

TEST_P(Worlds, lookAsTruthHasThem) {
  const std::filesystem::path path =
      std::filesystem::path("/usr/share/games/doom") / GetParam().archive;
  ASSERT_TRUE(std::filesystem::exists(path))
      << path << " is missing: tools/setup test installs the package freedoom";
  const auto archive = Archive::open(path);
  ASSERT_TRUE(archive) << archive.error();
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-worlds-{}", ::getpid());
  Looks looks;
  looks.places = 12;
  const World world = lookAt(*archive, GetParam().map, looks, folder);
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(world.errors.empty()) << world.errors.front();
  EXPECT_EQ(world.tally.views, 13);
  EXPECT_EQ(world.tally.holes, 0) << world.tally.firstMiss;
  EXPECT_EQ(world.tally.missed(), 0) << world.tally.firstMiss << '\n'
                                     << agreement::table(world.tally);
}

// A first one; one whose lights hang near corners; and one whose lines cross.
INSTANTIATE_TEST_SUITE_P(Freedoom, Worlds,
                         testing::Values(MapOf{"freedoom1.wad", "E1M1"},
                                         MapOf{"freedoom2.wad", "MAP05"},
                                         MapOf{"freedoom2.wad", "MAP20"}),
                         [](const auto& world) { return std::string(world.param.map); });

}  // namespace
}  // namespace hearth::worlds
