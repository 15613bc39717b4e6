#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "hearth/comfort/comfort.h"
#include "load/diagnostic.h"

/// The user's file of settings, which tools/README.md describes.
namespace hearth {

struct Config {
  Comfort comfort = {};
  std::vector<Diagnostic> warnings = {};
};

/// What is wrong in the file is told, and the rest of it holds. All is as by default where there is
/// no file.
Config readConfig(const std::filesystem::path& file);

/// Writes what of `after` differs from `before` into the file, and leaves all else of it to the
/// byte. Makes the file and its folder where they are missing. Errors are one sentence that begins
/// with the path.
tl::expected<void, std::string> writeConfig(const std::filesystem::path& file,
                                            const Comfort& before, const Comfort& after);

}  // namespace hearth
