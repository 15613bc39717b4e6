#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "settings/options.h"

namespace hearth {

/// `--max-file-bytes`, or its default.
std::uint64_t maxFileBytes(const OptionValues& values);

/// All bytes of a file of no more than `--max-file-bytes`: see readFile. Errors are one sentence
/// that begins with the path.
tl::expected<std::string, std::string> readWithinLimit(const std::filesystem::path& path,
                                                       const OptionValues& values);

}  // namespace hearth
