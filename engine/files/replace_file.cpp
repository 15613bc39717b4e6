#include "files/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

namespace hearth {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kUsualPermissions = 0666;  // less the user's umask

tl::unexpected<std::string> failure(const fs::path& path, const std::string& what) {
  return tl::make_unexpected(fmt::format("{}: {}", path.string(), what));
}

/// With the system's reason, as far as there is one.
tl::unexpected<std::string> notWritten(const fs::path& path, int reason) {
  return failure(path, reason == 0
                           ? "cannot be written"
                           : "cannot be written: " +
                                 std::error_code(reason, std::generic_category()).message());
}

/// A file that is being written, by this program alone. Where it fails, `errno` says why.
class Part {
 public:
  /// What a killed program left keeps its permissions.
  Part(fs::path path, mode_t permissions) : path_(std::move(path)) {
    do {
      close();
      open(permissions);
      lock();
    } while (file_ >= 0 && isTakenAway());
  }
  ~Part() { close(); }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  const fs::path& path() const { return path_; }

  bool setPermissions(mode_t permissions) {
    return file_ >= 0 && ::fchmod(file_, permissions) == 0;
  }

  bool fill(const FileWriter& write) {
    if (file_ < 0 || ::ftruncate(file_, 0) != 0) return false;
    errno = 0;
    std::ofstream stream(path_, std::ios::binary | std::ios::in | std::ios::out);
    const bool isWritten = stream.is_open() && write(stream);
    stream.close();
    // Without fsync, a power failure could leave the new name with no content.
    return isWritten && stream.good() && ::fsync(file_) == 0;
  }

  /// Removes the file if it was opened: no other of its name, unless files cannot be locked.
  void remove() {
    if (file_ >= 0) ::unlink(path_.c_str());
  }

 private:
  void open(mode_t permissions) {
    const auto tryToOpen = [&] {
      file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC,
                     permissions);
    };
    tryToOpen();
    if (file_ >= 0 || errno != EACCES) return;
    // A program that was killed just before it renamed the file may have left it read-only.
    if (::fchmodat(AT_FDCWD, path_.c_str(), S_IRUSR | S_IWUSR, AT_SYMLINK_NOFOLLOW) == 0)
      tryToOpen();
    else
      errno = EACCES;
  }

  /// Where files cannot be locked, writers do not wait for one another.
  void lock() const {
    while (file_ >= 0 && ::flock(file_, LOCK_EX) != 0 && errno == EINTR) continue;
  }

  /// Another process held the lock, and has renamed or removed the file.
  bool isTakenAway() const {
    struct stat opened {};
    struct stat named {};
    return ::fstat(file_, &opened) == 0 &&
           (::stat(path_.c_str(), &named) != 0 || opened.st_ino != named.st_ino ||
            opened.st_dev != named.st_dev);
  }

  void close() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

  fs::path path_;
  int file_ = -1;
};

/// Renames the file, unless there is one of that name. Some file systems lack RENAME_NOREPLACE,
/// others lack hard links.
bool renameToNew(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;
  return ::link(from.c_str(), to.c_str()) == 0 && ::unlink(from.c_str()) == 0;
}

fs::path partOf(fs::path file) { return file += ".tmp"; }

}  // namespace

tl::expected<void, std::string> replaceFile(const fs::path& path, const FileWriter& write) {
  std::error_code error;
  const fs::file_status target = fs::status(path, error);
  const bool isThere = fs::exists(target);
  if (isThere && !fs::is_regular_file(target))
    return failure(path, "is not a regular file; name a file to write");
  fs::path file = path;
  if (isThere) {
    // Through a symbolic link, so that the link stays and what it names is replaced. A link that
    // leads nowhere is itself replaced.
    file = fs::canonical(path, error);
    if (error) return notWritten(path, error.value());
  }
  const auto permissions = static_cast<mode_t>(target.permissions());
  const mode_t whileFilled = isThere ? permissions | S_IWUSR : kUsualPermissions;
  Part part(partOf(file), whileFilled);
  const bool isDone = (!isThere || part.setPermissions(whileFilled)) && part.fill(write) &&
                      (!isThere || part.setPermissions(permissions)) &&
                      ::rename(part.path().c_str(), file.c_str()) == 0;
  if (isDone) return {};
  const int reason = errno;
  part.remove();
  return notWritten(path, reason);
}

tl::expected<bool, std::string> createFile(const fs::path& path, const FileWriter& write) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(path, error))) return false;
  Part part(partOf(path), kUsualPermissions);
  if (part.fill(write) && renameToNew(part.path(), path)) return true;
  const int reason = errno;
  part.remove();
  if (reason == EEXIST) return false;
  return notWritten(path, reason);
}

}  // namespace hearth
