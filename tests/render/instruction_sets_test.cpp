// That a picture does not depend on the processor: it is drawn with each instruction set that this
// one has.

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <string>
#include <vector>

#include "load/load.h"
#include "render/renderer.h"
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

TEST_F(InstructionSets, mixTexelsTheSame) {
  expectTheSamePictures("tutorial", {.textureFilter = TextureFilter::Bilinear}, LightMode::Both);
  expectTheSamePictures("tutorial", {.textureFilter = TextureFilter::Mipmapped}, LightMode::Both);
  expectTheSamePictures("keep", {.lightFilter = LightFilter::Nearest}, LightMode::Both);
}

}  // namespace
}  // namespace hearth
