// That light does not depend on the processor: it is found with each instruction set that this one
// has, and as the formulas say that these are compiled from.

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "level/light_source.h"
#include "light/bakery.h"
#include "light/baking/brightness_kernels.h"
#include "light/baking/light_sum.h"
#include "light/beam_tree/beam_kernels.h"
#include "load/load.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

/// More than fill registers of any size, and some that are left.
constexpr std::size_t kCount = 43;

struct Samples {
  std::vector<double> x, y, z;

  explicit Samples(std::mt19937& random) {
    std::uniform_real_distribution<double> metres(-30, 30);
    for (std::size_t i = 0; i < kCount + SampleArrays::kMaxLanes; ++i)
      x.push_back(metres(random)), y.push_back(metres(random)), z.push_back(metres(random));
  }

  SampleArrays arrays() const { return {x.data(), y.data(), z.data()}; }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// A wall of 10 m across the x axis, its front towards rising or falling x.
Segment wallAt(double x, bool facesOn) {
  Segment wall;
  wall.p0 = {x, facesOn ? 5.0 : -5.0};
  wall.p1 = {x, -wall.p0.y};
  wall.length = 10;
  return wall;
}

class LightKernelsTest : public testing::Test {
 protected:
  ~LightKernelsTest() override { use(0); }

  /// One set alone; with 0, the best one again.
  static void use(std::int64_t set) {
    hwy::SetSupportedTargetsForTest(set);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }

  template <typename Check>
  static void forEachInstructionSet(Check&& check) {
    for (const std::int64_t set : hwy::SupportedAndGeneratedTargets()) {
      SCOPED_TRACE(hwy::TargetName(set));
      use(set);
      check();
    }
  }

  std::vector<double> between(double low, double high) {
    std::uniform_real_distribution<double> number(low, high);
    std::vector<double> numbers(kCount);
    for (double& each : numbers) each = number(random_);
    return numbers;
  }

  std::mt19937 random_{5};
  Samples samples_{random_};
  Vec3 light_{1.3, -2.7, 0.4};
  Vec3 normal_{0.6, 0, 0.8};
};

TEST_F(LightKernelsTest, bakeTheSameLight) {
  for (const char* name : {"tutorial", "gaol"}) {
    const LoadedLevel loaded =
        loadLevel(test::inTree("levels/" + std::string(name) + ".json")).loaded.value();
    BakeSettings coarse = loaded.level.bake;
    coarse.texel = 0.5;
    const BakedLight expected = bake(loaded.scene(), coarse, 2);
    forEachInstructionSet([&] {
      const BakedLight found = bake(loaded.scene(), coarse, 2);
      EXPECT_EQ(found.stats.rays, expected.stats.rays);
      ASSERT_EQ(found.lightmaps.size(), expected.lightmaps.size());
      for (std::size_t i = 0; i < found.lightmaps.size(); ++i) {
        ASSERT_EQ(found.lightmaps[i].has_value(), expected.lightmaps[i].has_value()) << i;
        if (found.lightmaps[i]) {
          ASSERT_EQ(found.lightmaps[i]->levels, expected.lightmaps[i]->levels) << i;
        }
      }
    });
  }
}

TEST_F(LightKernelsTest, findLevelsAsALightSourceHasThem) {
  LightSource source;
  source.intensity = 181.7;
  source.falloff = 0.37;
  forEachInstructionSet([&] {
    const BrightnessKernels& kernels = brightnessKernels();
    std::vector<double> distances(kCount);
    std::vector<double> levels(kCount);
    kernels.findDistances(samples_.arrays(), kCount, light_, distances.data());
    kernels.findLevels(distances.data(), kCount, source.intensity, source.falloff, levels.data());
    for (std::size_t i = 0; i < kCount; ++i) {
      EXPECT_EQ(distances[i], length(light_ - samples_.at(i)));
      EXPECT_EQ(levels[i], source.brightnessAt(distances[i]));
    }
  });
}

TEST_F(LightKernelsTest, applySpotsAsALightSourceHasThem) {
  LightSource source;
  source.position = light_;
  source.intensity = 181.7;
  for (const Spot& spot : {Spot(30, -40, 10, 50), Spot(210, 70, 0, 180), Spot(0, 0, 180, 180),
                           Spot(90, -90, 60, 60), Spot(90, 90, 0, 0)}) {
    source.spot = spot;
    forEachInstructionSet([&] {
      const BrightnessKernels& kernels = brightnessKernels();
      std::vector<double> distances(kCount);
      std::vector<double> levels(kCount, source.intensity);
      kernels.findDistances(samples_.arrays(), kCount, light_, distances.data());
      kernels.applySpot(samples_.arrays(), distances.data(), kCount, light_, spot, levels.data());
      for (std::size_t i = 0; i < kCount; ++i)
        EXPECT_EQ(levels[i], source.brightnessAt(samples_.at(i))) << i;
    });
  }
}

TEST_F(LightKernelsTest, findLevelsOnACurveAsALightSourceHasThem) {
  std::vector<double> distances = between(0, 12);
  // At a point of the curve, and where it jumps.
  distances[0] = 2.5;
  distances[1] = 7;
  for (const std::vector<CurvePoint>& curve :
       {std::vector<CurvePoint>{{3, 90}}, std::vector<CurvePoint>{{0, 255}, {9.3, 0}},
        std::vector<CurvePoint>{{1, 200}, {2.5, 31}, {7, 60}, {7, 20}, {11, 3}}}) {
    LightSource source;
    source.curve = curve;
    forEachInstructionSet([&] {
      std::vector<double> levels(kCount);
      brightnessKernels().findLevelsOnCurve(distances.data(), kCount, curve, levels.data());
      for (std::size_t i = 0; i < kCount; ++i)
        EXPECT_EQ(levels[i], source.brightnessAt(distances[i])) << distances[i];
    });
  }
}

TEST_F(LightKernelsTest, multiplyByTheCosineOfWhatFacesTheLight) {
  const std::vector<double> levels = between(0, 300);
  forEachInstructionSet([&] {
    const BrightnessKernels& kernels = brightnessKernels();
    std::vector<double> distances(kCount);
    std::vector<double> found = levels;
    kernels.findDistances(samples_.arrays(), kCount, light_, distances.data());
    kernels.applyCosine(samples_.arrays(), distances.data(), kCount, light_, normal_, found.data());
    for (std::size_t i = 0; i < kCount; ++i) {
      const double inFront = dot(light_ - samples_.at(i), normal_);
      EXPECT_EQ(found[i], levels[i] * std::max(0.0, inFront / distances[i]));
    }
    EXPECT_GT(std::ranges::count(found, 0.0), 5);
  });
}

TEST_F(LightKernelsTest, leaveWhatIsSeenWithinReach) {
  const std::vector<double> distances = between(0, 20);
  const std::vector<double> levels = between(0, 300);
  std::vector<double> seen = between(0, 1);
  for (std::size_t i = 0; i < kCount; i += 3) seen[i] = i % 2 == 0 ? 0 : 1;
  forEachInstructionSet([&] {
    const BrightnessKernels& kernels = brightnessKernels();
    std::vector<double> found = levels;
    kernels.applySeen(seen.data(), distances.data(), kCount, 12.5, found.data());
    for (std::size_t i = 0; i < kCount; ++i)
      EXPECT_EQ(found[i], distances[i] < 12.5 ? seen[i] * levels[i] : 0);
  });
}

TEST_F(LightKernelsTest, addToSumsAsLightSumDoes) {
  std::vector<double> levels = between(0, 300);
  levels[3] = 1e300;
  levels[4] = 0.5 / LightSum::kUnit;
  const double fraction = 77 / 255.0;
  forEachInstructionSet([&] {
    const BrightnessKernels& kernels = brightnessKernels();
    std::vector<double> sums(kCount, 0.0);
    std::vector<LightSum> expected(kCount);
    for (int round = 0; round < 3; ++round) {
      kernels.addToSums(levels.data(), kCount, fraction, sums.data());
      for (std::size_t i = 0; i < kCount; ++i) {
        expected[i].add(levels[i] * fraction);
        EXPECT_EQ(sums[i], expected[i].units());
      }
    }
    EXPECT_EQ(sums[3], LightSum::kFull);
  });
}

TEST_F(LightKernelsTest, findMeansAsLightSumDoes) {
  std::vector<double> sums = between(0, 300 * LightSum::kUnit);
  for (double& sum : sums) sum = std::floor(sum);
  sums[3] = LightSum::kFull;
  sums[4] = LightSum::kUnit / 2;
  sums[5] = LightSum::kUnit / 2 - 1;
  forEachInstructionSet([&] {
    for (const int samples : {1, 3, 4, 9}) {
      std::vector<double> means(kCount);
      brightnessKernels().findMeans(sums.data(), kCount, samples, means.data());
      for (std::size_t i = 0; i < kCount; ++i)
        EXPECT_EQ(means[i], LightSum(sums[i]).mean(samples)) << samples;
    }
  });
}

TEST_F(LightKernelsTest, findBeamsBetweenWhoseSidesSomethingMayLie) {
  CornerOffsets corners;
  for (const std::size_t count : {1, 3, 8}) {
    corners.count = count;
    for (std::size_t i = 0; i < 8; ++i) {
      const std::size_t k = i < count ? i : 0;
      corners.x[i] = samples_.x[k] / 30;
      corners.y[i] = samples_.y[k] / 30 + 2;
    }
    const std::vector<double> beginX = between(-1, 1);
    const std::vector<double> beginY = between(-1, 1);
    const std::vector<double> endX = between(-1, 1);
    const std::vector<double> endY = between(-1, 1);
    const double margin = 0.25;
    std::vector<SpanningBeam> expected;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const auto cornersBehind = [&](double x, double y, double offset) {
        std::size_t behind = 0;
        for (std::size_t k = 0; k < count; ++k)
          if (!(corners.x[k] * x + corners.y[k] * y > offset)) ++behind;
        return behind;
      };
      const auto isBehind = [&](double x, double y) {
        return cornersBehind(x, y, -margin) == count;
      };
      if (isBehind(beginX[i], beginY[i]) || isBehind(endX[i], endY[i])) continue;
      expected.push_back({i, (cornersBehind(beginX[i], beginY[i], margin) > 0 ? 1U : 0U) |
                                 (cornersBehind(endX[i], endY[i], margin) > 0 ? 2U : 0U)});
    }
    EXPECT_GT(expected.size(), 5U);
    EXPECT_LT(expected.size(), kCount - 5);
    forEachInstructionSet([&] {
      const BeamKernels& kernels = beamKernels();
      std::vector<SpanningBeam> found(kCount);
      found.resize(kernels.findSpanning(corners,
                                        {beginX.data(), beginY.data(), endX.data(), endY.data()},
                                        kCount, margin, found.data()));
      EXPECT_EQ(found, expected);
    });
  }
}

/// A bit for each bound that has a corner behind it, or nearer than its slack: begin and end of the
/// beam, its planes and its walls.
TEST_F(LightKernelsTest, findBoundsThatPartABox) {
  CornerOffsets corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners.x[i] = (i & 1) != 0 ? 3 : 5;
    corners.y[i] = (i & 2) != 0 ? -1 : 1;
    corners.z[i] = (i & 4) != 0 ? 0 : 2;
  }
  Beam beam{};
  beam.begin = {0.6, -0.8};
  beam.end = {0.6, 0.8};
  Beam narrow = beam;
  narrow.end = {1, 0};
  Beam aside = beam;
  aside.begin = {0, 1};
  const HeightPlane below{{-1, 0}, true, 0};
  const HeightPlane across{{0.2, 0}, true, 0};
  const HeightPlane above{{-1, 0}, false, 0};
  const HeightPlane blurred{{-1, 0}, true, 0.5};
  forEachInstructionSet([&] {
    const BeamKernels& kernels = beamKernels();
    const auto straddled = [&](const Beam& of, const std::vector<HeightPlane>& planes,
                               double margin, double reach, std::uint32_t asked = kAllBounds,
                               const Segment* on = nullptr) {
      return kernels.findStraddled(corners, {of, planes, {0, 0, 0}, on}, asked, margin, reach);
    };
    EXPECT_EQ(straddled(beam, {}, 0.1, 0), 0U);
    EXPECT_EQ(straddled(narrow, {below, across, below, across}, 0.1, 0), 0b101010U);
    EXPECT_EQ(straddled(aside, {}, 0.1, 0), kBehindBound);
    EXPECT_EQ(straddled(beam, {across, above}, 0.1, 0), kBehindBound);
    EXPECT_EQ(straddled(beam, {above}, 4, 0), 0b111U) << "by less than its slack";
    EXPECT_EQ(straddled(beam, {blurred}, 0.4, 5), 0U);
    EXPECT_EQ(straddled(beam, {blurred}, 0.4, 6), 0b100U);
    std::vector<HeightPlane> many(40, below);
    many[36] = across;
    constexpr std::uint32_t kLastBit = std::uint32_t{1} << 30;
    EXPECT_EQ(straddled(beam, many, 0.1, 0), kLastBit) << "it has room for all that follow";
    EXPECT_EQ(straddled(beam, many, 0.1, 0, kLastBit), kLastBit);
    EXPECT_EQ(straddled(beam, {above}, 0.1, 0, 0), 0U) << "it is not asked for";

    const Segment far = wallAt(4, false);
    const Segment near = wallAt(2, true);
    const Segment turned = wallAt(2, false);
    Beam between = beam;
    between.to = &far;
    EXPECT_EQ(straddled(between, {below}, 0.1, 0), 0b1000U);
    EXPECT_EQ(straddled(between, {below}, 0.1, 0, kAllBounds, &far), 0U) << "they lie on it";
    between.from = &near;
    EXPECT_EQ(straddled(between, {}, 0.1, 0), 0b1000U) << "that before them comes first";
    between.to = &turned;
    EXPECT_EQ(straddled(between, {}, 0.1, 0), kBehindBound);
  });
}

/// Two beams side by side: whatever is in front of both bounds of one is lit.
TEST_F(LightKernelsTest, findSeenWhatOneBeamHoldsForSure) {
  const std::vector<BoundingPlane> bounds = {
      {{1, 0, 0}, 0, 2}, {{0, 1, 0}, -10, 2}, {{-1, 0.2, 0}, 3, 1}};
  const std::vector<StraddledBounds> beams = {{2, false}, {1, false}};
  const std::vector<StraddledBounds> doubtful = {{2, true}, {1, true}};
  int unknown = 0;
  forEachInstructionSet([&] {
    const BeamKernels& kernels = beamKernels();
    std::vector<double> seen(kCount + SampleArrays::kMaxLanes);
    std::vector<double> inDoubt(kCount + SampleArrays::kMaxLanes);
    kernels.findSeen(samples_.arrays(), kCount, light_, beams, bounds.data(), seen.data());
    kernels.findSeen(samples_.arrays(), kCount, light_, doubtful, bounds.data(), inDoubt.data());
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto isIn = [&](const BoundingPlane& bound, double slack) {
        return dot(bound.normal, samples_.at(i) - light_) - bound.offset > slack;
      };
      const bool isLit = (isIn(bounds[0], 2) && isIn(bounds[1], 2)) || isIn(bounds[2], 1);
      const bool isDark = !(isIn(bounds[0], -2) && isIn(bounds[1], -2)) && !isIn(bounds[2], -1);
      EXPECT_EQ(seen[i], isLit ? 1 : isDark ? 0 : kUnknownFraction);
      EXPECT_EQ(inDoubt[i], isDark ? 0 : kUnknownFraction);
      unknown += seen[i] == kUnknownFraction ? 1 : 0;
    }
  });
  EXPECT_GT(unknown, 0);
}

}  // namespace
}  // namespace hearth
