#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "level/mesh.h"

namespace hearth {

/// A convex polygon as a fan of faces, from its corners counter-clockwise as seen from its front.
/// The image of a rectangle lies on it once if its corners begin at the lower left one.
inline std::vector<MeshFace> polygonOf(const std::vector<Vec3>& corners, TextureId texture) {
  constexpr std::array<Vec2, 4> kImage{Vec2{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  std::vector<MeshFace> faces;
  for (std::size_t i = 2; i < corners.size(); ++i)
    faces.push_back({{corners[0], corners[i - 1], corners[i]},
                     {kImage[0], kImage[(i - 1) % 4], kImage[i % 4]},
                     texture});
  return faces;
}

/// A rectangle across the x axis, seen by one who looks along +x.
inline std::vector<MeshFace> boardAcrossX(double x, Vec2 min, Vec2 max, TextureId texture) {
  return polygonOf({{x, min.x, min.y}, {x, max.x, min.y}, {x, max.x, max.y}, {x, min.x, max.y}},
                   texture);
}

/// The same faces, seen from their other side.
inline std::vector<MeshFace> turnedOver(std::vector<MeshFace> faces) {
  for (MeshFace& face : faces) {
    std::swap(face.corners[1], face.corners[2]);
    std::swap(face.image[1], face.image[2]);
  }
  return faces;
}

inline std::vector<MeshFace> joined(std::vector<MeshFace> a, const std::vector<MeshFace>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A box whose faces are seen from outside.
inline std::vector<MeshFace> boxOf(Vec3 min, Vec3 max, TextureId texture) {
  const auto corner = [&](int i) {  // its bits say where it is at the far end: of x, y, z
    return Vec3{i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z};
  };
  constexpr std::array<std::array<int, 4>, 6> kSides{{{0, 2, 6, 4},    // towards -x
                                                      {3, 1, 5, 7},    // +x
                                                      {1, 0, 4, 5},    // -y
                                                      {2, 3, 7, 6},    // +y
                                                      {0, 1, 3, 2},    // -z
                                                      {4, 6, 7, 5}}};  // +z
  std::vector<MeshFace> faces;
  for (const auto& side : kSides)
    faces = joined(
        std::move(faces),
        polygonOf({corner(side[0]), corner(side[1]), corner(side[2]), corner(side[3])}, texture));
  return faces;
}

}  // namespace hearth
