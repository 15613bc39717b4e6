// Imports all maps of WADs with what moves in them, and counts what becomes of it.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "import/doom/map.h"
#include "worlds/moving_world.h"

namespace {

using namespace hearth;
using worlds::MovingWorld;

/// Of maps that have lines that end them.
void printExits(const std::vector<MovingWorld>& all) {
  std::vector<std::string> missed;
  std::size_t exits = 0;
  for (const MovingWorld& world : all) {
    if (!world.isExitReached) continue;
    ++exits;
    if (!*world.isExitReached) missed.push_back(world.map);
  }
  fmt::print("\nWays from the start to an exit: in {} of {} maps with exits; not in {}\n",
             exits - missed.size(), exits, fmt::join(missed, ", "));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Imports maps of Doom with what moves in them.");
  std::vector<std::string> files{"/usr/share/games/doom/freedoom1.wad",
                                 "/usr/share/games/doom/freedoom2.wad"};
  app.add_option("WAD", files, "archives with maps")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-movers-{}", ::getpid());
  std::vector<MovingWorld> all;
  std::size_t errors = 0;
  std::size_t movers = 0;
  for (const std::string& file : files) {
    const auto archive = worlds::Archive::open(file);
    if (!archive) {
      fmt::print(stderr, "{}\n", archive.error());
      return 2;
    }
    for (const std::string& map : doom::mapNames(archive->wad())) {
      all.push_back(worlds::importMoving(*archive, map, folder));
      for (const std::string& error : all.back().errors) fmt::print(stderr, "{}: {}\n", map, error);
      errors += all.back().errors.size();
      movers += all.back().movers;
    }
  }
  std::filesystem::remove_all(folder);
  fmt::print("{} maps, {} movers\n\n{}", all.size(), movers, worlds::fateTables(all));
  printExits(all);
  return errors == 0 ? 0 : 1;
}
