#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"

namespace hearth {

/// The result of a check of one shot, or of a golden picture without a shot.
struct ShotFinding {
  std::string shot;
  bool isAsKept;        ///< from now on: accepted pictures are, too
  std::string words;    ///< a sentence without its full stop
  std::string command;  ///< draws the shot; empty if no command does, or no picture is kept
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

/// Checks the level of `values`, or accepts its pictures, and prints differences from those that
/// are kept: findings to stdout, errors to stderr. For a bad level nothing is written.
LevelFindings checkLevel(const OptionValues& values);

}  // namespace hearth
