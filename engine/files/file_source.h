#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "files/read_file.h"

namespace hearth {

enum class FileKind {
  None,  ///< there is no such file, or the source may not say
  Regular,
  Folder,
  Other,  ///< such as a pipe
};

/// Where the files of a level come from: the disk, or an archive, memory or a network that a
/// program gives. Paths are as the caller and the level give them, for example
/// "levels/../textures/a.png". Several threads call a source at once.
class FileSource {
 public:
  virtual ~FileSource() = default;

  virtual FileKind kindOf(const std::filesystem::path& path) const = 0;
  /// All bytes of a regular file. Longer files are refused before memory is taken.
  virtual tl::expected<std::string, ReadError> read(const std::filesystem::path& path,
                                                    std::uint64_t maxBytes) const = 0;
  /// Opens a regular file at its first byte. The stream can seek.
  virtual tl::expected<std::unique_ptr<std::istream>, ReadError> open(
      const std::filesystem::path& path) const = 0;
  /// The names of what lies in a folder, in any order; none where there is no such folder.
  virtual std::vector<std::filesystem::path> namesIn(const std::filesystem::path& folder) const = 0;
};

/// The machine's own files.
class DiskFiles final : public FileSource {
 public:
  FileKind kindOf(const std::filesystem::path& path) const override;
  tl::expected<std::string, ReadError> read(const std::filesystem::path& path,
                                            std::uint64_t maxBytes) const override;
  tl::expected<std::unique_ptr<std::istream>, ReadError> open(
      const std::filesystem::path& path) const override;
  std::vector<std::filesystem::path> namesIn(const std::filesystem::path& folder) const override;
};

}  // namespace hearth
