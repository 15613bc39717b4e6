#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "files/read_file.h"

namespace hearth {

/// The files that a walk reads and writes. The program gives it the disk.
class Storage {
 public:
  virtual ~Storage() = default;

  /// All bytes of a file, as readFile() gives them.
  virtual tl::expected<std::string, ReadError> read(const std::filesystem::path& file,
                                                    std::uint64_t maxBytes) = 0;
  /// Replaces a file, or makes it, whole or not at all. Errors are one sentence that begins with
  /// the path.
  virtual tl::expected<void, std::string> write(const std::filesystem::path& file,
                                                std::string_view bytes) = 0;
  /// Makes a folder, and those above it, where they are missing. If that fails, the first file that
  /// is written there reports it.
  virtual void makeFolder(const std::filesystem::path& folder) = 0;
};

}  // namespace hearth
