// That a picture does not depend on the processor: it is drawn with each instruction set that this
// one has.

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <random>
#include <string>
#include <vector>

#include "load/load.h"
#include "render/renderer.h"
#include "render/row_kernels.h"
#include "row_batches.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

/// Those that the engine is compiled for and this processor has, the best one first.
std::vector<std::int64_t> instructionSets() { return hwy::SupportedAndGeneratedTargets(); }

class InstructionSets : public testing::Test {
 protected:
  ~InstructionSets() override { use(0); }

  /// One set alone; with 0, the best one again.
  static void use(std::int64_t set) {
    hwy::SetSupportedTargetsForTest(set);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }

  void expectTheSamePictures(const std::string& name, const DrawSettings& settings,
                             LightMode mode) {
    const LoadedLevel loaded = loadLevel(test::inTree("levels/" + name + ".json")).loaded.value();
    BakeSettings coarse = loaded.level.bake;
    coarse.texel = 0.5;
    const BakedLight light = bake(loaded.scene(), coarse, 2);
    const Renderer renderer(loaded.scene(), loaded.textures, light, settings);
    for (const Shot& shot : loaded.level.shots) {
      Camera camera = cameraOf(shot);
      camera.width = 203;  // a last strip of 3 columns
      camera.height = 149;
      use(0);
      const Image expected = renderer.draw(camera, mode);
      for (const std::int64_t set : instructionSets()) {
        use(set);
        EXPECT_EQ(renderer.draw(camera, mode), expected)
            << shot.name << ' ' << hwy::TargetName(set);
      }
      use(0);
    }
  }
};

TEST_F(InstructionSets, areSeveral) { EXPECT_GT(instructionSets().size(), 1U); }

TEST_F(InstructionSets, drawTheSamePictures) {
  for (const LightMode mode : {LightMode::Both, LightMode::None, LightMode::Only})
    expectTheSamePictures("tutorial", {}, mode);
}

/// Random light.
Lightmap someLight(int channels) {
  Lightmap lightmap;
  lightmap.rect = {3, -2, 4, 70};
  lightmap.channels = channels;
  std::mt19937 random(1);
  for (int i = 0; i < 4 * 70 * channels; ++i)
    lightmap.levels.push_back(static_cast<std::uint8_t>(random()));
  return lightmap;
}

/// What shows of the light in rows down a column of it, found as on planes or as on walls.
std::vector<float> shownDownTo(double lowest, const Lightmap& lightmap, bool isPlane) {
  const SpanMapping down{.isPlane = isPlane, .s = {4.8, 0}, .t = {0, 1}};
  std::vector<double> rows;
  for (std::size_t k = 0; k < 101; ++k) rows.push_back(lowest * static_cast<double>(k) / 100);
  RowBatch batch{};
  test::setRows(batch, rows);
  const RowKernels& kernels = rowKernels();
  (isPlane ? kernels.findLightTexels : kernels.findLightRows)(batch, down, lightmap,
                                                              LightFilter::Bilinear);
  (isPlane ? kernels.findShown : kernels.findShownUpright)(batch, lightmap, 0.125);
  std::vector<float> shown;
  for (const RowBatch::Rows<float>& channel : batch.shown)
    shown.insert(shown.end(), channel.begin(), channel.begin() + 101);
  return shown;
}

/// Down as few texels as a register holds, two registers, and more.
TEST_F(InstructionSets, lightWallsLikePlanes) {
  for (const std::int64_t set : instructionSets()) {
    use(set);
    for (const int channels : {1, 3}) {
      const Lightmap lightmap = someLight(channels);
      for (const double lowest : {0.4, -3.0, 5.0, 13.0, 15.0, 29.0, 31.0, 66.0, 90.0})
        EXPECT_EQ(shownDownTo(lowest, lightmap, false), shownDownTo(lowest, lightmap, true))
            << hwy::TargetName(set) << ' ' << channels << ' ' << lowest;
    }
  }
}

TEST_F(InstructionSets, mixTexelsTheSame) {
  expectTheSamePictures("tutorial", {.textureFilter = TextureFilter::Bilinear}, LightMode::Both);
  expectTheSamePictures("tutorial", {.textureFilter = TextureFilter::Mipmapped}, LightMode::Both);
  expectTheSamePictures("keep", {.lightFilter = LightFilter::Nearest}, LightMode::Both);
}

}  // namespace
}  // namespace hearth
