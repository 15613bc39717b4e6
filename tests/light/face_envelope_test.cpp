// Which of some faces in the plane of a slice is seen, against figures and slope by slope.

#include "light/gather/face_envelope.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace hearth {
namespace {

/// From one slope to another, and so many metres away on the map at each.
FaceCut faceFrom(double fromSlope, double fromMetres, double toSlope, double toMetres,
                 std::uint32_t face) {
  return {{fromSlope, toSlope}, 1 / fromMetres, 1 / toMetres, SurfaceId(0), face};
}

struct Seen {
  double from;
  double to;
  std::uint32_t face;

  friend bool operator==(const Seen&, const Seen&) = default;
};

FaceEnvelope nearestOf(const std::vector<FaceCut>& cuts) {
  FaceEnvelope nearest;
  for (const FaceCut& cut : cuts) nearest.add(cut);
  return nearest;
}

std::vector<Seen> seenOf(const std::vector<FaceCut>& cuts) {
  std::vector<Seen> found;
  nearestOf(cuts).forEachSeen([&](SlopeRange slopes, const FaceCut& cut) {
    found.push_back({slopes.from, slopes.to, cut.face});
  });
  return found;
}

TEST(FaceEnvelope, HidesWhatIsFartherInAnyOrder) {
  const FaceCut far = faceFrom(-1, 4, 1, 4, 7);
  const FaceCut near = faceFrom(-0.5, 2, 0.25, 2, 8);
  const std::vector<Seen> seen{{-1, -0.5, 7}, {-0.5, 0.25, 8}, {0.25, 1, 7}};
  EXPECT_EQ(seenOf({far, near}), seen);
  EXPECT_EQ(seenOf({near, far}), seen);
}

TEST(FaceEnvelope, HasFartherFacesBesideNearerOnes) {
  const std::vector<Seen> seen{{-2, -1, 8}, {-1, 1, 7}, {1, 2, 8}};
  EXPECT_EQ(seenOf({faceFrom(-1, 2, 1, 2, 7), faceFrom(-2, 4, 2, 4, 8)}), seen);
}

/// One is 2 m away, the other 4 m at slope 0 and 4/3 m at slope 1: at slope 1/2 both are at 2 m.
TEST(FaceEnvelope, HasPartsOfFacesThatCross) {
  const FaceCut upright = faceFrom(0, 2, 1, 2, 3);
  const FaceCut leaning = faceFrom(0, 4, 1, 4.0 / 3, 5);
  for (const std::vector<FaceCut>& cuts : {std::vector{upright, leaning}, {leaning, upright}}) {
    const std::vector<Seen> seen = seenOf(cuts);
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[0].face, 3U);
    EXPECT_DOUBLE_EQ(seen[0].from, 0);
    EXPECT_DOUBLE_EQ(seen[0].to, 0.5);
    EXPECT_EQ(seen[1].face, 5U);
    EXPECT_DOUBLE_EQ(seen[1].from, 0.5);
    EXPECT_DOUBLE_EQ(seen[1].to, 1);
  }
}

TEST(FaceEnvelope, HasOneOfTwoFacesInOnePlace) {
  const std::vector<Seen> seen{{-1, 1, 1}};
  EXPECT_EQ(seenOf({faceFrom(-1, 3, 1, 3, 1), faceFrom(-1, 3, 1, 3, 2)}), seen);
}

TEST(FaceEnvelope, HasBothFacesThatShareAnEdge) {
  const std::vector<Seen> seen{{-1, 0, 1}, {0, 1, 2}};
  EXPECT_EQ(seenOf({faceFrom(-1, 3, 0, 2, 1), faceFrom(0, 2, 1, 3, 2)}), seen);
}

TEST(FaceEnvelope, HidesRangesThatLieBehindAllOfIt) {
  const FaceEnvelope nearest = nearestOf({faceFrom(-1, 3, 0, 2, 1), faceFrom(0, 2, 1, 3, 2)});
  EXPECT_TRUE(nearest.hide({-1, 1}, 1 / 3.5));
  EXPECT_TRUE(nearest.hide({-0.5, 0.5}, 1 / 2.6));
  EXPECT_FALSE(nearest.hide({-1, 1}, 1 / 2.5));     // in front of their ends
  EXPECT_FALSE(nearest.hide({-1, 1.01}, 1 / 3.5));  // beyond them
  EXPECT_FALSE(FaceEnvelope().hide({-1, 1}, 0));
}

/// Of random faces, at random slopes: the nearest of those that are there.
TEST(FaceEnvelope, HasTheNearestFaceAtEachSlope) {
  std::mt19937_64 random(5);
  const auto between = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  for (int round = 0; round < 2000; ++round) {
    std::vector<FaceCut> cuts;
    for (std::uint32_t face = 0; face < 12; ++face) {
      const double from = between(-2, 2);
      cuts.push_back(faceFrom(from, between(1, 5), from + between(0.01, 2), between(1, 5), face));
    }
    const std::vector<Seen> seen = seenOf(cuts);
    for (int k = 0; k < 50; ++k) {
      const double slope = between(-2, 4);
      const FaceCut* nearest = nullptr;
      for (const FaceCut& cut : cuts)
        if (slope > cut.slopes.from && slope < cut.slopes.to &&
            (!nearest || cut.nearAt(slope) > nearest->nearAt(slope)))
          nearest = &cut;
      const auto there = std::ranges::find_if(
          seen, [&](const Seen& part) { return slope > part.from && slope < part.to; });
      ASSERT_EQ(there != seen.end(), nearest != nullptr) << round << " at " << slope;
      if (nearest) {
        EXPECT_EQ(there->face, nearest->face) << round << " at " << slope;
      }
    }
  }
}

}  // namespace
}  // namespace hearth
