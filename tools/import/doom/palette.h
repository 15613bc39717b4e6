#pragma once

#include <array>
#include <string>
#include <tl/expected.hpp>

#include "image/image.h"
#include "import/doom/wad.h"

namespace hearth::doom {

/// What the bytes of pictures stand for.
using Palette = std::array<Rgb, 256>;

/// The first palette of the lump PLAYPAL, in which 256 times red, green and blue lie one behind the
/// other (https://doomwiki.org/wiki/PLAYPAL). The others there tint the screen of a player who is
/// hurt or has picked something up.
tl::expected<Palette, std::string> readPalette(const Wad& wad);

}  // namespace hearth::doom
