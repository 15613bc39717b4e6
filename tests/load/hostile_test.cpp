#include <gtest/gtest.h>
#include <sys/stat.h>

#include "load_text.h"
#include "support/temporary_folder.h"

/// Input that is meant to break the loader is refused in bounded time and memory.
namespace hearth {
namespace {

std::string onlyMessage(const LoadResult& result) {
  EXPECT_FALSE(result.loaded);
  EXPECT_EQ(result.diagnostics.size(), 1U) << listed(result);
  return result.diagnostics.empty() ? "" : result.diagnostics[0].message;
}

TEST(Hostile, aHundredThousandNestedArrays) {
  EXPECT_EQ(onlyMessage(loadText(std::string(100'000, '['))),
            "more than 64 arrays and objects inside one another");
}

TEST(Hostile, aFileOverTheLimitIsNotRead) {
  // A file with a hole of a gigabyte takes no room on the disk, and none in memory.
  const test::TemporaryFolder folder;
  const auto file = folder.write("spaces.json", " ");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 30);
  EXPECT_EQ(onlyMessage(loadLevel(file)), "1073741824 bytes are more than 67108864");
}

TEST(Hostile, whatIsNoRegularFileIsNotRead) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(onlyMessage(loadLevel(folder.path())), "not a regular file");
  EXPECT_EQ(onlyMessage(loadLevel("/dev/zero")), "not a regular file");
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(onlyMessage(loadLevel(folder.path() / "pipe")), "not a regular file");
  EXPECT_EQ(onlyMessage(loadLevel(folder.path() / "none.json")), "no such file");
}

TEST(Hostile, moreVerticesThanTheLimitAreReportedOnce) {
  LoadLimits limits;
  limits.vertices = 7;
  const std::string text = "{'light': 1, 'sectors': {" + sectorText("a", "0,0, 1,0, 1,1, 0,1") +
                           "," + sectorText("b", "2,0, 3,0, 3,1, 2,1") + "," +
                           sectorText("c", "4,0, 5,0, 5,1, 4,1") + "}}";
  const LoadResult result = loadText(text, "", limits);
  EXPECT_EQ(onlyMessage(result), "more than 7 vertices");
  EXPECT_EQ(result.diagnostics[0].advice, "raise the limit with --max-vertices");
  EXPECT_EQ(result.diagnostics[0].pointer, "/sectors/b/loops/border/v");
  limits.vertices = 12;
  EXPECT_TRUE(loadText(text, "", limits).loaded);
}

TEST(Hostile, moreLightsThanTheLimitAreRefused) {
  LoadLimits limits;
  limits.lights = 1;
  const LoadResult result =
      loadText("{'sectors': {" + sectorText("a", "0,0, 1,0, 1,1, 0,1") + "}}",
               "[{'x': 0.5, 'y': 0.5, 'z': 1}, {'x': 0.5, 'y': 0.5, 'z': 2}]", limits);
  EXPECT_EQ(onlyMessage(result), "2 lights are more than 1");
  EXPECT_EQ(result.diagnostics[0].advice, "raise the limit with --max-lights");
}

TEST(Hostile, ofTenThousandMistakesFiveHundredAreToldAndTheRestCounted) {
  std::string keys;
  for (int i = 0; i < 10'000; ++i) keys += "'key" + std::to_string(i) + "': 0, ";
  const LoadResult result =
      loadText("{" + keys + "'sectors': {" + sectorText("a", "0,0, 1,0, 1,1, 0,1") + "}}");
  EXPECT_FALSE(result.loaded);
  ASSERT_EQ(result.diagnostics.size(), 501U);
  EXPECT_EQ(result.diagnostics.back().message, "9500 more errors are left out");
}

TEST(Hostile, strayBytesNeverStopTheProgram) {
  // Every single-byte change of a small level either loads or is refused with a message.
  const std::string level =
      "{'light': 1, 'sectors': {" + sectorText("a", "0,0, 4,0, 4,4, 0,4") + "}}";
  for (std::size_t i = 0; i < level.size(); ++i)
    for (const char byte : {'\0', ' ', '"', '{', ']', '9', '-', 'e', '\x80', '\xff'}) {
      std::string changed = level;
      changed[i] = byte;
      const LoadResult result = loadText(changed);
      EXPECT_EQ(result.loaded.has_value(), countErrors(result) == 0) << changed;
    }
}

TEST(Hostile, everyPrefixOfALevelIsRefused) {
  const std::string level =
      "{'light': 1, 'sectors': {" + sectorText("a", "0,0, 4,0, 4,4, 0,4") + "}}";
  for (std::size_t size = 0; size < level.size(); ++size)
    EXPECT_EQ(countErrors(loadText(level.substr(0, size))), 1U) << size;
}

}  // namespace
}  // namespace hearth
