#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <span>

#include "cli/check/check_level.h"
#include "cli/check/check_page.h"
#include "cli/check/golden_picture.h"
#include "cli/command.h"

namespace hearth {

namespace {

/// Without lights files that stand beside a level of the list, and schemas: `levels/*.json` names
/// them, too.
std::vector<std::string> levelsAmong(const std::vector<std::string>& files) {
  std::vector<std::string> levels;
  for (const std::string& file : files) {
    const auto isLightsOf = [&](const std::string& level) {
      return std::filesystem::path(level).replace_extension(".lights.json") == file;
    };
    if (!file.ends_with(".schema.json") && std::ranges::none_of(files, isLightsOf))
      levels.push_back(file);
  }
  return levels;
}

std::optional<std::string> mistakeIn(const std::vector<std::string>& levels,
                                     const OptionValues& values) {
  if (const auto report = values.text(Option::Report))
    if (std::filesystem::path(*report).extension() != ".html")
      return fmt::format("--report: {}: a report is written as a .html page only", *report);
  std::map<std::filesystem::path, std::string> owners;
  for (const std::string& level : levels) {
    const auto folder = goldenFolders(level, values.text(Option::Golden)).golden;
    const auto [other, isNew] =
        owners.emplace(std::filesystem::absolute(folder).lexically_normal(), level);
    if (!isNew)
      return fmt::format("{} and {} would share the golden pictures in {}", other->second, level,
                         folder.string());
  }
  return std::nullopt;
}

ExitStatus writePage(const std::filesystem::path& path, std::span<const LevelFindings> levels) {
  const auto written = writeCheckPage(path, levels);
  if (!written) return fail(written.error());
  const auto isAsKept = [](const LevelFindings& level) { return level.status == ExitStatus::Done; };
  if (!std::ranges::all_of(levels, isAsKept)) fmt::print("look at {}\n", path.string());
  return ExitStatus::Done;
}

/// Bad input of one level does not keep the others from being checked.
ExitStatus runCheck(const OptionValues& values) {
  const std::vector<std::string> levels = levelsAmong(values.levels);
  if (const auto mistake = mistakeIn(levels, values)) return fail(*mistake);
  const std::optional<std::string> report = values.text(Option::Report);
  ExitStatus worst = ExitStatus::Done;
  std::vector<LevelFindings> all;
  for (const std::string& level : levels) {
    OptionValues ofLevel = values;
    ofLevel.level = level;
    const LevelFindings& findings = all.emplace_back(checkLevel(ofLevel));
    worst = std::max(worst, findings.status);
    if (!report && findings.status == ExitStatus::Differs)
      worst = std::max(worst, writePage(findings.page, {&findings, 1}));
  }
  const bool isAnyChecked =
      std::ranges::any_of(all, [](const LevelFindings& found) { return !found.shots.empty(); });
  if (report && isAnyChecked) worst = std::max(worst, writePage(*report, all));
  return worst;
}

}  // namespace

Command checkCommand() {
  return {"check",
          "bakes, draws every shot and compares it with its golden picture",
          std::vector<Option>{Option::Golden, Option::Update, Option::Report, Option::MoverStages} +
              lightOptions(),
          {},
          runCheck,
          LevelFiles::Several};
}

}  // namespace hearth
