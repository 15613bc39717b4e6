#include "inputs/read_within_limit.h"

#include <fmt/format.h>

#include "files/read_file.h"
#include "load/limits.h"

namespace hearth {

std::uint64_t maxFileBytes(const OptionValues& values) {
  return static_cast<std::uint64_t>(
      values.number(Option::MaxFileBytes).value_or(static_cast<double>(LoadLimits{}.fileBytes)));
}

tl::expected<std::string, std::string> readWithinLimit(const std::filesystem::path& path,
                                                       const OptionValues& values) {
  return readFile(path, maxFileBytes(values)).map_error([&](const ReadError& failure) {
    const bool isTooLong = failure.code == ReadErrorCode::TooLong;
    return fmt::format(
        "{}: {}{}", path.string(), failure.what,
        isTooLong ? fmt::format(": raise the limit with {}", row(Option::MaxFileBytes).name) : "");
  });
}

}  // namespace hearth
