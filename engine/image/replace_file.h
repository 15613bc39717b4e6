#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <tl/expected.hpp>

namespace hearth {

/// Replaces a file by what `write` puts out. It is written beside the target (with `.part` at the
/// end of its name) and renamed, so that no reader sees half a file and a failure leaves the old
/// one. Permissions stay as they were. `write` says whether it could. Errors are one sentence that
/// begins with the path.
tl::expected<void, std::string> replaceFile(const std::filesystem::path& path,
                                            const std::function<bool(std::ostream&)>& write);

}  // namespace hearth
