#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Numbers as the bytes of files, as saved_bake.md and bake_part.md describe them.
namespace hearth {

/// Little-endian.
template <typename Unsigned>
void put(std::string& bytes, Unsigned number) {
  for (std::size_t i = 0; i < sizeof number; ++i)
    bytes.push_back(static_cast<char>((number >> (8 * i)) & 0xff));
}

/// Seven bits a byte, the lowest first, a top bit for more to come (LEB128): of small numbers, one
/// byte.
void putShort(std::string& bytes, std::uint64_t number);

/// The same at `at`, where there is room for `kMostOfShort` bytes; returns what comes after it.
inline char* writeShort(char* at, std::uint64_t number) {
  for (; number >= 0x80; number >>= 7) *at++ = static_cast<char>(number | 0x80);
  *at++ = static_cast<char>(number);
  return at;
}
inline constexpr std::size_t kMostOfShort = 10;

/// 0, -1, 1, -2 and so on as 0, 1, 2, 3 (zigzag).
std::uint32_t folded(std::int32_t number);
std::uint64_t folded(std::int64_t number);
std::int32_t unfolded(std::uint32_t number);
std::int64_t unfolded(std::uint64_t number);

/// CRC-32 as in zlib, PNG and gzip.
std::uint32_t checksum(std::string_view bytes);

/// Takes numbers from the front of what is left. The caller has made sure that they are there.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  std::size_t left() const { return left_.size(); }

  std::string_view take(std::size_t count);
  std::uint32_t take32() { return static_cast<std::uint32_t>(number(4)); }
  std::uint64_t take64() { return number(8); }

  /// None where no such number of at most 32, or 64, bits stands.
  std::optional<std::uint32_t> takeShort32();
  std::optional<std::uint64_t> takeShort64();

 private:
  std::optional<std::uint64_t> takeShort(int bits);
  std::uint64_t number(std::size_t size);

  std::string_view left_;
};

}  // namespace hearth
