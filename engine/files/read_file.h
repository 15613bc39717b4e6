#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace hearth {

enum class ReadErrorCode { Missing, NotRegular, TooLong, Changed, Failed };

struct ReadError {
  ReadErrorCode code;
  std::string what;  ///< in words: what is wrong
};

/// The failure that `reason`, a value of errno, stands for.
tl::unexpected<ReadError> readErrorFromErrno(int reason);

/// Reads all bytes of a regular file. Other kinds are refused: reading from a pipe might never end.
/// Files longer than `maxBytes` are refused before memory is taken. If the file's size or
/// modification time changes while it is read, the code is `Changed`: a mixture of old and new
/// bytes is not returned. Replacing the file by renaming another does not disturb the reading.
tl::expected<std::string, ReadError> readFile(const std::filesystem::path& path,
                                              std::uint64_t maxBytes);

}  // namespace hearth
