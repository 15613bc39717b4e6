#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/check/golden_picture.h"
#include "image/image_file.h"
#include "settings/shell_text.h"
#include "support/in_tree.h"
#include "text/base64.h"

namespace hearth {

namespace {

class GoldenPicture : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path kept(const Image& image, std::string_view name = "shot") const {
    const std::filesystem::path file = pictureFile(folder_, name);
    EXPECT_TRUE(writePng(file, image));
    return file;
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("hearth_check_test." + std::to_string(getpid()));
};

TEST_F(GoldenPicture, IsTheSameOnlyIfEveryPixelIs) {
  const Image image(7, 5, {10, 20, 30});
  const std::filesystem::path golden = kept(image);
  EXPECT_EQ(compareWithGolden(golden, image).verdict, Verdict::Same);
  for (const auto& [x, y] : {std::pair{0, 0}, {6, 0}, {0, 4}, {6, 4}, {3, 2}}) {
    Image wrong = image;
    wrong.at(x, y).b = 31;
    const Comparison comparison = compareWithGolden(golden, wrong);
    EXPECT_EQ(comparison.verdict, Verdict::Differs);
    EXPECT_EQ(comparison.golden, image);
    EXPECT_EQ(comparison.words,
              "1 of 35 pixels differ, 0 by more than 2 levels, 0 by more than 8; "
              "largest difference 1 of 255, largest patch 1 pixel(s)");
  }
}

TEST_F(GoldenPicture, OfAnotherSizeIsToldApartFromADifference) {
  const std::filesystem::path golden = kept(Image(7, 5));
  EXPECT_EQ(compareWithGolden(golden, Image(5, 7)).verdict, Verdict::OtherSize);
  EXPECT_EQ(compareWithGolden(golden, Image(7, 6)).verdict, Verdict::OtherSize);
}

TEST_F(GoldenPicture, MayBeMissingOrUnreadable) {
  EXPECT_EQ(compareWithGolden(folder_ / "none.png", Image(2, 2)).verdict, Verdict::Missing);
  EXPECT_EQ(compareWithGolden(folder_, Image(2, 2)).verdict, Verdict::Unreadable);
  const std::filesystem::path golden = kept(Image(64, 64));
  std::filesystem::resize_file(golden, std::filesystem::file_size(golden) / 2);
  EXPECT_EQ(compareWithGolden(golden, Image(64, 64)).verdict, Verdict::Unreadable);
}

TEST_F(GoldenPicture, IsStaleWhenNoShotDrawsIt) {
  for (const char* name : {"b", "hall", "a"}) kept(Image(1, 1), name);
  std::ofstream(folder_ / "README.md") << "not a picture";
  std::filesystem::create_directory(folder_ / "folder.png");
  Shot hall;
  hall.name = "hall";
  EXPECT_EQ(staleGoldens(folder_, {hall}), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(staleGoldens(folder_ / "none", {hall}), std::vector<std::string>{});
}

/// Two goldens that pass for each other would show that the check sees nothing.
TEST_F(GoldenPicture, EveryTwoOfTheProjectDiffer) {
  std::vector<std::filesystem::path> goldens;
  for (const char* folder : {"levels/tutorial.golden", "levels/keep.golden", "tests/render/golden"})
    for (const auto& entry : std::filesystem::directory_iterator(test::inTree(folder)))
      // Overdraw is the same green everywhere: each pixel is drawn once.
      if (!entry.path().string().ends_with("-overdraw.png")) goldens.push_back(entry.path());
  ASSERT_GE(goldens.size(), 48U);
  for (std::size_t i = 0; i < goldens.size(); ++i) {
    const Image drawn = readImage(goldens[i], 1 << 24).value();
    EXPECT_EQ(compareWithGolden(goldens[i], drawn).verdict, Verdict::Same) << goldens[i];
    for (std::size_t j = 0; j < i; ++j) {
      const Verdict verdict = compareWithGolden(goldens[j], drawn).verdict;
      EXPECT_TRUE(verdict == Verdict::Differs || verdict == Verdict::OtherSize)
          << goldens[j] << " passes for " << goldens[i];
    }
  }
}

TEST(GoldenFolders, StandBesideTheLevelOrInTheFolderThatIsGiven) {
  const GoldenFolders beside = goldenFolders("levels/yard.json", std::nullopt);
  EXPECT_EQ(beside.golden, "levels/yard.golden");
  EXPECT_EQ(beside.failed, "levels/yard.failed");
  const GoldenFolders given = goldenFolders("levels/yard.json", "kept");
  EXPECT_EQ(given.golden, "kept/yard.golden");
  EXPECT_EQ(given.failed, "kept/yard.failed");
}

TEST(GoldenFolders, OfAModelAreNotThoseOfALevelOfTheSameStem) {
  const GoldenFolders folders = goldenFolders("levels/yard.obj", std::nullopt);
  EXPECT_EQ(folders.golden, "levels/yard.obj.golden");
  EXPECT_EQ(folders.failed, "levels/yard.obj.failed");
}

TEST(IsFileName, RefusesOtherFoldersAndHiddenFiles) {
  for (const char* good : {"a", "down the well", "-x", "a.b", "caf\u00e9", "<&>'\""})
    EXPECT_TRUE(isFileName(good)) << good;
  for (const char* bad : {".", "..", ".hidden", "a/b", "/a", "../a", "a\nb", "a\x7f"})
    EXPECT_FALSE(isFileName(bad)) << bad;
  EXPECT_FALSE(isFileName(std::string_view("a\0b", 3)));
}

TEST(Base64, IsThatOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string_view("\xfb\xff\x00", 3)), "+/8A");
}

TEST(ShellText, QuotesWhatAShellWouldTakeApart) {
  EXPECT_EQ(shellWord("levels/yard-2.json"), "levels/yard-2.json");
  EXPECT_EQ(shellWord(""), "''");
  EXPECT_EQ(shellWord("down the well"), "'down the well'");
  EXPECT_EQ(shellWord("it's $HOME"), "'it'\\''s $HOME'");
}

TEST(ShellText, OptionsComeOutAsTheyWereTyped) {
  OptionValues values;
  values.set(Option::Lambert, "");
  values.set(Option::Texel, "0.5");
  values.set(Option::Golden, "my goldens");
  EXPECT_EQ(typedOptions(values, {Option::Golden, Option::Texel, Option::Samples, Option::Lambert}),
            " --golden 'my goldens' --texel 0.5 --lambert");
}

}  // namespace

}  // namespace hearth
