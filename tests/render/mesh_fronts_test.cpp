// Which faces of a mesh are looked at: those behind the windows through which it is seen.

#include "render/mesh_fronts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "things_in_halls.h"

namespace hearth {
namespace {

using test::kSize;

constexpr PictureRect kPicture{{0, kSize}, 0, kSize};
constexpr int kFacesAcross = 32;

/// A wall of faces 1 m before the eye that fills the picture: in each 2x2 pixels two of them.
class WallOfFaces : public testing::Test {
 protected:
  WallOfFaces() {
    for (int i = 0; i < kFacesAcross; ++i)
      for (int k = 0; k < kFacesAcross; ++k) {
        const Vec3 corner = {1, 2.0 * i / kFacesAcross - 1, 2.0 * k / kFacesAcross - 1};
        const Vec3 right = {0, 2.0 / kFacesAcross, 0};
        const Vec3 up = {0, 0, 2.0 / kFacesAcross};
        level_.meshFaces.push_back(
            {{corner, corner + right, corner + right + up}, {}, TextureId(0)});
        level_.meshFaces.push_back({{corner, corner + right + up, corner + up}, {}, TextureId(0)});
      }
    Mesh mesh;
    mesh.isTwoSided = true;
    mesh.faceCount = static_cast<std::uint32_t>(level_.meshFaces.size());
    level_.meshes = {mesh};
    level_.faceTrees.emplace_back(level_.meshFaces);
    fronts_.begin(level_, kPicture);
  }

  void find(const PictureRect& window) { fronts_.find({level_, {}}, projection_, 0, window); }
  std::size_t found() const { return fronts_.frontsOf(0).size(); }

  Level level_;
  Projection projection_{{SectorId(0), {}, 0, 0, 90, kSize, kSize}, {}};
  MeshFronts fronts_;
};

TEST_F(WallOfFaces, isLookedAtWhereAWindowShowsIt) {
  const PictureRect window{{16, 24}, 40, 44};
  find(window);
  // 4 by 2 squares show. The tree holds several faces in each of its leaves.
  EXPECT_GE(found(), 2 * 4 * 2);
  EXPECT_LT(found(), level_.meshFaces.size() / 8);
}

TEST_F(WallOfFaces, isCompleteBehindAWindow) {
  const PictureRect window{{16, 24}, 40, 44};
  find(window);
  for (int column = window.columns.begin; column < window.columns.end; ++column)
    for (int row = window.rowBegin; row < window.rowEnd; ++row) {
      const Vec3 ray = {1, projection_.slantOf(column + 0.5), projection_.raySlopeAt(row + 0.5)};
      const auto isMet = [&](std::uint32_t i) {
        return std::ranges::all_of(fronts_.frontsOf(0)[i].edges,
                                   [&](Vec3 edge) { return dot(edge, ray) >= 0; });
      };
      EXPECT_TRUE(std::ranges::any_of(fronts_.inStrip(0, column / Strip::kColumns), isMet))
          << column << ' ' << row;
    }
}

TEST_F(WallOfFaces, isFoundOnceMoreForASecondWindowAndNotForAThird) {
  find({{0, 8}, 0, 8});
  const std::span<const FaceFront> first = fronts_.frontsOf(0);
  const Vec3 edge = first.front().edges[0];
  find({{0, 4}, 2, 6});
  EXPECT_EQ(fronts_.frontsOf(0).data(), first.data()) << "a part of the same window";
  find({{40, 48}, 0, 8});
  const std::span<const FaceFront> second = fronts_.frontsOf(0);
  EXPECT_EQ(second.size(), level_.meshFaces.size()) << "all that the picture can show";
  find({{0, kSize}, 20, 30});
  EXPECT_EQ(fronts_.frontsOf(0).data(), second.data());
  EXPECT_EQ(first.front().edges[0], edge) << "spans look at it until the next frame";
}

}  // namespace
}  // namespace hearth
