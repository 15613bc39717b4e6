#include "places.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/level_text.h"

namespace hearth::test {

namespace {

constexpr int kThreads = 2;

std::vector<std::string> placesOf(const std::vector<Diagnostic>& findings) {
  std::vector<std::string> places;
  for (const Diagnostic& finding : findings) {
    EXPECT_FALSE(finding.isError);
    places.push_back(
        fmt::format("{}:{} {} [{}]", finding.line, finding.column, finding.pointer, finding.kind));
  }
  return places;
}

std::vector<Diagnostic> findingsOf(GeometryLint lint, std::string_view levelText) {
  const SourcedResult sourced = levelWithSourceFrom(levelText);
  Findings findings;
  lint({*sourced.result.loaded, sourced.source}, findings);
  return findings.resolve(sourced.source.documents);
}

}  // namespace

std::vector<std::string> placesOf(GeometryLint lint, std::string_view levelText) {
  return placesOf(findingsOf(lint, levelText));
}

std::vector<std::string> placesInLight(std::string_view levelText, std::string_view lightsText) {
  const SourcedResult sourced = levelWithSourceFrom(levelText, lightsText);
  const LintedLevel linted{*sourced.result.loaded, sourced.source};
  const BakeSettings& settings = linted.level().bake;
  const auto baked = [&](const Scene& scene) { return bake(scene, settings, kThreads); };
  const Level dimmedLevel = dimmed(linted.level());
  return placesOf(lintLight(linted, baked(linted.scene()),
                            baked({dimmedLevel, linted.loaded.geometry}), settings, kThreads));
}

std::string firstMessage(GeometryLint lint, std::string_view levelText) {
  const std::vector<Diagnostic> findings = findingsOf(lint, levelText);
  return findings.empty() ? "" : findings.front().message;
}

std::vector<std::string> advicesOf(GeometryLint lint, std::string_view levelText) {
  std::vector<std::string> advices;
  for (const Diagnostic& finding : findingsOf(lint, levelText)) advices.push_back(finding.advice);
  return advices;
}

std::string with(std::string_view text, std::string_view part, std::string_view replacement) {
  std::string result(text);
  const std::size_t at = result.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  EXPECT_EQ(result.find(part, at + 1), std::string::npos) << part;
  return result.replace(at, part.size(), replacement);
}

}  // namespace hearth::test
