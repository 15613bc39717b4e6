#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hearth {

/// What saved bakes and parts of bakes have in common: they begin with a text of 8 bytes and a
/// version of 4; the length of the file is 8 bytes at 16; a checksum of 4 bytes ends it.
struct FileFrame {
  std::string_view begin;
  std::string_view kind;  ///< such as "saved bake"
  std::uint32_t version;
  std::size_t headerBytes;

  static constexpr std::size_t kVersionEnd = 12;
  static constexpr std::size_t kChecksumBytes = 4;
};

/// Why bytes are not a file of this kind and version, all of it and as it was written: a predicate.
/// Bytes without a mistake have a whole header.
std::optional<std::string> mistakeInFrame(const FileFrame& frame, std::string_view bytes);

}  // namespace hearth
