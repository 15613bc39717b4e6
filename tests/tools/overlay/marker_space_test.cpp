// Pixels of the view and of the map, and the points of the world that are dragged there.

#include "hearth/overlay/marker_space.h"

#include <gtest/gtest.h>

namespace hearth {
namespace {

/// 320 pixels to the metre at a depth of 1 m, along +x.
Camera camera() {
  Camera camera{SectorId(0), {1, 2, 1.5}, 0, 0, 90, 640, 400};
  return camera;
}

void expectNear(Vec3 a, Vec3 b) {
  EXPECT_LT(length(a - b), 1e-9) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(MarkerSpaceTest, HasThePixelsOfTheView) {
  const MarkerSpace view(camera());
  const auto pixel = view.pixelOf({3, 2.5, 2});
  ASSERT_TRUE(pixel);
  EXPECT_LT(length(*pixel - Vec2{320 + 80, 200 - 80}), 1e-9);
  EXPECT_FALSE(view.pixelOf({0.5, 2, 1.5})) << "behind the eye";
  EXPECT_FALSE(view.isMap());
}

TEST(MarkerSpaceTest, DragsInAPlaneThatFacesTheCamera) {
  const MarkerSpace view(camera());
  expectNear(view.dragged({3, 2, 1.5}, {320 + 160, 200 - 16}, false), {3, 3, 1.6});
  expectNear(view.dragged({3, 2, 1.5}, {320 + 160, 200 - 16}, true), {3, 2, 1.6});
  Camera turned = camera();
  turned.angle = 90;
  turned.pitch = 30;
  const MarkerSpace other(turned);
  for (const Vec2 pixel : {Vec2{10, 20}, Vec2{600, 399}}) {
    const Vec3 at = other.dragged({1.5, 7, 0.25}, pixel, false);
    EXPECT_NEAR(at.y, 7, 1e-9);
    EXPECT_LT(length(*other.pixelOf(at) - pixel), 0.1) << "but for half a millimetre";
  }
}

TEST(MarkerSpaceTest, DragsOnTheMapAtTheSameHeight) {
  const MarkerSpace map(MapScale{{320, 200}, {1, 2}, 10});
  EXPECT_EQ(map.pixelOf({3, 1, 99}), (Vec2{340, 190}));
  expectNear(map.dragged({3, 1, 99}, {300, 205}, false), {-1, 2.5, 99});
  EXPECT_TRUE(map.isMap());
}

TEST(MarkerSpaceTest, DragsByWholeMillimetresAndLeavesWhatStays) {
  const MarkerSpace map(MapScale{{320, 200}, {0, 0}, 3});
  const Vec3 from{1.23456, 2.34567, 3.45678};
  const Vec3 at = map.dragged(from, *map.pixelOf(from) + Vec2{1, 0}, false);
  EXPECT_EQ(at.x, 1.568);
  EXPECT_EQ(at.y, from.y);
  EXPECT_EQ(at.z, from.z);
}

}  // namespace
}  // namespace hearth
