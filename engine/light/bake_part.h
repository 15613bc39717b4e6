#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "level/scene.h"
#include "light/bakery.h"

/// Bakes in parts, of which each is baked by itself: in another process, on another machine, at
/// another time. Together they are the whole bake, to the byte. bake_part.md describes their bytes.
namespace hearth {

/// The most parts into which a bake is divided.
inline constexpr std::uint32_t kMaxParts = 1'000'000;

/// Part 1 to `parts`, of so many.
struct PartNumber {
  std::uint32_t part = 1;
  std::uint32_t parts = 1;

  friend bool operator==(const PartNumber&, const PartNumber&) = default;
};

/// What all parts of a bake have in common.
class BakeInParts {
 public:
  /// `settings` must pass mistakeInSettings(). `settingsText` describes them in at most
  /// kMaxSettingsBytes; parts with another text do not fit.
  BakeInParts(const Scene& scene, const BakeSettings& settings, std::string settingsText);

  const Scene& scene() const { return scene_; }
  const BakeSettings& settings() const { return settings_; }
  const std::string& settingsText() const { return settingsText_; }
  std::uint64_t geometryHash() const { return geometryHash_; }
  std::uint64_t lightHash() const { return lightHash_; }

 private:
  Scene scene_;
  BakeSettings settings_;
  std::string settingsText_;
  std::uint64_t geometryHash_;
  std::uint64_t lightHash_;
};

/// Bakes a part, and returns it as the bytes of a file. They do not depend on `threads`.
/// `progress`, if any, must be new; it is complete on return.
std::string bakePart(const BakeInParts& bake, PartNumber number, int threads,
                     BakeProgress* progress = nullptr);

/// Which part of the bake some bytes are. The error is a predicate, such as "was baked with other
/// lights"; the name of the file goes before it.
tl::expected<PartNumber, std::string> partNumberOf(const BakeInParts& bake, std::string_view bytes);

/// Why parts cannot be joined.
struct JoinMistake {
  std::size_t part;  ///< its index
  std::string what;  ///< a predicate
};

/// The light of all parts of a bake, in their order. partNumberOf() must have accepted each. The
/// result is that of bake(), without costs.
tl::expected<BakedLight, JoinMistake> joinParts(const BakeInParts& bake,
                                                std::span<const std::string> parts, int threads);

}  // namespace hearth
