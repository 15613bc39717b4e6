// Bytes of a fuzzer as an OBJ file and, behind a line "%%", the MTL file beside it: both are
// refused with messages at their lines, or are triangles with areas within the limit.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "load/model/read_model.h"
#include "math/check.h"
#include "scratch_folder.h"
#include "support/memory_files.h"

namespace hearth {
namespace {

constexpr std::string_view kMaterialsBegin = "\n%%\n";
constexpr double kFarthest = 1e9;  // metres
constexpr std::size_t kMaxFaces = 1000;
/// Of a file: 20 errors, that there are more, and two warnings of what is left out. A file is read
/// again under each name that it can be given.
constexpr std::size_t kMaxMistakes = 65 * 23;

test::MemoryFiles filesOf(std::string_view bytes) {
  const std::size_t middle = std::min(bytes.find(kMaterialsBegin), bytes.size());
  const std::size_t end = std::min(middle + kMaterialsBegin.size(), bytes.size());
  test::MemoryFiles files;
  files.add("models/a.obj", std::string(bytes.substr(0, middle)));
  files.add("models/a.mtl", std::string(bytes.substr(end)));
  return files;
}

void expectTold(const ModelRead& read) {
  CHECK(read.model.has_value() != std::ranges::any_of(read.mistakes, &ModelMistake::isError));
  CHECK(read.mistakes.size() <= kMaxMistakes, read.mistakes.size());
  for (const ModelMistake& mistake : read.mistakes)
    CHECK(!mistake.message.empty() && !mistake.advice.empty() && mistake.line >= 0 &&
              (mistake.file.filename() == "a.obj" || mistake.file.filename() == "a.mtl"),
          mistake.message);
}

void expectTriangles(const Model& model) {
  CHECK(!model.faces.empty() && model.faces.size() <= kMaxFaces, model.faces.size());
  for (const ModelFace& face : model.faces) {
    const auto& [a, b, c] = face.corners;
    CHECK(length(cross(b - a, c - a)) > 0, face.line);
    for (const Vec3 corner : face.corners)
      CHECK(std::max({std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)}) <= kFarthest,
            face.line);
    CHECK(!face.material || *face.material < model.materials.size(), face.line);
    CHECK(face.line >= 1);
  }
  for (const ModelMaterial& material : model.materials)
    CHECK(!material.image || !material.image->empty());
}

}  // namespace
}  // namespace hearth

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const hearth::test::MemoryFiles files = hearth::filesOf(hearth::fuzz::asText(data, size));
  hearth::LoadLimits limits;
  limits.meshFaces = hearth::kMaxFaces;
  const hearth::ModelRead read = hearth::readModel("models/a.obj", limits, files);
  hearth::expectTold(read);
  if (read.model) hearth::expectTriangles(*read.model);
  return 0;
}
