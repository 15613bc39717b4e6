#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "cli/check/check_level.h"

namespace hearth {

/// Writes the findings as one HTML page that needs no other file: the pictures are inside. Where
/// there are an expected and an actual picture, a slider goes from one to the other. Pictures are
/// copied through, never held.
tl::expected<void, std::string> writeCheckPage(const std::filesystem::path& path,
                                               std::span<const LevelFindings> levels);

}  // namespace hearth
