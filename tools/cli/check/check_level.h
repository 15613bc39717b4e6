#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"

namespace hearth {

/// What a check found out about one shot, or about a golden picture that no shot draws.
struct ShotFinding {
  std::string shot;
  bool isAsKept;        ///< from now on: so is what was accepted
  std::string words;    ///< a sentence without its full stop
  std::string command;  ///< draws the shot; empty where none does, or no picture is kept
  // What there is to look at.
  std::optional<std::filesystem::path> expected = {};
  std::optional<std::filesystem::path> actual = {};
  std::optional<std::filesystem::path> difference = {};  ///< amplified
};

struct LevelFindings {
  std::string level;
  ExitStatus status;
  std::vector<ShotFinding> shots;  ///< empty when the level could not be checked
  std::string acceptCommand;       ///< keeps the pictures as they are drawn now
  std::filesystem::path page;      ///< that of a failed check: beside its pictures
};

/// Checks the level of `values`, or accepts what it draws, and prints what is not as kept: findings
/// to stdout, errors to stderr. Of a bad level nothing is written.
LevelFindings checkLevel(const OptionValues& values);

}  // namespace hearth
