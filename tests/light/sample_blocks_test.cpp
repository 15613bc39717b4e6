// Blocks of samples, by which beams and shafts are asked.

#include "light/sampling/sample_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::sectorText;

/// Samples of the floor of a room in two sectors, every seventh of them spare.
class SampleBlocksTest : public testing::Test {
 protected:
  static constexpr int kColumns = 43;
  static constexpr int kRows = 29;

  std::vector<SamplePoint> samples() const {
    std::vector<SamplePoint> samples;
    const SamplePlacement placement(surfaces_, west_);
    for (int j = 0; j < kRows; ++j)
      for (int i = 0; i < kColumns; ++i) {
        samples.push_back(placement.place({4 + i * 0.5, 4 + j * 0.5}));
        samples.back().isSpare = samples.size() % 7 == 0;
      }
    return samples;
  }

  /// Calls `visit` for a block and all its parts.
  template <typename Visit>
  void forEachBlock(const SampleBlocks::Block& block, Visit&& visit) const {
    visit(block);
    for (const SampleBlocks::Block& part : blocks_.partsOf(block)) forEachBlock(part, visit);
  }

  test::BakedRoom room_{"{'light': 0, 'sectors': {" +
                            sectorText("west", "0,0, 2,0, 2,4, 0,4", 0, 3,
                                       "[{'texture':'#808080'},{'next':'east'},"
                                       "{'texture':'#808080'},{'texture':'#808080'}]") +
                            ", " +
                            sectorText("east", "2,0, 4,0, 4,4, 2,4", 0, 3,
                                       "[{'texture':'#808080'},{'texture':'#808080'},"
                                       "{'texture':'#808080'},{'next':'west'}]") +
                            "}}",
                        "{'bake': {'texel': 0.125}, 'lights': [{'x':1,'y':1,'z':2}]}"};
  LitSurfaces surfaces_ = makeLitSurfaces(room_.scene(), 0.125);
  SurfaceId west_ = room_.surfaceAt(SurfaceKind::Floor, {1, 1, 0}, "west").value();
  SurfaceId east_ = room_.surfaceAt(SurfaceKind::Floor, {3, 1, 0}, "east").value();
  SampleBlocks blocks_{room_.level(), *surfaces_[west_.index()], samples(), kColumns};
};

TEST_F(SampleBlocksTest, holdEachSampleThatIsNotSpareOnceWithTheOthersOfItsSurface) {
  std::vector<int> found(blocks_.samples().size());
  ASSERT_EQ(blocks_.onSurfaces().size(), 2U);
  EXPECT_EQ(blocks_.onSurfaces()[0].surface, west_);
  EXPECT_EQ(blocks_.onSurfaces()[1].surface, east_);
  for (const SampleBlocks::Block& block : blocks_.onSurfaces())
    for (const std::uint32_t index : blocks_.indices(block)) {
      EXPECT_EQ(blocks_.samples()[index].surface, *block.surface);
      ++found[index];
    }
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(found[i], blocks_.samples()[i].isSpare ? 0 : 1) << i;
}

TEST_F(SampleBlocksTest, areDividedIntoPartsWithoutGaps) {
  std::size_t leaves = 0;
  forEachBlock(blocks_.whole(), [&](const SampleBlocks::Block& block) {
    ASSERT_GT(block.count, 0U);
    if (block.parts == 0) {
      EXPECT_LE(block.count, 16U);
      ++leaves;
      return;
    }
    std::size_t next = block.first;
    for (const SampleBlocks::Block& part : blocks_.partsOf(block)) {
      EXPECT_EQ(part.first, next);
      next += part.count;
    }
    EXPECT_EQ(next, block.first + block.count);
  });
  EXPECT_GT(leaves, 60U);
}

TEST_F(SampleBlocksTest, haveTheTargetsOfTheirSamplesInTheirBoxes) {
  forEachBlock(blocks_.whole(), [&](const SampleBlocks::Block& block) {
    Box3 box;
    const TargetBox around = blocks_.boxOf(block);
    for (const Vec3 corner : around.corners()) box.add(corner);
    box = box.grownBy(1e-9);
    const SampleArrays targets = blocks_.targets(block);
    std::size_t i = 0;
    for (const std::uint32_t index : blocks_.indices(block)) {
      const Vec3 target{targets.x[i], targets.y[i], targets.z[i]};
      EXPECT_EQ(target, blocks_.samples()[index].target);
      EXPECT_TRUE(box.meets(Box3{target, target}));
      ++i;
    }
  });
}

}  // namespace
}  // namespace hearth
