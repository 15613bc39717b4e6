#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <mutex>
#include <random>

#include "area_light/compare_areas.h"
#include "math/parallel.h"
#include "random_levels/random_level.h"

namespace {

using hearth::area_light::Areas;
using hearth::area_light::AreaTally;

AreaTally compareRandomLevels(std::uint64_t count, std::uint64_t firstSeed, Areas areas,
                              double gatherError, int threads) {
  const auto folder = std::filesystem::temp_directory_path() /
                      fmt::format("hearth-area-light-{}", std::random_device{}());
  if (const auto written = hearth::writeRandomLevelTextures(folder / "textures"); !written) {
    fmt::print(stderr, "{}\n", written.error());
    std::exit(2);
  }
  std::vector<AreaTally> tallies(count);
  hearth::parallelFor(count, threads, [&](std::size_t i) {
    tallies[i] = hearth::area_light::compareRandomLevel(firstSeed + i, areas, folder, gatherError);
  });
  std::filesystem::remove_all(folder);
  AreaTally all;
  for (const AreaTally& tally : tallies) all += tally;
  return all;
}

AreaTally compareFiles(const std::vector<std::string>& files, Areas areas, int places,
                       double gatherError, int threads) {
  AreaTally all;
  for (const std::string& file : files) {
    hearth::LoadResult result = hearth::loadLevel(file);
    for (const hearth::Diagnostic& diagnostic : result.diagnostics)
      fmt::print(stderr, "{}\n", hearth::format(diagnostic));
    if (!result.loaded) std::exit(2);
    result.loaded->level.bake.gatherError = gatherError;
    all +=
        hearth::area_light::compareTexels(*std::move(result.loaded), areas, file, places, threads);
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Holds the light of areas against truth, by kind of surface.");
  std::vector<std::string> files;
  int places = 1000;
  std::uint64_t count = 2000;
  std::uint64_t firstSeed = 1;
  bool haveEmitters = false;
  bool haveBounces = false;
  double gatherError = hearth::BakeSettings{}.gatherError;
  int threads = hearth::availableThreads();
  app.add_option("LEVEL", files, "level files; default: random levels");
  app.add_option("--places", places, "texels of each of the files")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--levels", count, "random levels")->capture_default_str();
  app.add_option("--seed", firstSeed, "seed of the first")->capture_default_str();
  app.add_flag("--emitters", haveEmitters, "surfaces shine instead of the sky");
  app.add_flag("--bounces", haveBounces, "light of all lights bounces");
  app.add_option("--gather-error", gatherError, "levels: see the option of the program")
      ->check(CLI::Range(0.0625, 64.0))
      ->capture_default_str();
  app.add_option("--threads", threads, "random levels compared at a time, or places of a file")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const Areas areas = haveBounces ? Areas::Bounces : haveEmitters ? Areas::Emitters : Areas::Sky;
  const AreaTally tally = files.empty()
                              ? compareRandomLevels(count, firstSeed, areas, gatherError, threads)
                              : compareFiles(files, areas, places, gatherError, threads);
  fmt::print("{}", hearth::area_light::table(tally));
  const hearth::area_light::Errors sum = tally.sum();
  constexpr double kMostRms = 2;         // levels
  constexpr double kMostFar = 1 / 100.;  // of places
  const bool isGood = sum.rms() <= kMostRms &&
                      static_cast<double>(sum.far) <= kMostFar * static_cast<double>(sum.places);
  return isGood ? 0 : 1;
}
