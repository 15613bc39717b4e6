#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "level/level.h"
#include "light/bakery.h"

namespace hearth {

/// A bake as the bytes of a file, which saved_bake.md describes. `texel`: metres, that of the bake.
/// `settings`: words about how it was baked, at most kMostSettingsBytes; nothing depends on them.
std::string encodeBake(const Level& level, const BakedLight& light, double texel,
                       std::string_view settings);

inline constexpr std::size_t kMostSettingsBytes = 1000;

/// The light of such bytes, whoever wrote them. They must belong to the level's geometry; its
/// textures, lights and sector light may be others. Takes no more memory than the bytes and the
/// level's surfaces do. The error is a predicate, to be put after the name of the file.
tl::expected<BakedLight, std::string> decodeBake(const Level& level, std::string_view bytes);

}  // namespace hearth
