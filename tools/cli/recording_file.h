#pragma once

#include <string>
#include <tl/expected.hpp>

#include "settings/options.h"
#include "walk/recording.h"

namespace hearth {

/// The recording that `--replay` names. Errors say file and line.
tl::expected<Recording, std::string> readReplay(const OptionValues& values);

/// Writes the file whole or not at all. Errors are one sentence that begins with the path.
tl::expected<void, std::string> writeRecordingFile(const std::string& path,
                                                   const Recording& recording);

}  // namespace hearth
