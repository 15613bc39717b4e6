#pragma once

#include <filesystem>

namespace hearth {

/// A new folder, which the destructor removes with all its files. It lies on the system's memory
/// disk if there is one, so that measurements do not include a disk.
class TemporaryFolder {
 public:
  /// Throws std::system_error if it cannot be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace hearth
