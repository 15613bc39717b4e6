// Which of some faces in the plane of a slice is seen, against figures.

#include "light/gather/face_cuts.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace hearth {
namespace {

/// From one slope to another, and so many metres away on the map at each.
FaceCut faceFrom(double fromSlope, double fromMetres, double toSlope, double toMetres,
                 std::optional<AreaLights::Place> light = std::nullopt) {
  return {{fromSlope, toSlope}, 1 / fromMetres, 1 / toMetres, light};
}

struct Shining {
  double from;
  double to;
  AreaLights::Place light;

  friend bool operator==(const Shining&, const Shining&) = default;
};

std::vector<Shining> shiningOf(const std::vector<FaceCut>& cuts) {
  std::vector<Shining> found;
  BlockedSlopes hidden;
  forEachShining(cuts, hidden, [&](SlopeRange slopes, AreaLights::Place light) {
    found.push_back({slopes.from, slopes.to, light});
  });
  return found;
}

TEST(FaceCuts, AFaceShinesWhereNoNearerOneHidesIt) {
  const FaceCut far = faceFrom(-1, 4, 1, 4, 7);
  const FaceCut near = faceFrom(-0.5, 2, 0.25, 2);
  const std::vector<Shining> seen{{-1, -0.5, 7}, {0.25, 1, 7}};
  EXPECT_EQ(shiningOf({far, near}), seen);
  EXPECT_EQ(shiningOf({near, far}), seen);
}

TEST(FaceCuts, AFartherFaceHidesNothing) {
  const std::vector<Shining> seen{{-1, 1, 7}};
  EXPECT_EQ(shiningOf({faceFrom(-1, 2, 1, 2, 7), faceFrom(-2, 4, 2, 4)}), seen);
}

/// One is 2 m away, the other 4 m at slope 0 and 4/3 m at slope 1: at slope 1/2 both are at 2 m.
TEST(FaceCuts, FacesThatCrossHideEachOtherInPart) {
  const FaceCut upright = faceFrom(0, 2, 1, 2, 3);
  const FaceCut leaning = faceFrom(0, 4, 1, 4.0 / 3, 5);
  const std::vector<Shining> seen = shiningOf({upright, leaning});
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].light, 3U);
  EXPECT_DOUBLE_EQ(seen[0].from, 0);
  EXPECT_DOUBLE_EQ(seen[0].to, 0.5);
  EXPECT_EQ(seen[1].light, 5U);
  EXPECT_DOUBLE_EQ(seen[1].from, 0.5);
  EXPECT_DOUBLE_EQ(seen[1].to, 1);
}

TEST(FaceCuts, OfTwoFacesInOnePlaceOneShines) {
  const std::vector<Shining> seen{{-1, 1, 1}};
  EXPECT_EQ(shiningOf({faceFrom(-1, 3, 1, 3, 1), faceFrom(-1, 3, 1, 3, 2)}), seen);
}

TEST(FaceCuts, FacesThatShareAnEdgeBothShine) {
  const std::vector<Shining> seen{{-1, 0, 1}, {0, 1, 2}};
  EXPECT_EQ(shiningOf({faceFrom(-1, 3, 0, 2, 1), faceFrom(0, 2, 1, 3, 2)}), seen);
}

}  // namespace
}  // namespace hearth
