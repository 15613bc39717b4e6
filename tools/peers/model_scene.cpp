#include "peers/model_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string_view>
#include <utility>

#include "peers/level_mesh.h"
#include "peers/made_images.h"

namespace hearth {

namespace {

// A torus of squares, around its axis and around its tube. Its axis is upright.
constexpr int kAroundAxis = 316;
constexpr int kAroundTube = 158;
constexpr double kRadius = 1;
constexpr double kTubeRadius = 0.4;

/// Of 12 m x 12 m x 8 m. Neighbouring pixels of its images differ by few levels, so that a texel
/// beside the right one does not count as another picture.
constexpr std::string_view kRoom = R"({"light":1,"textures":".","sectors":{"room":{
"floor":{"z":0,"texture":"plaster 3,3"},"ceiling":{"z":8,"texture":"plaster 4,4"},
"loops":{"border":{"v":[-6,-6,6,-6,6,6,-6,6],"walls":{"texture":"plaster 2,2"}}}}},
"things":[{"mesh":"torus.obj","x":0,"y":0,"z":2,"scale":1.5,"texture":"paint"}]}
)";

std::string torusText() {
  std::string text;
  const auto out = std::back_inserter(text);
  const auto turn = [](int i, int count) { return 2 * std::numbers::pi * i / count; };
  for (int i = 0; i < kAroundAxis; ++i)
    for (int j = 0; j < kAroundTube; ++j) {
      const double tube = turn(j, kAroundTube);
      const double fromAxis = kRadius + kTubeRadius * std::cos(tube);
      const double axis = turn(i, kAroundAxis);
      fmt::format_to(out, "v {:.7f} {:.7f} {:.7f}\n", fromAxis * std::cos(axis),
                     kTubeRadius * std::sin(tube), fromAxis * std::sin(axis));
    }
  for (int i = 0; i <= kAroundAxis; ++i)
    for (int j = 0; j <= kAroundTube; ++j)
      fmt::format_to(out, "vt {:.7f} {:.7f}\n", 6.0 * i / kAroundAxis, 2.0 * j / kAroundTube);
  const auto corner = [](int i, int j) {
    return fmt::format("{}/{}", i % kAroundAxis * kAroundTube + j % kAroundTube + 1,
                       i * (kAroundTube + 1) + j + 1);
  };
  for (int i = 0; i < kAroundAxis; ++i)
    for (int j = 0; j < kAroundTube; ++j)
      fmt::format_to(out, "f {} {} {} {}\n", corner(i, j), corner(i, j + 1), corner(i + 1, j + 1),
                     corner(i + 1, j));
  return text;
}

/// Where a point of a wall, floor or ceiling is on its image, in repeats.
Vec2 imagePlace(const Scene& scene, SurfaceId id, Vec3 p) {
  const Surface& surface = scene[id];
  const Vec2 repeat = surface.mapping.repeat;
  if (isLevelFlat(surface.kind)) return {p.x / repeat.x, p.y / repeat.y};
  const Segment& wall = scene[*surface.segment];
  const double top = scene.zCeiling(scene[surface.sector]);
  return {length(p.xy() - wall.p0) / repeat.x, (top - p.z) / repeat.y};
}

MeshFace faceOf(const Scene& scene, MeshTriangle triangle) {
  MeshFace face{triangle.corners, {}, scene[triangle.surface].mapping.texture};
  if (dot(frontOf(face), triangle.normal) < 0) std::swap(face.corners[1], face.corners[2]);
  for (std::size_t i = 0; i < face.corners.size(); ++i)
    face.image[i] = imagePlace(scene, triangle.surface, face.corners[i]);
  return face;
}

tl::expected<std::filesystem::path, std::string> writeModel(const std::filesystem::path& folder) {
  return writeImages(folder).map([&] {
    std::ofstream(folder / "torus.obj") << torusText();
    std::ofstream(folder / "room.json") << kRoom;
    return folder / "room.json";
  });
}

}  // namespace

tl::expected<ModelScene, std::string> makeModelScene(PeerInputs& inputs) {
  return writeModel(inputs.folder() / "model")
      .and_then([&](const std::filesystem::path& file) { return inputs.level(file); })
      .map([](const PeerLevel* level) {
        const Camera camera{SectorId(0), {-2.6, 0, 4.2}, 0, -35, 90, 1920, 1080};
        ModelScene made{level, camera, level->loaded.level.meshFaces};
        const Scene scene = level->loaded.scene();
        for (const MeshTriangle& triangle : meshOf(scene))
          made.faces.push_back(faceOf(scene, triangle));
        return made;
      });
}

}  // namespace hearth
