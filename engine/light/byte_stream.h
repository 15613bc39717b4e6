#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

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
void putShort(std::string& bytes, std::uint32_t number);

/// 0, -1, 1, -2 and so on as 0, 1, 2, 3 (zigzag).
template <typename Signed>
std::make_unsigned_t<Signed> folded(Signed number) {
  const auto twice = static_cast<std::make_unsigned_t<Signed>>(number) << 1;
  return number < 0 ? ~twice : twice;
}
template <typename Unsigned>
std::make_signed_t<Unsigned> unfolded(Unsigned number) {
  return static_cast<std::make_signed_t<Unsigned>>((number & 1) != 0 ? ~(number >> 1)
                                                                     : number >> 1);
}

/// CRC-32 as in zlib, PNG and gzip.
std::uint32_t checksum(std::string_view bytes);

/// Takes numbers from the front of what is left. The caller has made sure that they are there.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  std::size_t left() const { return left_.size(); }

  std::string_view take(std::size_t count);
  std::uint32_t take32() { return static_cast<std::uint32_t>(takeNumber(4)); }
  std::uint64_t take64() { return takeNumber(8); }

  /// Of so many bytes, at most 8, the lowest first.
  std::uint64_t takeNumber(std::size_t size);

  /// None at the end.
  std::optional<std::uint8_t> takeByte();
  /// None where no such number of at most 32 bits stands.
  std::optional<std::uint32_t> takeShort();

 private:
  std::string_view left_;
};

}  // namespace hearth
