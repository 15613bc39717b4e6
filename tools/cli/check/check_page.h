#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "cli/check/check_level.h"

namespace hearth {

/// Writes the findings as one HTML page that contains its pictures. A slider blends an expected and
/// an actual picture. Pictures are copied through, never held in memory.
tl::expected<void, std::string> writeCheckPage(const std::filesystem::path& path,
                                               std::span<const LevelFindings> levels);

}  // namespace hearth
