#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "level/scene.h"
#include "light/bakery.h"

namespace hearth {

/// Bakes that were made before, as saved bakes in a folder that may be emptied at any time. Several
/// programs can use one folder at once. Whatever is wrong with the folder or a file in it, the
/// light is then baked as if there were no cache.
class BakeCache {
 public:
  static constexpr std::uint64_t kMostBytes = 256 << 20;

  /// `program`: a number of the program that bakes, as another may bake otherwise. `mostBytes`: of
  /// all bakes; those that were used longest ago give way.
  BakeCache(std::filesystem::path folder, std::uint64_t program,
            std::uint64_t mostBytes = kMostBytes)
      : folder_(std::move(folder)), program_(program), mostBytes_(mostBytes) {}

  /// The one of the user: `hearth` in $XDG_CACHE_HOME, which is ~/.cache where it is not set (XDG
  /// Base Directory Specification). None where there is no such place, or no saying which program
  /// this is.
  static std::optional<BakeCache> ofUser();

  /// The light as the program would bake it; none where it is not there, or not whole.
  std::optional<BakedLight> find(const Scene& scene, const BakeSettings& settings) const;
  /// Does its best, and leaves no half of it.
  void keep(const Scene& scene, const BakeSettings& settings, const BakedLight& light) const;

 private:
  std::filesystem::path fileOf(const Scene& scene, const BakeSettings& settings) const;
  void makeRoom() const;

  std::filesystem::path folder_;
  std::uint64_t program_;
  std::uint64_t mostBytes_;
};

/// A number of all that the light of a level depends on but the program.
std::uint64_t lightHash(const Scene& scene, const BakeSettings& settings);

}  // namespace hearth
