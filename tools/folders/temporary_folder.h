#pragma once

#include <filesystem>

namespace hearth {

/// A new folder, gone with all that is in it when this is. In memory where the system has a disk
/// there, so that no disk is measured.
class TemporaryFolder {
 public:
  /// Throws std::system_error where none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace hearth
