#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "load/load.h"
#include "support/in_tree.h"

/// Every file in bad/ breaks one rule (twelve_mistakes.json: twelve). The messages that it must
/// give, all of them and no other, stand beside it in a file that ends in `.expected`.
namespace hearth {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = test::inTree("tests/load/bad");

std::vector<std::string> linesOf(const fs::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> messagesOf(const LoadResult& result) {
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : result.diagnostics) messages.push_back(format(diagnostic));
  return messages;
}

class BadFile : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { fs::current_path(kFolder); }  // messages name files as they were given
};

TEST_P(BadFile, givesItsMessages) {
  const LoadResult result = loadLevel(GetParam() + ".json");
  EXPECT_EQ(messagesOf(result), linesOf(GetParam() + ".expected"));
  const bool hasError = std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                                    [](const Diagnostic& d) { return d.isError; });
  EXPECT_EQ(result.loaded.has_value(), !hasError);
}

std::vector<std::string> names() {
  std::vector<std::string> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder))
    if (entry.path().extension() == ".expected") found.push_back(entry.path().stem().string());
  std::sort(found.begin(), found.end());
  return found;
}

INSTANTIATE_TEST_SUITE_P(Load, BadFile, testing::ValuesIn(names()),
                         [](const auto& parameter) { return parameter.param; });

TEST(BadFiles, allHaveTheirMessagesBesideThem) {
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".json" || path.stem().extension() == ".lights") continue;
    EXPECT_TRUE(fs::exists(fs::path(path).replace_extension(".expected"))) << path;
  }
}

}  // namespace
}  // namespace hearth
