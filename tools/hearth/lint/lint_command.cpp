#include <fmt/format.h>

#include <cstdio>

#include "hearth/command.h"
#include "hearth/lint/lint.h"
#include "hearth/session.h"

namespace hearth {

namespace {

void print(std::span<const Diagnostic> findings) {
  for (const Diagnostic& finding : findings) fmt::print("{}\n", format(finding));
}

std::string kindsInWords() {
  std::string text = "Each line ends with the kind of what was found:\n";
  for (const LoaderKindRow& row : kLoaderKinds)
    text += fmt::format("  {:<15} {}\n", row.name, row.help);
  for (const FindingKindRow& row : kFindingKinds)
    text += fmt::format("  {:<15} {}\n", row.name, row.help);
  return text;
}

ExitStatus run(const OptionValues& values) {
  const SourcedResult opened = loadLevelOf(values);
  const std::vector<Diagnostic>& ofLoader = opened.result.diagnostics;
  if (!opened.result.loaded) {
    tell(ofLoader);
    return ExitStatus::BadInput;
  }
  const LintedLevel linted{*opened.result.loaded, opened.source};
  const auto settings = bakeSettingsFor(linted.level(), values);
  if (!settings) return fail(settings.error());

  print(ofLoader);
  const std::vector<Diagnostic> ofGeometry = lintGeometry(linted);
  print(ofGeometry);
  const auto light = lightFor(dimmed(linted.level()), values);
  if (!light) return fail(light.error());
  const std::vector<Diagnostic> ofLight = lintLight(linted, *light, *settings, threadsFrom(values));
  print(ofLight);
  const bool isClean = ofLoader.empty() && ofGeometry.empty() && ofLight.empty();
  if (isClean && !values.has(Option::Quiet)) fmt::print(stderr, "no findings\n");
  return isClean ? ExitStatus::Done : ExitStatus::Differs;
}

}  // namespace

Command lintCommand() {
  return {"lint",
          "finds what the loader takes, and the author hardly meant",
          std::vector<Option>{Option::NoCache, Option::Quiet, Option::Threads} + limitOptions(),
          {},
          run,
          LevelFiles::One,
          kindsInWords()};
}

}  // namespace hearth
