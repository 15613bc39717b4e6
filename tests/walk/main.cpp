#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <mutex>

#include "math/parallel.h"
#include "random_levels/random_level.h"
#include "walk_tests/random_walks.h"

int main(int argc, char** argv) {
  using namespace hearth;
  CLI::App app("Walks random levels and holds what the walker promises after every tick.");
  std::uint64_t walks = 1000;
  std::uint64_t firstSeed = 1;
  constexpr int kWalksPerLevel = 5;
  random_walks::Effort effort{.walks = kWalksPerLevel, .ticks = 10000, .lines = 3};
  int solidThings = 0;
  bool hasMovers = false;
  int threads = availableThreads();
  app.add_option("--walks", walks, "walks, five in each level")->capture_default_str();
  app.add_option("--ticks", effort.ticks, "of each walk")->capture_default_str();
  app.add_option("--seed", firstSeed, "of the first level")->capture_default_str();
  app.add_option("--threads", threads, "levels at a time")->capture_default_str();
  app.add_option("--lines", effort.lines, "that are looked along after each tick")
      ->capture_default_str();
  app.add_option("--solid-things", solidThings, "in each level")->capture_default_str();
  app.add_flag("--movers", hasMovers, "levels in which something moves, without solid things");
  CLI11_PARSE(app, argc, argv);

  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-random-walks-{}", ::getpid());
  if (const auto written = writeRandomLevelTextures(folder / "textures"); !written) {
    fmt::print(stderr, "{}\n", written.error());
    return 2;
  }
  random_walks::Report report;
  std::mutex mutex;
  parallelFor((walks + kWalksPerLevel - 1) / kWalksPerLevel, threads, [&](std::size_t i) {
    const auto one =
        hasMovers ? random_walks::walkMovingLevel(firstSeed + i, folder, effort)
                  : random_walks::walkRandomLevel(firstSeed + i, folder, effort, solidThings);
    const std::lock_guard lock(mutex);
    report += one;
    if (one.failures > 0) fmt::print(stderr, "{}\n", one.first);
  });
  std::filesystem::remove_all(folder);
  fmt::print("{}\n", random_walks::inWords(report));
  return report.failures == 0 ? 0 : 1;
}
