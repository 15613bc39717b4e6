#include "light/byte_stream.h"

#include <zlib.h>

#include "math/check.h"

namespace hearth {

void putShort(std::string& bytes, std::uint32_t number) {
  for (; number >= 0x80; number >>= 7) bytes.push_back(static_cast<char>(number | 0x80));
  bytes.push_back(static_cast<char>(number));
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string_view ByteReader::take(std::size_t count) {
  CHECK(count <= left_.size(), count, left_.size());
  const std::string_view taken = left_.substr(0, count);
  left_.remove_prefix(count);
  return taken;
}

std::optional<std::uint8_t> ByteReader::takeByte() {
  if (left_.empty()) return std::nullopt;
  return static_cast<std::uint8_t>(take(1).front());
}

std::optional<std::uint32_t> ByteReader::takeShort() {
  constexpr int kBits = 32;
  std::uint32_t value = 0;
  for (int shift = 0; shift < kBits; shift += 7) {
    const std::optional<std::uint8_t> byte = takeByte();
    if (!byte) return std::nullopt;
    const std::uint32_t seven = *byte & 0x7fU;
    if (kBits - shift < 7 && seven >> (kBits - shift) != 0) return std::nullopt;
    value |= seven << shift;
    if (*byte < 0x80) return value;
  }
  return std::nullopt;
}

std::uint64_t ByteReader::takeNumber(std::size_t size) {
  std::uint64_t value = 0;
  const std::string_view bytes = take(size);
  for (std::size_t i = 0; i < size; ++i)
    value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return value;
}

}  // namespace hearth
