#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "hearth/options.h"

namespace hearth {

/// All bytes of a file of no more than `--max-file-bytes`: see readFile. Errors are one sentence
/// that begins with the path.
tl::expected<std::string, std::string> readBytes(const std::filesystem::path& path,
                                                 const OptionValues& values);

}  // namespace hearth
