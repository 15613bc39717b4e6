#include "import/doom/palette.h"

#include <fmt/format.h>

namespace hearth::doom {

tl::expected<Palette, std::string> readPalette(const Wad& wad) {
  Palette palette;
  const Bytes bytes = wad.bytesOf("PLAYPAL");
  if (bytes.size() < 3 * palette.size())
    return tl::unexpected(fmt::format("PLAYPAL, the palette, has {} bytes: {} are needed",
                                      bytes.size(), 3 * palette.size()));
  for (std::size_t i = 0; i < palette.size(); ++i)
    palette[i] = {bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]};
  return palette;
}

}  // namespace hearth::doom
