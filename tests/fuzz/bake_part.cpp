// Bytes of a fuzzer as parts of a level's bake: each is refused with a message, or is light that
// can be drawn.

#include "light/bake_part.h"

#include <cstdint>
#include <string>
#include <string_view>

#include "light/parts/part_frame.h"
#include "load/load.h"
#include "math/check.h"
#include "render/renderer.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

/// The level is the program's argument to every input, so it is loaded once.
const LoadedLevel& level() {
  static const LoadedLevel loaded =
      loadLevel(test::inTree("tests/levels/rooms.json")).loaded.value();
  return loaded;
}

const BakeInParts& wholeBake() {
  static const BakeInParts bake(level().scene(), {.texel = 1}, "");
  return bake;
}

void tryOut(const std::string& bytes) {
  const auto number = partNumberOf(wholeBake(), bytes);
  if (!number) CHECK(!number.error().empty());
  if (!number || number->parts != 1) return;
  const auto light = joinParts(wholeBake(), {&bytes, 1}, 1);
  if (!light) {
    CHECK(light.error().part == 0 && !light.error().what.empty());
    return;
  }
  const Camera camera{SectorId(0), {1, 2, 1.5}, 30, -20, 90, 12, 8};
  (void)Renderer(level().scene(), level().textures, *light).draw(camera, LightMode::Both);
}

}  // namespace
}  // namespace hearth

/// The bytes as a file, and as sums within the header and checksum that no fuzzer would guess.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(data, data + size);
  hearth::tryOut(bytes);
  hearth::tryOut(hearth::framed(hearth::wholeBake(), {1, 1}, {&bytes, 1}));
  return 0;
}
