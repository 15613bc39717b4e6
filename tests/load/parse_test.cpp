#include "load/json/parse.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace hearth {
namespace {

/// A text as a tree, and all that was said about it.
struct Parsed {
  std::array<Document, 1> documents;
  bool isGood = false;
  std::vector<Diagnostic> diagnostics;

  JsonValue root() const { return {documents[0], 0, 0}; }
};

Parsed parsed(std::string text) {
  Parsed result;
  result.documents[0].file = "f";
  result.documents[0].text = std::move(text);
  Report report;
  result.isGood = parse(result.documents[0], 0, report);
  result.diagnostics = report.resolve(result.documents);
  return result;
}

/// "LINE:COLUMN POINTER" of every node of a text, in order.
std::vector<std::string> placesIn(const Parsed& text) {
  Report report;
  for (const JsonNode& node : text.documents[0].nodes) report.error({0, node.offset}, "", "");
  std::vector<std::string> places;
  for (const Diagnostic& d : report.resolve(text.documents))
    places.push_back(std::to_string(d.line) + ":" + std::to_string(d.column) + " " + d.pointer);
  return places;
}

std::string onlyMessage(const Parsed& text) {
  EXPECT_EQ(text.diagnostics.size(), 1U);
  return text.diagnostics.empty() ? "" : format(text.diagnostics[0]);
}

TEST(Parse, knowsThePlaceOfEveryKindOfValueAndKey) {
  const Parsed text = parsed("{\"a\" : [1,-2.5e+1 ,\"s\\\"]\" ,\n  true,false, null],\n\"b\":{ }}");
  ASSERT_TRUE(text.isGood);
  EXPECT_EQ(placesIn(text), (std::vector<std::string>{
                                "1:1 ", "1:2 /a", "1:8 /a", "1:9 /a/0", "1:11 /a/1", "1:20 /a/2",
                                "2:3 /a/3", "2:8 /a/4", "2:15 /a/5", "3:1 /b", "3:5 /b"}));
}

TEST(Parse, countsColumnsInBytesAndEscapesPointers) {
  const Parsed text = parsed("{\"\xC3\xA4/~\": 7}");
  EXPECT_EQ(placesIn(text),
            (std::vector<std::string>{"1:1 ", "1:2 /\xC3\xA4~1~0", "1:10 /\xC3\xA4~1~0"}));
}

TEST(Parse, findsANumberThatEndsTheText) {
  const Parsed text = parsed("\n 12.5");
  ASSERT_TRUE(text.isGood);
  EXPECT_EQ(text.root().number(), 12.5);
  EXPECT_EQ(placesIn(text), std::vector<std::string>{"2:2 "});
}

TEST(Parse, leavesOutWhatStandsUnderCommentKeys) {
  const Parsed text = parsed(
      "{\"//\": [{\"x\": 1, \"x\": 2}], \"$schema\": \"s\", \"//\": 3, \"// b\": {}, \"c\": 4}");
  ASSERT_TRUE(text.isGood);
  EXPECT_TRUE(text.diagnostics.empty());
  ASSERT_EQ(text.root().members().size(), 1U);
  EXPECT_EQ(text.root().members()[0].key.text(), "c");
  EXPECT_EQ(text.root().members()[0].value.number(), 4);
}

TEST(Parse, makesPositiveZeroOfNegative) {
  const Parsed text = parsed("[-0, -0.0, -0e5]");
  for (const JsonValue zero : text.root().elements()) EXPECT_FALSE(std::signbit(zero.number()));
}

TEST(Parse, reportsDuplicateKeysAtTheLaterOneAndGoesOn) {
  const Parsed text = parsed("{\"a\": 1,\n \"b\": {\"c\": 1, \"c\": 2},\n \"a\": 3}");
  EXPECT_TRUE(text.isGood);
  ASSERT_EQ(text.diagnostics.size(), 2U);
  EXPECT_EQ(format(text.diagnostics[0]),
            "f:2:16: error: the key \"c\" is given twice, at /b/c, remove or rename one of them");
  EXPECT_EQ(format(text.diagnostics[1]),
            "f:3:2: error: the key \"a\" is given twice, at /a, remove or rename one of them");
}

TEST(Parse, takes64LevelsOfNestingAndNotOneMore) {
  EXPECT_TRUE(parsed(std::string(64, '[') + std::string(64, ']')).isGood);
  const Parsed text = parsed(std::string(65, '[') + std::string(65, ']'));
  EXPECT_FALSE(text.isGood);
  EXPECT_EQ(text.diagnostics[0].column, 65);
  EXPECT_FALSE(parsed("{\"//\": " + std::string(64, '[') + std::string(64, ']') + "}").isGood);
}

TEST(Parse, placesAnUnexpectedCommaOrColonAtItself) {
  EXPECT_EQ(parsed("[ , 1]").diagnostics[0].column, 3);
  EXPECT_EQ(parsed("[1 : 2]").diagnostics[0].column, 4);
  EXPECT_EQ(parsed("[1,, 2]").diagnostics[0].column, 4);
  EXPECT_EQ(parsed("{\"a\", 1}").diagnostics[0].column, 5);
}

TEST(Parse, placesAnUnexpectedEndAtTheEnd) {
  EXPECT_EQ(
      onlyMessage(parsed("{\"a\": [1, 2\n")),
      "f:2:1: error: not valid JSON: unexpected end of input; expected ']', at /a, close what "
      "begins in line 1 first");
}

TEST(Parse, refusesAZeroByteWhereverItStands) {
  EXPECT_FALSE(parsed(std::string("{}\0{}", 5)).isGood);
  EXPECT_FALSE(parsed(std::string("{}\0", 3)).isGood);
  EXPECT_FALSE(parsed(std::string("[\0]", 3)).isGood);
}

TEST(Parse, showsControlCharactersOfKeysAsEscapes) {
  const Parsed text = parsed("{\"a\\nb\": 1, \"a\\nb\": 1}");
  EXPECT_EQ(onlyMessage(text).find('\n'), std::string::npos);
}

}  // namespace
}  // namespace hearth
