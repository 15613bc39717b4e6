// Bytes of a fuzzer as a WAD: it is refused with a message, or each of its maps is, or becomes a
// level that loads. All of its pictures of walls and flats are decoded, and those of sprites that
// its maps have.

#include "import/doom/wad.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "import/doom/import_map.h"
#include "import/doom/map.h"
#include "load/load.h"
#include "math/check.h"
#include "scratch_folder.h"

namespace hearth::doom {
namespace {

constexpr std::uint64_t kMaxBytes = 1 << 20;
constexpr std::size_t kMaps = 4;               ///< of a WAD; more only take longer
constexpr std::size_t kImagePixels = 1 << 16;  ///< of a level, the same
constexpr std::size_t kLights = 300;           ///< and again
constexpr std::size_t kSpriteImages = 300;

const fuzz::ScratchFolder& folder() {
  static const fuzz::ScratchFolder folder;
  return folder;
}

void expectDecoded(const tl::expected<Picture, std::string>& picture) {
  if (!picture) {
    CHECK(!picture.error().empty());
    return;
  }
  CHECK(picture->isOpaque.size() == picture->image.pixels().size());
  CHECK(std::ranges::none_of(picture->mistakes, &std::string::empty));
}

void decodeAll(const Pictures& pictures) {
  std::size_t pixels = 0;
  for (const auto& [name, texture] : pictures.walls()) {
    if (texture) pixels += static_cast<std::size_t>(texture->size().width * texture->size().height);
    if (pixels <= kImagePixels) expectDecoded(pictures.wall(name));
  }
  for (const auto& [name, bytes] : pictures.flats()) expectDecoded(pictures.flat(name));
}

void expectLoads(const Converted& converted) {
  CHECK(converted.materials.write(folder().path() / "textures"));
  folder().write("level.lights.json", converted.lights);
  const LoadResult result = loadLevel(folder().write("level.json", converted.level));
  for (const Diagnostic& diagnostic : result.diagnostics)
    CHECK(!diagnostic.isError, format(diagnostic));
}

void tryOut(const Wad& wad, Doors doors, LightFrom lightFrom) {
  static const LightTable lights = parseLightTable(ownLightTable()).value();
  const auto pictures = Pictures::read(wad);
  if (!pictures) {
    CHECK(!pictures.error().empty());
    return;
  }
  decodeAll(*pictures);
  std::vector<std::string> names = mapNames(wad);
  if (names.size() > kMaps) names.resize(kMaps);
  for (const std::string& name : names) {
    Imported imported;
    const auto converted =
        convertMap({wad, *pictures, lights}, name,
                   {.folder = {},
                    .doors = doors,
                    .things = {.game = {}, .hasMonsters = true, .maxImages = kSpriteImages},
                    .imagePixels = kImagePixels,
                    .lightFrom = lightFrom,
                    .lights = kLights},
                   imported);
    if (converted)
      expectLoads(*converted);
    else
      CHECK(!converted.error().empty());
  }
}

}  // namespace
}  // namespace hearth::doom

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = hearth::doom::folder().write("maps.wad", hearth::fuzz::asText(data, size));
  const auto wad = hearth::doom::Wad::open(file, hearth::doom::kMaxBytes);
  // The last byte is of no other meaning in most WADs: a WAD ends with the name of a lump.
  if (wad)
    hearth::doom::tryOut(*wad, static_cast<hearth::doom::Doors>(data[size - 1] % 3),
                         static_cast<hearth::doom::LightFrom>(data[size - 1] / 3 % 2));
  else
    CHECK(!wad.error().empty());
  return 0;
}
