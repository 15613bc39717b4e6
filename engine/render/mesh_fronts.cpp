#include "render/mesh_fronts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace hearth {

namespace {

struct Breadth {
  ColumnRange columns;  ///< some, whose centres a face may cover
  bool isNarrow;        ///< in all columns: threads may divide these as they like
};

/// Of a face, in some columns.
Breadth breadthOf(const Projection& projection, const FaceCorners& corners, ColumnRange columns) {
  /// Pixels: more than rounding.
  constexpr double kSlack = 0x1p-20;
  constexpr double kNarrow = 32;
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  double left = kEndless;
  double right = -kEndless;
  std::size_t ahead = 0;
  for (const Vec3 corner : corners) {
    if (!(corner.x > 0)) continue;
    ++ahead;
    const double column = projection.columnOf({corner.x, corner.y});
    left = std::min(left, column);
    right = std::max(right, column);
  }
  if (ahead == 0) return {};
  if (ahead < corners.size()) return {columns, false};
  const bool isNarrow = right - left <= kNarrow;
  left = std::max<double>(left - 0.5 - kSlack, columns.begin);
  right = std::min<double>(right - 0.5 + kSlack, columns.end - 1);
  if (left > right) return {};
  return {{roundedUp(left), static_cast<int>(right) + 1}, isNarrow};
}

}  // namespace

void MeshFronts::begin(const Level& level, const PictureRect& frame) {
  frame_ = frame;
  placeOf_.assign(level.meshes.size(), kNone);
  count_ = 0;
}

void MeshFronts::find(const Scene& scene, const Projection& projection, std::uint32_t index,
                      const PictureRect& part) {
  const bool isKnown = placeOf_[index] != kNone;
  if (isKnown && foundOf(index).part.holds(part)) return;
  placeOf_[index] = count_++;
  if (count_ > found_.size()) found_.emplace_back();
  Found& found = found_[placeOf_[index]];
  // The second time all that the frame can show: a mesh behind many windows is found twice at most.
  found.part = isKnown ? frame_ : part;
  found.fronts.clear();
  const Mesh& mesh = scene.level().meshes[index];
  visitInFrustum(
      Frustum(projection, found.part), scene.level().faceTrees[index], scene.level().facesOf(mesh),
      [&](const MeshFace& face) { add(mesh, face, projection, found.part.columns, found.fronts); });
  found.byStrip.sort(found.fronts.size(), [&](std::size_t i) { return found.fronts[i].columns; });
}

std::size_t MeshFronts::count() const {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < count_; ++i) count += found_[i].fronts.size();
  return count;
}

/// In their order.
template <typename Visit>
void MeshFronts::visitInFrustum(const Frustum& frustum, const FaceTree& tree,
                                std::span<const MeshFace> faces, Visit&& visit) {
  if (!frustum.mayShow(tree.box())) return;
  if (frustum.holds(tree.box())) {
    std::ranges::for_each(faces, visit);
    return;
  }
  isInFrustum_.resize(std::max(isInFrustum_.size(), faces.size()));
  tree.anyFace([&](const Box3& box) { return frustum.mayShow(box); },
               [this](std::uint32_t face) {
                 isInFrustum_[face] = 1;
                 return false;
               });
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (std::exchange(isInFrustum_[i], std::uint8_t{0}) != 0) visit(faces[i]);
}

void MeshFronts::add(const Mesh& mesh, const MeshFace& face, const Projection& projection,
                     ColumnRange within, std::vector<FaceFront>& fronts) {
  const FaceCorners corners = cornersBefore(projection, face);
  const auto& [a, b, c] = corners;
  const Vec3 out = cross(c - a, b - a);
  const double towardsEye = -dot(out, a);
  if (towardsEye == 0 || (towardsEye < 0 && !mesh.isTwoSided)) return;
  const auto [columns, isNarrow] = breadthOf(projection, corners, within);
  if (columns.begin >= columns.end) return;
  const double side = towardsEye > 0 ? 1 : -1;
  const auto& [imageA, imageB, imageC] = face.image;
  fronts.push_back({columns,
                    {side * cross(b, c), side * cross(c, a), side * cross(a, b)},
                    (-1 / towardsEye) * out,
                    mesh.thing,
                    face.texture,
                    gradientOf(corners, {}, {imageA.x, imageB.x, imageC.x}),
                    gradientOf(corners, {}, {imageA.y, imageB.y, imageC.y}),
                    &face,
                    mesh.surface,
                    isNarrow});
}

}  // namespace hearth
