#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <tl/expected.hpp>

/// Files that are whole or not there. What is written goes into a file beside its target, with
/// `.tmp` at the end of its name, which is then renamed: no reader sees half a file, and a failure
/// leaves what there was. Programs that write the same file wait for one another. One that is
/// killed may leave its `.tmp`; the next to write that file overwrites it.
namespace hearth {

/// Puts a file out, and says whether it could.
using FileWriter = std::function<bool(std::ostream&)>;

/// Replaces a file, or makes it. Permissions stay as they were. Errors are one sentence that begins
/// with the path.
tl::expected<void, std::string> replaceFile(const std::filesystem::path& path,
                                            const FileWriter& write);

/// Makes a file; false where there is one of that name, which then stays as it is.
tl::expected<bool, std::string> createFile(const std::filesystem::path& path,
                                           const FileWriter& write);

}  // namespace hearth
