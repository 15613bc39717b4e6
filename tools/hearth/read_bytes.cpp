#include "hearth/read_bytes.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <system_error>

#include "load/limits.h"

namespace hearth {

tl::expected<std::string, std::string> readBytes(const std::filesystem::path& path,
                                                 const OptionValues& values) {
  const auto failure = [&](std::string_view what) {
    return tl::unexpected(fmt::format("{}: {}", path.string(), what));
  };
  const auto maxBytes = static_cast<std::uint64_t>(
      values.number(Option::MaxFileBytes).value_or(static_cast<double>(LoadLimits{}.fileBytes)));
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return failure("there is no such file");
  if (!std::filesystem::is_regular_file(path, error)) return failure("is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return failure(error.message());
  if (size > maxBytes)
    return failure(fmt::format("{} bytes are more than {}: raise the limit with {}", size, maxBytes,
                               row(Option::MaxFileBytes).name));
  std::string bytes(size, '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(size)))
    return failure("cannot be read: make it readable");
  return bytes;
}

}  // namespace hearth
