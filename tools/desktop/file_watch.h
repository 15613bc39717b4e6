#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace hearth {

/// Detects written files (inotify(7)): once their writer has closed them or moved them into place,
/// so that none is read half-written.
class FileWatch {
 public:
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Watches these from now on, and the folders in which they lie.
  void watch(const std::vector<std::filesystem::path>& files);

  struct Changes {
    std::set<std::size_t> watched;  ///< indices of the files
    bool other = false;             ///< any other file of the folders
  };
  /// Since the last call.
  Changes changes();

 private:
  void watchFolder(const std::filesystem::path& folder);

  int events_;                                    ///< a file descriptor; -1: nothing can be watched
  std::map<int, std::filesystem::path> folders_;  ///< by the kernel's numbers
  std::map<std::filesystem::path, std::size_t> files_;
};

}  // namespace hearth
