#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "cli/command.h"
#include "inputs/inputs.h"
#include "lint/lint.h"

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

/// No finding, as windows and roofs are seen and not entered; but the author of a stair shall see
/// that nobody can go up.
void tellWhereNobodyComes(const Scene& scene) {
  constexpr std::size_t kNamed = 3;
  const std::vector<SectorId> sectors = outOfReach(scene);
  if (sectors.empty()) return;
  std::vector<std::string> names;
  for (const SectorId sector : std::span(sectors).first(std::min(kNamed, sectors.size())))
    names.push_back(fmt::format("\"{}\"", scene[sector].name));
  if (sectors.size() > kNamed) names.push_back(fmt::format("{} others", sectors.size() - kNamed));
  const std::size_t all = scene.level().sectors.size();
  fmt::print(stderr, "on foot the player comes to {} of {} sectors, not to {}\n",
             all - sectors.size(), all, fmt::join(names, ", "));
}

ExitStatus judge(bool isClean, const OptionValues& values) {
  if (isClean && !values.has(Option::Quiet)) fmt::print(stderr, "no findings\n");
  return isClean ? ExitStatus::Done : ExitStatus::Differs;
}

ExitStatus runLint(const OptionValues& values) {
  const OpenedLevel opened = loadLevelOf(values);
  const std::vector<Diagnostic>& ofLoader = opened.result.diagnostics;
  if (!opened.result.loaded) {
    printDiagnostics(ofLoader);
    return ExitStatus::BadInput;
  }
  const LintedLevel linted{*opened.result.loaded, opened.source};
  const auto settings = bakeSettingsFor(linted.scene(), values);
  if (!settings) return fail(settings.error());

  print(ofLoader);
  // No author wrote the level and the lights that are made for a model.
  if (opened.model) return judge(ofLoader.empty(), values);
  const std::vector<Diagnostic> ofGeometry = lintGeometry(linted);
  print(ofGeometry);
  const auto light = lightFor(linted.scene(), values);
  if (!light) return fail(light.error());
  const Level dimmedLevel = dimmed(linted.level());
  const auto dimmedLight = lightFor({dimmedLevel, linted.loaded.geometry}, values);
  if (!dimmedLight) return fail(dimmedLight.error());
  const std::vector<Diagnostic> ofLight =
      lintLight(linted, *light, *dimmedLight, *settings, threadsFrom(values));
  print(ofLight);
  const ExitStatus status =
      judge(ofLoader.empty() && ofGeometry.empty() && ofLight.empty(), values);
  if (!values.has(Option::Quiet)) tellWhereNobodyComes(linted.scene());
  return status;
}

}  // namespace

Command lintCommand() {
  return {"lint",
          "finds what the loader takes, and the author hardly meant",
          std::vector<Option>{Option::NoCache, Option::Quiet, Option::Threads} + limitOptions(),
          {},
          runLint,
          LevelFiles::One,
          kindsInWords()};
}

}  // namespace hearth
