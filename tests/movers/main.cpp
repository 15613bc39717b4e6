#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <mutex>
#include <random>

#include "math/parallel.h"
#include "movers/compare_movers.h"
#include "random_levels/random_level.h"

int main(int argc, char** argv) {
  CLI::App app("Holds random levels whose flats move against levels that are authored so.");
  std::uint64_t count = 2000;
  std::uint64_t firstSeed = 1;
  int threads = hearth::availableThreads();
  app.add_option("--levels", count, "random levels")->capture_default_str();
  app.add_option("--seed", firstSeed, "seed of the first")->capture_default_str();
  app.add_option("--threads", threads, "levels compared at a time")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const auto folder = std::filesystem::temp_directory_path() /
                      fmt::format("hearth-movers-{}", std::random_device{}());
  if (const auto written = hearth::writeRandomLevelTextures(folder / "textures"); !written) {
    fmt::print(stderr, "{}\n", written.error());
    return 2;
  }
  hearth::movers::MoverTally tally;
  std::mutex mutex;
  hearth::parallelFor(count, threads, [&](std::size_t i) {
    const auto one = hearth::movers::compareRandomMovers(firstSeed + i, folder);
    const std::lock_guard lock(mutex);
    tally += one;
  });
  std::filesystem::remove_all(folder);
  fmt::print("{}", hearth::movers::inWords(tally));
  if (!tally.firstFailure.empty()) fmt::print("first: {}\n", tally.firstFailure);
  return tally.failed == 0 ? 0 : 1;
}
