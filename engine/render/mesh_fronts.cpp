#include "render/mesh_fronts.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "render/strip.h"

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

std::span<const std::uint32_t> MeshFronts::inStrip(std::uint32_t mesh, int strip) const {
  const Found& found = foundOf(mesh);
  const auto i = static_cast<std::size_t>(strip - frame_.columns.begin / Strip::kColumns);
  return std::span(found.byStrip).subspan(found.begins[i], found.begins[i + 1] - found.begins[i]);
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
  sortByStrip(found);
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

/// By counting; in each strip they stay in their order.
void MeshFronts::sortByStrip(Found& found) const {
  const int firstStrip = frame_.columns.begin / Strip::kColumns;
  const int strips = Strip::countIn(frame_.columns.end) - firstStrip;
  found.begins.assign(static_cast<std::size_t>(strips) + 1, 0);
  const auto visitStrips = [&](const FaceFront& front, auto&& visit) {
    const int end = Strip::countIn(front.columns.end);
    for (int strip = front.columns.begin / Strip::kColumns; strip < end; ++strip)
      visit(found.begins[static_cast<std::size_t>(strip - firstStrip)]);
  };
  for (const FaceFront& front : found.fronts)
    visitStrips(front, [](std::uint32_t& count) { ++count; });
  std::uint32_t end = 0;
  for (std::uint32_t& begin : found.begins) begin = end += begin;
  found.byStrip.resize(end);
  // From the last face on, each strip's begin moves down from its end.
  for (std::size_t i = found.fronts.size(); i-- > 0;)
    visitStrips(found.fronts[i], [&](std::uint32_t& begin) {
      found.byStrip[--begin] = static_cast<std::uint32_t>(i);
    });
}

}  // namespace hearth
