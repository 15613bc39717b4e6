#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "level/scene.h"
#include "light/bakery.h"

namespace hearth {

/// Earlier bakes, as saved bakes in a folder that may be emptied at any time. Several programs can
/// use one folder at once. If anything is wrong with the folder or a file in it, the light is baked
/// as if there were no cache.
class BakeCache {
 public:
  static constexpr std::uint64_t kMaxBytes = 256 << 20;

  /// `program` identifies the program that bakes, because another may bake other light. All bakes
  /// together take at most `maxBytes`; the least recently used are removed.
  BakeCache(std::filesystem::path folder, std::uint64_t program, std::uint64_t maxBytes = kMaxBytes)
      : folder_(std::move(folder)), program_(program), maxBytes_(maxBytes) {}

  /// The one of the user: `hearth` in $XDG_CACHE_HOME, which is ~/.cache where it is not set (XDG
  /// Base Directory Specification). None if there is no such place, or if the program cannot be
  /// identified.
  static std::optional<BakeCache> ofUser();

  /// The light as the program would bake it; none if it is missing or damaged.
  std::optional<BakedLight> find(const Scene& scene, const BakeSettings& settings) const;
  /// Keeps a bake, whole or not at all.
  void keep(const Scene& scene, const BakeSettings& settings, const BakedLight& light) const;

 private:
  std::filesystem::path fileOf(const Scene& scene, const BakeSettings& settings) const;
  void makeRoom() const;

  std::filesystem::path folder_;
  std::uint64_t program_;
  std::uint64_t maxBytes_;
};

}  // namespace hearth
