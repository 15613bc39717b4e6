#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "light/bake_part.h"

namespace hearth {

/// The sums of a part's tiles, one after the other, between its header and its checksum.
std::string framed(const BakeInParts& bake, PartNumber number,
                   std::span<const std::string> sumsOfTiles);

/// Which part of a bake some bytes are, if they are all of it and as it was written.
tl::expected<PartNumber, std::string> numberIn(const BakeInParts& bake, std::string_view bytes);

/// The sums of a part that numberIn() has accepted.
std::string_view sumsIn(std::string_view bytes);

}  // namespace hearth
