#include "import/doom/sprites.h"

#include <gtest/gtest.h>

#include "pictures_builder.h"

namespace hearth::doom {
namespace {

using Names = std::vector<std::string>;

/// Frame A of these is all there is to them.
const ThingType kTorch{.number = 1, .name = "", .sprite = "TORC", .idle = "A*"};
const ThingType kImp{.number = 2, .name = "", .sprite = "IMPS", .idle = "A"};

class SpritesOfAWad : public testing::Test {
 protected:
  SpritesOfAWad() { builder_.add("PLAYPAL", palette()).add("S_START"); }

  void add(const char* lump, const std::string& patch) { builder_.add(lump, patch); }

  tl::expected<SpriteLook, std::string> look(const ThingType& type,
                                             std::size_t maxPixels = kMaxPixels) {
    const Wad wad = opened(builder_);
    const Pictures pictures = *Pictures::read(wad);
    materials_.emplace(pictures, "MAP01", findings_, maxPixels);
    return Sprites(pictures, *materials_, findings_).lookOf(type);
  }

  /// What the only frame of a type lists.
  Names views(const ThingType& type) {
    const auto made = look(type);
    if (!made) return {made.error()};
    return made->frames.at(0);
  }

  /// Rows of an image: a letter for each pixel, `a` for colour 1; `.` is a hole.
  Names rowsOf(const std::string& file) const {
    const Image* image = materials_->find(file);
    if (!image) return {};
    Names rows(static_cast<std::size_t>(image->height()));
    for (int y = 0; y < image->height(); ++y)
      for (int x = 0; x < image->width(); ++x)
        rows[static_cast<std::size_t>(y)] +=
            image->isHole(x, y) ? '.' : static_cast<char>('a' + image->at(x, y).r - 1);
    return rows;
  }

  WadBuilder builder_;
  Findings findings_;
  std::optional<Materials> materials_;
};

/// ab
/// .c
std::string letters(Origin origin) { return patchOf(2, {{{0, {1}}}, {{0, {2, 3}}}}, origin); }

TEST_F(SpritesOfAWad, haveOneViewIfTheirRotationIs0) {
  add("TORCA0", letters({1, 2}));
  EXPECT_EQ(views(kTorch), (Names{"sprite-torca0"}));
  EXPECT_EQ(rowsOf("sprite-torca0"), (Names{"ab", ".c"}));
  EXPECT_FALSE(look(kTorch)->hasSides());
}

TEST_F(SpritesOfAWad, haveEightViewsInTheOtherDirectionThanDoomsRotations) {
  for (int i = 1; i <= 8; ++i) add(fmt::format("IMPSA{}", i).c_str(), plainPatch(1, 1, i, {0, 1}));
  EXPECT_EQ(views(kImp),
            (Names{"sprite-impsa1", "sprite-impsa8", "sprite-impsa7", "sprite-impsa6",
                   "sprite-impsa5", "sprite-impsa4", "sprite-impsa3", "sprite-impsa2"}));
  EXPECT_EQ(rowsOf("sprite-impsa8"), (Names{"h"}));
  EXPECT_TRUE(look(kImp)->hasSides());
}

TEST_F(SpritesOfAWad, areMirroredWhereALumpServesTwoRotations) {
  add("IMPSA1", letters({1, 2}));
  add("IMPSA2A8", letters({1, 2}));
  add("IMPSA3A7", letters({1, 2}));
  add("IMPSA4A6", letters({1, 2}));
  add("IMPSA5", letters({1, 2}));
  EXPECT_EQ(views(kImp).size(), 8U);
  EXPECT_EQ(rowsOf("sprite-impsa2"), (Names{"ab", ".c"}));
  EXPECT_EQ(rowsOf("sprite-impsa8"), (Names{"ba", "c."}));
}

TEST_F(SpritesOfAWad, haveOneCanvasOnWhichTheThingStandsAtOnePlace) {
  add("IMPSA1", letters({0, 2}));
  add("IMPSA2A8", letters({2, 3}));
  add("IMPSA3A7", letters({1, 2}));
  add("IMPSA4A6", letters({1, 1}));
  add("IMPSA5", letters({1, 2}));
  const SpriteCanvas canvas = look(kImp)->canvas;
  EXPECT_EQ(canvas.left, 2);
  EXPECT_EQ(canvas.right, 2);
  EXPECT_EQ(canvas.top, 3);
  EXPECT_EQ(canvas.bottom, -1);
  EXPECT_EQ(rowsOf("sprite-impsa1"), (Names{"....", "..ab", "...c", "...."}));
  EXPECT_EQ(rowsOf("sprite-impsa2"), (Names{"ab..", ".c..", "....", "...."}));
  EXPECT_EQ(rowsOf("sprite-impsa8"), (Names{"..ba", "..c.", "....", "...."}));
  EXPECT_EQ(rowsOf("sprite-impsa4"), (Names{"....", "....", ".ab.", "..c."}));
  EXPECT_EQ(rowsOf("sprite-impsa6"), (Names{"....", "....", ".ba.", ".c.."}));
}

TEST_F(SpritesOfAWad, repeatFramesForTheirDurations) {
  add("TORCA0", letters({1, 2}));
  add("TORCB0", letters({1, 2}));
  ThingType type = kTorch;
  type.idle = "A2* B1*";
  const SpriteLook made = *look(type);
  EXPECT_EQ(made.frames,
            (std::vector<Names>{{"sprite-torca0"}, {"sprite-torca0"}, {"sprite-torcb0"}}));
  EXPECT_EQ(made.framesPerSecond, 35);
  EXPECT_TRUE(made.isBright);
  EXPECT_EQ(made.countImages(), 3U);
  EXPECT_EQ(materials_->count(), 2U) << "each is drawn once";
}

TEST_F(SpritesOfAWad, areThoseOfTheLastLumps) {
  for (int i = 1; i <= 8; ++i) add(fmt::format("IMPSA{}", i).c_str(), plainPatch(1, 1, i, {0, 1}));
  add("S_END", {});
  add("SS_START", {});
  add("IMPSA7", plainPatch(1, 1, 20, {0, 1}));
  EXPECT_EQ(views(kImp).size(), 8U);
  EXPECT_EQ(rowsOf("sprite-impsa7"), (Names{"t"}));
  EXPECT_EQ(rowsOf("sprite-impsa6"), (Names{"f"}));
  add("IMPSA0", plainPatch(1, 1, 21, {0, 1}));
  EXPECT_EQ(views(kImp), (Names{"sprite-impsa0"}));
}

TEST_F(SpritesOfAWad, lieBetweenMarkers) {
  add("S_END", {});
  add("TORCA0", letters({1, 2}));
  EXPECT_EQ(views(kTorch), (Names{"there is no sprite TORCA"}));
}

TEST_F(SpritesOfAWad, areRefusedWithoutAllSides) {
  add("IMPSA1", letters({1, 2}));
  add("IMPSA2A8", letters({1, 2}));
  EXPECT_EQ(views(kImp), (Names{"sprite IMPSA has no image IMPSA7"}));
}

TEST_F(SpritesOfAWad, areRefusedIfTheyAreNoPatches) {
  add("TORCA0", "abc");
  EXPECT_EQ(views(kTorch), (Names{"sprite TORCA0 has 3 bytes, too few for a patch"}));
  EXPECT_EQ(materials_->count(), 0U);
}

TEST_F(SpritesOfAWad, areRefusedIfTheirOffsetsPutThemFarFromEachOther) {
  add("IMPSA1", plainPatch(1, 1, 1, {0, 1}));
  add("IMPSA2A8", plainPatch(1, 1, 1, {-32768, 1}));
  add("IMPSA3A7", plainPatch(1, 1, 1, {0, 32767}));
  add("IMPSA4A6", plainPatch(1, 1, 1, {0, -32768}));
  add("IMPSA5", plainPatch(1, 1, 1, {0, 1}));
  EXPECT_EQ(views(kImp),
            (Names{"sprite IMPSA1 and its other images take 65538 x 65536 pixels where "
                   "their offsets put them: a side may have 4096"}));
}

TEST_F(SpritesOfAWad, areRefusedIfALevelsImagesWouldHaveTooManyPixels) {
  add("TORCA0", plainPatch(10, 10, 1, {5, 10}));
  EXPECT_TRUE(look(kTorch, 100));
  EXPECT_EQ(look(kTorch, 99).error(),
            "sprite TORCA0 and the images before it have more pixels than a level's images may");
}

TEST_F(SpritesOfAWad, areShownAsFarAsTheyCanBeRead) {
  std::string cut = letters({1, 2});
  cut.resize(cut.size() - 3);
  add("TORCA0", cut);
  EXPECT_EQ(views(kTorch), (Names{"sprite-torca0"}));
  EXPECT_EQ(rowsOf("sprite-torca0")[0][0], 'a');
  ASSERT_EQ(findings_.size(), 1U);
  EXPECT_EQ(findings_[0].what, "sprite TORCA0 breaks off in column 1");
}

}  // namespace
}  // namespace hearth::doom
