// Bytes of a fuzzer as a level file: each is refused with a message at its place, or is a level
// that can be looked at from anywhere and baked. grille.png, which has holes, lies beside it.

#include "fuzzed_level.h"
#include "scratch_folder.h"
#include "support/in_tree.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const hearth::fuzz::ScratchFolder folder;
  static const auto picture [[maybe_unused]] = folder.write(
      "grille.png", hearth::fuzz::bytesOf(hearth::test::inTree("textures/grille.png")));
  const auto file = folder.write("level.json", hearth::fuzz::asText(data, size));
  const hearth::LoadResult result = hearth::loadLevel(file);
  hearth::fuzz::expectSaid(result);
  if (result.loaded) hearth::fuzz::expectUsable(*result.loaded);
  return 0;
}
