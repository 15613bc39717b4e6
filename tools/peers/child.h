#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

/// Other programs, and what they take.
namespace hearth {

/// A program that is run in silence.
struct Child {
  std::vector<std::string> words;             ///< the program, found on the PATH, and its arguments
  std::filesystem::path folder;               ///< in which it runs
  std::vector<std::string> environment = {};  ///< NAME=VALUE, before those of this program
};

struct ChildTimes {
  double seconds = 0;      ///< from its start to its end
  double userSeconds = 0;  ///< of processors, in the program itself and not in the system
};

/// The error says how it ended.
tl::expected<ChildTimes, std::string> timesOf(const Child& child);

/// Bytes of memory that it held at most. It is looked at every millisecond: what it takes in its
/// last one is not seen.
tl::expected<std::int64_t, std::string> peakOf(const Child& child);

/// The program `hearth`, which lies beside this one.
std::filesystem::path hearthProgram();

}  // namespace hearth
