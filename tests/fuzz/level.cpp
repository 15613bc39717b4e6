// Bytes of a fuzzer as a level file: each is refused with a message at its place, or is a level
// that can be looked at from anywhere and baked. grille.png, which has holes, lies beside it, and
// crate.obj.

#include "fuzzed_level.h"
#include "scratch_folder.h"
#include "support/in_tree.h"

namespace {

/// A square in two materials, and a triangle without one that stands askew on it.
constexpr std::string_view kModel = R"(mtllib crate.mtl
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v 0.2 1 0.5
vt 0 0
vt 2 1
f 1/1 2/2 5/1
usemtl wood
f 1/1 2/2 3/1
usemtl paint
f 1 3 4
)";
constexpr std::string_view kMaterials = R"(newmtl wood
map_Kd grille.png
newmtl paint
Kd 0.5 0.25 1
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const hearth::fuzz::ScratchFolder folder;
  static const auto picture [[maybe_unused]] = folder.write(
      "grille.png", hearth::fuzz::bytesOf(hearth::test::inTree("textures/grille.png")));
  static const auto model [[maybe_unused]] = folder.write("crate.obj", kModel);
  static const auto materials [[maybe_unused]] = folder.write("crate.mtl", kMaterials);
  const auto file = folder.write("level.json", hearth::fuzz::asText(data, size));
  const hearth::LoadResult result = hearth::loadLevel(file);
  hearth::fuzz::expectSaid(result);
  if (result.loaded) hearth::fuzz::expectUsable(*result.loaded);
  return 0;
}
