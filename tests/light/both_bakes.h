#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "light/light_cost.h"
#include "load/load.h"

namespace hearth::test {

/// Random levels, by way of files.
class RandomLevels {
 public:
  RandomLevels();
  ~RandomLevels();
  RandomLevels(const RandomLevels&) = delete;
  RandomLevels& operator=(const RandomLevels&) = delete;

  LoadedLevel level(std::uint64_t seed) const;

 private:
  std::filesystem::path folder_;
};

/// Every second light a ball; which, and how large, depends on the seed.
LoadedLevel withBalls(LoadedLevel loaded, std::uint64_t seed);

/// What two bakes took.
struct BothCosts {
  LightCost byShafts;
  LightCost byRays;
};

/// Bakes every surface with shafts and with rays alone, and expects the same bytes and counts.
void expectSameBakes(const Scene& scene, const BakeSettings& settings, const std::string& what,
                     BothCosts& costs);

/// For random levels of seeds [first, last), with points and with balls, in all ways of sampling.
void expectSameRandomBakes(std::uint64_t first, std::uint64_t last);

}  // namespace hearth::test
