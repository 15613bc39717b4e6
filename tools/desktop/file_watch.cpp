#include "desktop/file_watch.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstddef>
#include <cstring>
#include <system_error>

namespace hearth {

namespace {

namespace fs = std::filesystem;

/// As `folder / name` of what the kernel tells is written.
fs::path inFullWords(const fs::path& file) {
  std::error_code error;
  const fs::path folder =
      fs::weakly_canonical(file.parent_path().empty() ? "." : file.parent_path(), error);
  return (error ? file.parent_path() : folder) / file.filename();
}

}  // namespace

FileWatch::FileWatch() : events_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}

FileWatch::~FileWatch() {
  if (events_ >= 0) ::close(events_);
}

void FileWatch::watch(const std::vector<fs::path>& files) {
  files_.clear();
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::error_code error;
    // By its own name and, of a link, by that of what is written through it.
    for (const fs::path& name : {inFullWords(files[i]), fs::weakly_canonical(files[i], error)}) {
      files_.emplace(name, i);
      watchFolder(name.parent_path());
    }
  }
}

void FileWatch::watchFolder(const fs::path& folder) {
  constexpr std::uint32_t kWritten = IN_CLOSE_WRITE | IN_MOVED_TO;
  if (events_ < 0) return;
  // The number of a folder that is watched already is the same again.
  const int number = ::inotify_add_watch(events_, folder.c_str(), kWritten);
  if (number >= 0) folders_[number] = folder;
}

FileWatch::Changes FileWatch::changes() {
  Changes changes;
  alignas(inotify_event) std::array<char, 16 * (sizeof(inotify_event) + NAME_MAX + 1)> bytes;
  while (events_ >= 0) {
    const ssize_t count = ::read(events_, bytes.data(), bytes.size());
    if (count <= 0) break;
    for (std::size_t at = 0; at < static_cast<std::size_t>(count);) {
      inotify_event event;
      std::memcpy(&event, &bytes[at], sizeof event);
      const fs::path file = folders_[event.wd] / (event.len > 0 ? &bytes[at + sizeof event] : "");
      at += sizeof event + event.len;
      if (const auto found = files_.find(file); found != files_.end())
        changes.watched.insert(found->second);
      else
        changes.other = true;
    }
  }
  return changes;
}

}  // namespace hearth
