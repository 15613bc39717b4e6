#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "level/scene.h"
#include "light/bakery.h"

namespace hearth {

/// A bake as the bytes of a file, which saved_bake.md describes. `texel`: metres, that of the bake.
/// `settings`: words about how it was baked, at most kMostSettingsBytes; nothing depends on them.
std::string encodeBake(const Scene& scene, const BakedLight& light, double texel,
                       std::string_view settings);

inline constexpr std::size_t kMostSettingsBytes = 1000;

/// Why bytes are not taken.
struct BakeMistake {
  std::string what;         ///< a predicate, to be put after the name of the file
  bool isTooLarge = false;  ///< more light than was allowed, and nothing else that is known
};

/// The light of such bytes, which any program may have written. They must belong to the scene's
/// geometry; its textures, lights and sector light may be others. `maxLightBytes`: of all
/// lightmaps, unpacked. More are refused before memory is taken, and no more is taken than twice
/// that and what the scene's surfaces do.
tl::expected<BakedLight, BakeMistake> decodeBake(const Scene& scene, std::string_view bytes,
                                                 std::uint64_t maxLightBytes);

}  // namespace hearth
