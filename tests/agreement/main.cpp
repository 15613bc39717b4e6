#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <mutex>
#include <random>

#include "agreement/compare_level.h"
#include "math/parallel.h"
#include "random_levels/random_level.h"

namespace {

using hearth::agreement::Tally;

Tally compareFiles(const std::vector<std::string>& files) {
  Tally tally;
  for (const std::string& file : files) {
    const hearth::LoadResult result = hearth::loadLevel(file);
    for (const hearth::Diagnostic& diagnostic : result.diagnostics)
      fmt::print(stderr, "{}\n", hearth::format(diagnostic));
    if (!result.loaded) std::exit(2);
    tally += hearth::agreement::compareLevel(*result.loaded, file, SIZE_MAX);
  }
  return tally;
}

Tally compareRandomLevels(std::uint64_t count, std::uint64_t firstSeed, int threads) {
  const auto folder = std::filesystem::temp_directory_path() /
                      fmt::format("hearth-agreement-{}", std::random_device{}());
  if (const auto written = hearth::writeRandomLevelTextures(folder / "textures"); !written) {
    fmt::print(stderr, "{}\n", written.error());
    std::exit(2);
  }
  Tally tally;
  std::mutex mutex;
  hearth::parallelFor(count, threads, [&](std::size_t i) {
    const Tally one = hearth::agreement::compareRandomLevel(firstSeed + i, folder);
    const std::lock_guard lock(mutex);
    tally += one;
    if (!one.firstMiss.empty()) fmt::print(stderr, "{}\n", one.firstMiss);
  });
  std::filesystem::remove_all(folder);
  return tally;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Holds renderer and bakery against truth, pixel by pixel.");
  std::vector<std::string> files;
  std::uint64_t count = 2000;
  std::uint64_t firstSeed = 1;
  int threads = hearth::availableThreads();
  app.add_option("LEVEL", files,
                 "level files, all of whose shots are compared; default: random levels");
  app.add_option("--levels", count, "random levels, four views each")->capture_default_str();
  app.add_option("--seed", firstSeed, "seed of the first")->capture_default_str();
  app.add_option("--threads", threads, "random levels compared at a time")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const bool random = files.empty();
  const Tally tally = random ? compareRandomLevels(count, firstSeed, threads) : compareFiles(files);
  fmt::print("{}", hearth::agreement::table(tally));
  if (!tally.firstMiss.empty()) fmt::print("first miss: {}\n", tally.firstMiss);
  const bool enough = !random || tally.minTested() >= 1000;
  if (!enough) fmt::print("a kind of surface has fewer than 1000 tested pixels\n");
  return tally.missed() == 0 && tally.holes == 0 && enough ? 0 : 1;
}
