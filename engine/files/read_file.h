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

/// All bytes of a regular file: reading from a pipe may wait for ever. Longer files are refused
/// before memory is taken. One that another program writes meanwhile, other than by renaming, is
/// `Changed`, as far as its size and time tell: no mixture of old and new shall be taken for it.
tl::expected<std::string, ReadFailure> readFile(const std::filesystem::path& path,
                                                std::uint64_t maxBytes);

}  // namespace hearth
