#pragma once

#include <optional>
#include <string>

#include "light/baking/texel_sums.h"
#include "light/byte_stream.h"

namespace hearth {

/// Adds the sums of a tile to bytes, as bake_part.md describes them.
void putSums(std::string& bytes, const TexelSums& sums, const TexelRect& tile);

/// Takes those of a tile; none if no such sums stand there. More memory than that of the tile's
/// sums is never taken.
std::optional<TexelSums> takeSums(ByteReader& in, const TexelRect& tile);

}  // namespace hearth
