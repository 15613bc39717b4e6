#include "light/byte_stream.h"

#include <zlib.h>

#include <array>

#include "math/check.h"

namespace hearth {

namespace {

template <typename Signed, typename Unsigned>
Unsigned foldedAs(Signed number) {
  const Unsigned twice = static_cast<Unsigned>(number) << 1;
  return number < 0 ? ~twice : twice;
}

}  // namespace

void putShort(std::string& bytes, std::uint64_t number) {
  std::array<char, kMostOfShort> some{};
  const char* const end = writeShort(some.data(), number);
  bytes.append(some.data(), static_cast<std::size_t>(end - some.data()));
}

std::uint32_t folded(std::int32_t number) { return foldedAs<std::int32_t, std::uint32_t>(number); }

std::uint64_t folded(std::int64_t number) { return foldedAs<std::int64_t, std::uint64_t>(number); }

std::int32_t unfolded(std::uint32_t number) {
  return static_cast<std::int32_t>((number & 1) != 0 ? ~(number >> 1) : number >> 1);
}

std::int64_t unfolded(std::uint64_t number) {
  return static_cast<std::int64_t>((number & 1) != 0 ? ~(number >> 1) : number >> 1);
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

std::optional<std::uint32_t> ByteReader::takeShort32() {
  const std::optional<std::uint64_t> number = takeShort(32);
  if (!number) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

std::optional<std::uint64_t> ByteReader::takeShort64() { return takeShort(64); }

std::optional<std::uint64_t> ByteReader::takeShort(int bits) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < bits && !left_.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(take(1).front());
    const std::uint64_t seven = byte & 0x7fU;
    if (bits - shift < 7 && seven >> (bits - shift) != 0) return std::nullopt;
    value |= seven << shift;
    if (byte < 0x80) return value;
  }
  return std::nullopt;
}

std::uint64_t ByteReader::number(std::size_t size) {
  std::uint64_t value = 0;
  const std::string_view bytes = take(size);
  for (std::size_t i = 0; i < size; ++i)
    value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return value;
}

}  // namespace hearth
