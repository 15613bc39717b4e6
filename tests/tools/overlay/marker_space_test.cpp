// Pixels of the view and of the map, and the points of the world that are dragged there.

#include "viewer/overlay/marker_space.h"

#include <gtest/gtest.h>

#include <cmath>

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
  expectNear(view.dragged({3, 2, 1.5}, {320 + 160, 200 - 16}), {3, 3, 1.6});
  expectNear(view.dragged({3, 2, 1.5}, {320 + 160, 200 - 16}, Axis::Z), {3, 2, 1.6});
  Camera turned = camera();
  turned.angle = 90;
  turned.pitch = 30;
  const MarkerSpace other(turned);
  for (const Vec2 pixel : {Vec2{10, 20}, Vec2{600, 399}}) {
    const Vec3 at = other.dragged({1.5, 7, 0.25}, pixel);
    EXPECT_NEAR(at.y, 7, 1e-9);
    EXPECT_LT(length(*other.pixelOf(at) - pixel), 0.1) << "apart from half a millimetre";
  }
}

TEST(MarkerSpaceTest, DragsAlongAnAxisAcrossTheViewAsFarAsThePointer) {
  const MarkerSpace view(camera());
  expectNear(view.dragged({3, 2, 1.5}, {320 + 160, 200 - 99}, Axis::Y), {3, 3, 1.5});
  Camera slanted = camera();
  slanted.angle = 60;
  const MarkerSpace other(slanted);
  const Vec3 from{3, 4, 1};
  const Vec2 begin = *other.pixelOf(from);
  for (const double x : {2.8, 3.2}) {
    const Vec3 to = other.dragged(from, *other.pixelOf({x, 4, 1}), Axis::X);
    EXPECT_NEAR(to.x, x, 0.05) << "apart from what perspective adds";
    EXPECT_EQ(to.y, 4);
    EXPECT_EQ(to.z, 1);
  }
  EXPECT_EQ(other.dragged(from, begin, Axis::X), from);
}

TEST(MarkerSpaceTest, DragsAlongAnAxisThatRunsAwayWithoutLeaps) {
  const MarkerSpace view(camera());
  const Vec3 from{5, 2.25, 1.75};  // whose pixels hardly move as x grows
  for (int pixels = -60; pixels <= 60; ++pixels) {
    const Vec2 pixel = *view.pixelOf(from) + Vec2{pixels * 1.0, pixels * 0.5};
    EXPECT_LT(length(view.dragged(from, pixel, Axis::X) - from), std::abs(pixels) * 0.06 + 0.001);
  }
  const Vec3 middle{5, 2, 1.5};  // whose pixel does not move
  EXPECT_EQ(view.dragged(middle, {400, 100}, Axis::X), middle);
}

TEST(MarkerSpaceTest, HasTheDirectionsOfTheView) {
  const MarkerSpace view(camera());
  const Vec2 pixel{100, 60};
  const Vec3 direction = view.directionAt(pixel);
  const auto back = view.pixelTowards(1 / length(direction) * direction);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->x, pixel.x, 1e-6);
  EXPECT_NEAR(back->y, pixel.y, 1e-6);
  EXPECT_FALSE(view.pixelTowards(-1 * direction)) << "behind the eye";
  EXPECT_FALSE(MarkerSpace(MapScale{{320, 200}, {1, 2}, 10}).pixelTowards(direction));
}

TEST(MarkerSpaceTest, DragsOnTheMapAlongAnAxis) {
  const MarkerSpace map(MapScale{{320, 200}, {1, 2}, 10});
  expectNear(map.dragged({3, 1, 99}, {300, 205}, Axis::X), {-1, 1, 99});
  expectNear(map.dragged({3, 1, 99}, {300, 205}, Axis::Y), {3, 2.5, 99});
  EXPECT_EQ(map.dragged({3, 1, 99}, {300, 205}, Axis::Z), (Vec3{3, 1, 99}));
}

TEST(MarkerSpaceTest, DragsOnTheMapAtTheSameHeight) {
  const MarkerSpace map(MapScale{{320, 200}, {1, 2}, 10});
  EXPECT_EQ(map.pixelOf({3, 1, 99}), (Vec2{340, 190}));
  expectNear(map.dragged({3, 1, 99}, {300, 205}), {-1, 2.5, 99});
  EXPECT_TRUE(map.isMap());
}

TEST(MarkerSpaceTest, DragsByWholeMillimetresAndLeavesWhatStays) {
  const MarkerSpace map(MapScale{{320, 200}, {0, 0}, 3});
  const Vec3 from{1.23456, 2.34567, 3.45678};
  const Vec3 at = map.dragged(from, *map.pixelOf(from) + Vec2{1, 0});
  EXPECT_EQ(at.x, 1.568);
  EXPECT_EQ(at.y, from.y);
  EXPECT_EQ(at.z, from.z);
}

}  // namespace
}  // namespace hearth
