#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "files/read_file.h"
#include "files/replace_file.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

/// Files that are read and written as a whole.
class WholeFile : public testing::Test {
 protected:
  WholeFile() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~WholeFile() override { fs::remove_all(folder_); }

  fs::path path(const std::string& name) const { return folder_ / name; }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string textOf(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::ptrdiff_t countFiles() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  ReadErrorCode errorCodeOf(const std::string& name, std::uint64_t maxBytes = 1000) const {
    const auto read = readFile(path(name), maxBytes);
    EXPECT_FALSE(read) << name;
    return read ? ReadErrorCode::Failed : read.error().code;
  }

 private:
  fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

FileWriter writerOf(const std::string& text) {
  return [text](std::ostream& stream) {
    stream << text;
    return stream.good();
  };
}

TEST_F(WholeFile, isMadeWhereThereIsNone) {
  EXPECT_EQ(createFile(path("a"), writerOf("new")), true);
  EXPECT_EQ(textOf("a"), "new");
  EXPECT_EQ(createFile(path("a"), writerOf("newer")), false);
  EXPECT_EQ(textOf("a"), "new");
  EXPECT_EQ(countFiles(), 1);
}

TEST_F(WholeFile, isNotMadeInPlaceOfALinkThatLeadsNowhere) {
  fs::create_symlink("nowhere", path("a"));
  EXPECT_EQ(createFile(path("a"), writerOf("new")), false);
  EXPECT_EQ(countFiles(), 1);
}

TEST_F(WholeFile, keepsItsPermissionsWhenItIsReplaced) {
  for (const fs::perms permissions : {fs::perms(0640), fs::perms(0777), fs::perms(0444)}) {
    put("a", "old");
    fs::permissions(path("a"), permissions);
    ASSERT_TRUE(replaceFile(path("a"), writerOf("new")));
    EXPECT_EQ(textOf("a"), "new");
    EXPECT_EQ(fs::status(path("a")).permissions(), permissions);
    fs::remove(path("a"));
  }
}

TEST_F(WholeFile, staysAsItWasWhenItsWriterFails) {
  put("a", "old");
  const auto written = replaceFile(path("a"), [](std::ostream& stream) {
    stream << "half";
    return false;
  });
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error(), path("a").string() + ": cannot be written");
  EXPECT_EQ(textOf("a"), "old");
  EXPECT_EQ(countFiles(), 1);
}

TEST_F(WholeFile, isWrittenOverWhatAKilledProgramLeft) {
  put("a.tmp", "left behind, and longer than what comes");
  ASSERT_TRUE(replaceFile(path("a"), writerOf("new")));
  EXPECT_EQ(textOf("a"), "new");
  EXPECT_EQ(countFiles(), 1);
}

TEST_F(WholeFile, isWrittenOverWhatAKilledProgramLeftReadOnly) {
  for (const bool isThere : {false, true}) {
    if (isThere) put("a", "old");
    put("a.tmp", "finished, but not renamed");
    fs::permissions(path("a.tmp"), fs::perms(0444));
    ASSERT_TRUE(replaceFile(path("a"), writerOf("new")));
    EXPECT_EQ(textOf("a"), "new");
    EXPECT_EQ(countFiles(), 1);
  }
}

TEST_F(WholeFile, isAsPrivateWhileItIsWrittenAsTheFileThatItReplaces) {
  put("a", "old");
  fs::permissions(path("a"), fs::perms(0600));
  put("a.tmp", "left behind, from when everyone could read the file");
  fs::permissions(path("a.tmp"), fs::perms(0644));
  ASSERT_TRUE(replaceFile(path("a"), [&](std::ostream& stream) {
    EXPECT_EQ(fs::status(path("a.tmp")).permissions(), fs::perms(0600));
    return writerOf("new")(stream);
  }));
  EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms(0600));
}

TEST_F(WholeFile, takesThePlaceOfALinkThatLeadsNowhere) {
  fs::create_symlink("nowhere", path("a"));
  ASSERT_TRUE(replaceFile(path("a"), writerOf("new")));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("a"))));
  EXPECT_EQ(countFiles(), 1);
}

TEST_F(WholeFile, isReplacedBehindALink) {
  put("b", "old");
  fs::create_symlink("b", path("a"));
  ASSERT_TRUE(replaceFile(path("a"), writerOf("new")));
  EXPECT_TRUE(fs::is_symlink(path("a")));
  EXPECT_EQ(textOf("b"), "new");
}

TEST_F(WholeFile, isNotWrittenThroughALinkInPlaceOfItsPart) {
  put("other", "mine");
  fs::create_symlink(path("other"), path("a.tmp"));
  EXPECT_FALSE(replaceFile(path("a"), writerOf("new")));
  EXPECT_EQ(textOf("other"), "mine");
}

TEST_F(WholeFile, isThatOfOneOfSeveralThreadsThatWriteIt) {
  std::vector<std::string> texts;
  for (int i = 1; i <= 4; ++i) texts.emplace_back(std::size_t(i) << 14, static_cast<char>('a' + i));
  ASSERT_TRUE(replaceFile(path("a"), writerOf(texts[0])));
  std::vector<std::thread> writers;
  for (const std::string& text : texts)
    writers.emplace_back([&] {
      for (int i = 0; i < 20; ++i) EXPECT_TRUE(replaceFile(path("a"), writerOf(text)));
    });
  for (int i = 0; i < 100; ++i) {
    const auto read = readFile(path("a"), 1 << 20);
    ASSERT_TRUE(read) << read.error().what;
    EXPECT_NE(std::ranges::find(texts, *read), texts.end()) << read->size();
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(countFiles(), 1);
}

TEST_F(WholeFile, isReadOrSaysWhyNot) {
  put("a", std::string("with\0zero", 9));
  EXPECT_EQ(readFile(path("a"), 9), std::string("with\0zero", 9));
  EXPECT_EQ(errorCodeOf("a", 8), ReadErrorCode::TooLong);
  EXPECT_EQ(errorCodeOf("none"), ReadErrorCode::Missing);
  EXPECT_EQ(errorCodeOf("a/none"), ReadErrorCode::Missing);
  EXPECT_EQ(errorCodeOf("."), ReadErrorCode::NotRegular);
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(errorCodeOf("pipe"), ReadErrorCode::NotRegular);
}

}  // namespace
}  // namespace hearth
