#include "files/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace hearth {
namespace {

struct FileClose {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, FileClose>;

tl::unexpected<ReadError> failure(ReadErrorCode code, std::string what) {
  return tl::make_unexpected(ReadError{code, std::move(what)});
}

bool isSame(const struct stat& a, const struct stat& b) {
  return a.st_size == b.st_size && a.st_mtim.tv_sec == b.st_mtim.tv_sec &&
         a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

}  // namespace

tl::unexpected<ReadError> readErrorFromErrno(int reason) {
  if (reason == ENOENT || reason == ENOTDIR) return failure(ReadErrorCode::Missing, "no such file");
  return failure(ReadErrorCode::Failed,
                 "cannot be read: " + std::error_code(reason, std::generic_category()).message());
}

tl::expected<std::string, ReadError> readFile(const std::filesystem::path& path,
                                              std::uint64_t maxBytes) {
  // Not to wait for the other end of a pipe.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return readErrorFromErrno(errno);
  const OpenFile file(::fdopen(descriptor, "rb"));
  if (!file) {
    const int reason = errno;
    ::close(descriptor);
    return readErrorFromErrno(reason);
  }
  struct stat before {};
  if (::fstat(descriptor, &before) != 0) return readErrorFromErrno(errno);
  if (!S_ISREG(before.st_mode)) return failure(ReadErrorCode::NotRegular, "not a regular file");
  const auto size = static_cast<std::uint64_t>(before.st_size);
  if (size > maxBytes)
    return failure(ReadErrorCode::TooLong,
                   fmt::format("{} bytes are more than {}", size, maxBytes));
  std::string bytes(size, '\0');
  const bool isWhole = std::fread(bytes.data(), 1, size, file.get()) == size;
  if (std::ferror(file.get()) != 0) return readErrorFromErrno(errno);
  struct stat after {};
  if (::fstat(descriptor, &after) != 0) return readErrorFromErrno(errno);
  if (!isWhole || !isSame(before, after))
    return failure(ReadErrorCode::Changed, "was changed while it was read");
  return bytes;
}

}  // namespace hearth
