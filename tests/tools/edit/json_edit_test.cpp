// Edits of JSON that leave all the rest as it is spelled.

#include "text/json_edit.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace hearth {
namespace {

constexpr std::array<std::string_view, 1> kA{"a"};
constexpr std::array<std::string_view, 2> kAB{"a", "b"};

TEST(JsonEdit, ReplacesAValueAndNothingElse) {
  EXPECT_EQ(withValueAt("{ \"//\": 1,\n\"a\" :[1, {\"a\": 2}] ,\"c\":1.50}", kA, "7"),
            "{ \"//\": 1,\n\"a\" :7 ,\"c\":1.50}");
  EXPECT_EQ(withValueAt("{\"b\": 1, \"a\": {\"b\": \"x\\\"}\"}}\r\n", kAB, "true"),
            "{\"b\": 1, \"a\": {\"b\": true}}\r\n");
}

TEST(JsonEdit, AddsAMemberAsItsNeighboursStand) {
  EXPECT_EQ(withValueAt("{\n  \"x\": 1,\n\n  \"y\": [2]\n}\n", kA, "3"),
            "{\n  \"x\": 1,\n\n  \"y\": [2],\n  \"a\": 3\n}\n");
  EXPECT_EQ(withValueAt("{\r\n  \"x\": 1\r\n}", kA, "3"), "{\r\n  \"x\": 1,\r\n  \"a\": 3\r\n}");
  EXPECT_EQ(withValueAt("{ \"a\": { \"//\": 1 } }", kAB, "2"),
            "{ \"a\": { \"//\": 1, \"b\": 2 } }");
  EXPECT_EQ(withValueAt("{\"x\":1}", kA, "2"), "{\"x\":1, \"a\": 2}");
}

TEST(JsonEdit, MakesWhatIsMissingOnTheWay) {
  EXPECT_EQ(withValueAt("{ }", kAB, "2"), "{ \"a\": { \"b\": 2 } }");
  EXPECT_EQ(withValueAt("{ \"a\": 5 }", kAB, "2"), "{ \"a\": { \"b\": 2 } }");
}

TEST(JsonEdit, AppendsToAnArray) {
  EXPECT_EQ(withElementIn("{ \"a\": [ ] }", "a", "z", "1"), "{ \"a\": [1] }");
  EXPECT_EQ(withElementIn("{ \"a\": [{ \"b\": [2] }] }", "a", "z", "1"),
            "{ \"a\": [{ \"b\": [2] }, 1] }");
  EXPECT_EQ(withElementIn("{\n  \"a\": [\n    [1]\n  ]\n}", "a", "z", "2"),
            "{\n  \"a\": [\n    [1],\n    2\n  ]\n}");
}

TEST(JsonEdit, MakesAnArrayInFrontOfItsFollower) {
  EXPECT_EQ(withElementIn("{\n  \"x\": 1,\n\n  \"z\": 2\n}", "a", "z", "3"),
            "{\n  \"x\": 1,\n\n  \"a\": [\n    3\n  ],\n  \"z\": 2\n}");
  EXPECT_EQ(withElementIn("{ \"z\": 2 }", "a", "z", "3"), "{ \"a\": [3], \"z\": 2 }");
  EXPECT_EQ(withElementIn("{ \"x\": 2 }", "a", "z", "3"), "{ \"x\": 2, \"a\": [3] }");
}

}  // namespace
}  // namespace hearth
