#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "hearth/options.h"

namespace hearth {

/// All bytes of a regular file: reading from a pipe may wait for ever. Files longer than
/// `--max-file-bytes` are refused before memory is taken. Errors are one sentence that begins with
/// the path.
tl::expected<std::string, std::string> readBytes(const std::filesystem::path& path,
                                                 const OptionValues& values);

}  // namespace hearth
