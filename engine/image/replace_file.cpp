#include "image/replace_file.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace hearth {
namespace {

tl::unexpected<std::string> failure(const std::filesystem::path& path, const std::string& what) {
  return tl::make_unexpected(fmt::format("{}: {}", path.string(), what));
}

}  // namespace

tl::expected<void, std::string> replaceFile(const std::filesystem::path& path,
                                            const std::function<bool(std::ostream&)>& write) {
  std::error_code error;
  const std::filesystem::file_status target = std::filesystem::status(path, error);
  if (std::filesystem::exists(target) && !std::filesystem::is_regular_file(target)) {
    return failure(path, "is not a regular file; name a file to write");
  }
  // Through a symbolic link, so that the link stays and what it names is replaced.
  const std::filesystem::path file =
      std::filesystem::exists(target) ? std::filesystem::canonical(path, error) : path;
  std::filesystem::path part = file;
  part += ".part";
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  const bool isWritten = write(stream);
  stream.close();
  if (!isWritten || !stream.good()) {
    std::filesystem::remove(part, error);
    return failure(path, "cannot be written; check that its folder exists and has room");
  }
  if (std::filesystem::exists(target))
    std::filesystem::permissions(part, target.permissions(), error);
  std::filesystem::rename(part, file, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(part, error);
    return failure(path, fmt::format("cannot be written: {}", reason));
  }
  return {};
}

}  // namespace hearth
