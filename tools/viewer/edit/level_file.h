#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "load/load.h"
#include "viewer/host/storage.h"

namespace hearth {

/// Replaces the text of a level's file by what `edited` makes of it. Refuses a file that has
/// changed since it was loaded. Errors are one sentence that begins with the path.
tl::expected<void, std::string> editLevelFile(
    Storage& storage, const LoadedLevel& loaded,
    const std::function<std::string(std::string_view)>& edited);

/// An error about that file.
tl::unexpected<std::string> levelFileError(const LoadedLevel& loaded, std::string_view what);

}  // namespace hearth
