#include "load/json/indentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "load/json/parse.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

/// Counted from 1.
std::ptrdiff_t lineAt(const std::string& text, std::size_t offset) {
  return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
}

/// "LINE open LINE", "LINE closed LINE" or "none".
std::string slipIn(const std::string& text) {
  const auto slip = findIndentationSlip(text);
  if (!slip) return "none";
  std::ostringstream words;
  words << lineAt(text, slip->line) << (slip->isOpen ? " open " : " closed ")
        << lineAt(text, slip->bracket);
  return words.str();
}

TEST(Indentation, TellsWhatIsStillOpenWhereALineStandsOutsideOfIt) {
  EXPECT_EQ(slipIn("{\n  \"a\": { \"b\": 1,\n  \"c\": 2\n}"), "3 open 2");
  EXPECT_EQ(slipIn("{\n  \"a\": {\n    \"b\": [1, 2\n  },\n  \"c\": 2\n}"), "4 open 3");
}

TEST(Indentation, TellsWhatHasClosedTooMuch) {
  EXPECT_EQ(slipIn("{\n  \"a\": {\n    \"b\": 1}\n  },\n  \"c\": 2\n}"), "4 closed 3");
  EXPECT_EQ(slipIn("{\n  \"a\": {\n    \"b\": []},\n    \"c\": 2\n  }\n}"), "4 closed 3");
}

TEST(Indentation, TakesWhatAuthorsDoWithoutMistake) {
  EXPECT_EQ(slipIn("{ \"a\": 1,\n  \"b\": [\n    1, 2,\n    3\n  ] }"), "none");
  EXPECT_EQ(slipIn("[\n  { \"a\": [\n      1,\n      2\n    ] },\n  {\n  }\n]"), "none");
  EXPECT_EQ(slipIn("{\n  \"a\":\n    { \"b\": 1 },\n  \"c\": \"}\\\"{\"\n}"), "none");
}

TEST(Indentation, SaysNothingOfTextsThatAreNotIndented) {
  EXPECT_EQ(slipIn("{\n\"a\": {\n\"b\": 1,\n\"c\": 2\n}"), "none");
  EXPECT_EQ(slipIn("{\"a\":{\"b\":1,\"c\":2}"), "none");
  EXPECT_EQ(slipIn(""), "none");
  EXPECT_EQ(slipIn("\""), "none");
}

/// The first thing that is said of a text, and where; nothing of one that is JSON.
std::string saidOf(const std::string& text) {
  std::array<Document, 1> documents;
  documents[0].file = "f";
  documents[0].text = text;
  Report report;
  parse(documents[0], 0, report);
  const std::vector<Diagnostic> said = report.resolve(documents);
  return said.empty() ? "" : format(said.front());
}

std::string tutorial() {
  std::ifstream in(test::inTree("levels/tutorial.json"), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Whether a message stands in or names the line, or one beside it.
bool leadsTo(const std::string& said, std::ptrdiff_t line) {
  for (std::ptrdiff_t near = line - 1; near <= line + 1; ++near)
    if (said.starts_with("f:" + std::to_string(near) + ":") ||
        said.find(" line " + std::to_string(near)) != std::string::npos)
      return true;
  return false;
}

TEST(Indentation, LeadsToEachClosingBracketThatIsMissingOrTooMuch) {
  const std::string text = tutorial();
  ASSERT_EQ(saidOf(text), "");
  int brackets = 0;
  for (std::size_t at = text.find_first_of("]}"); at != std::string::npos;
       at = text.find_first_of("]}", at + 1)) {
    const std::string missing = text.substr(0, at) + text.substr(at + 1);
    const std::string twice = text.substr(0, at) + text[at] + text.substr(at);
    EXPECT_TRUE(leadsTo(saidOf(missing), lineAt(text, at))) << lineAt(text, at) << saidOf(missing);
    EXPECT_TRUE(leadsTo(saidOf(twice), lineAt(text, at))) << lineAt(text, at) << saidOf(twice);
    ++brackets;
  }
  EXPECT_GT(brackets, 500);
}

}  // namespace
}  // namespace hearth
