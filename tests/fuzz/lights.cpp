// Bytes of a fuzzer as a lights file of one level: each is refused with a message at its place, or
// is light that can be baked.

#include "fuzzed_level.h"
#include "scratch_folder.h"
#include "support/in_tree.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const hearth::fuzz::ScratchFolder folder;
  static const auto level = folder.write(
      "level.json", hearth::fuzz::bytesOf(hearth::test::inTree("tests/levels/rooms.json")));
  (void)folder.write("level.lights.json", hearth::fuzz::asText(data, size));
  const hearth::LoadResult result = hearth::loadLevel(level);
  hearth::fuzz::expectSaid(result);
  if (result.loaded) hearth::fuzz::expectUsable(*result.loaded);
  return 0;
}
