#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "level/scene.h"
#include "light/bakery.h"

namespace hearth {

/// A bake as the bytes of a file, which saved_bake.md describes. `texel` is that of the bake, in
/// metres. `settings` describes how it was baked, in at most kMaxSettingsBytes; nothing depends on
/// it.
std::string encodeBake(const Scene& scene, const BakedLight& light, double texel,
                       std::string_view settings);

inline constexpr std::size_t kMaxSettingsBytes = 1000;

/// Why bytes are refused.
struct BakeMistake {
  std::string what;         ///< a predicate; the name of the file goes before it
  bool isTooLarge = false;  ///< more light than allowed, and no other known mistake
};

/// The light in such bytes, which any program may have written: one bake, or several of a level
/// with its movers at rest, one after the other. The first is taken that belongs to the scene's
/// geometry; textures, lights and sector light may differ. `maxLightBytes` limits all unpacked
/// lightmaps of this one together. More are refused before memory is taken. Decoding takes at most
/// twice that, and the memory of the scene's surfaces.
tl::expected<BakedLight, BakeMistake> decodeBake(const Scene& scene, std::string_view bytes,
                                                 std::uint64_t maxLightBytes);

}  // namespace hearth
