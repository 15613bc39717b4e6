#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace hearth {

enum class ReadFault { Missing, NotRegular, TooLong, Changed, Failed };

struct ReadFailure {
  ReadFault fault;
  std::string what;  ///< in words: what is wrong
};

/// Why a file cannot be read, by the system's number for the reason (errno).
tl::unexpected<ReadFailure> failedRead(int reason);

/// All bytes of a regular file; reading from a pipe might never end. Longer files are refused
/// before memory is taken. If another program writes the file meanwhile, other than by renaming,
/// the fault is `Changed`, as far as size and time show: a mixture of old and new is never
/// returned.
tl::expected<std::string, ReadFailure> readFile(const std::filesystem::path& path,
                                                std::uint64_t maxBytes);

}  // namespace hearth
