#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "import/doom/wad.h"

namespace hearth::doom {

/// The bytes of a lump, one number or name behind the other.
class LumpBuilder {
 public:
  LumpBuilder& bytes(std::initializer_list<int> values) {
    for (const int value : values) bytes_ += static_cast<char>(value);
    return *this;
  }
  LumpBuilder& repeat(int value, std::size_t count) {
    bytes_.append(count, static_cast<char>(value));
    return *this;
  }
  LumpBuilder& int16(int value) { return bytes({value & 255, value >> 8 & 255}); }
  LumpBuilder& int32(std::int64_t value) {
    return int16(static_cast<int>(value & 65535)).int16(static_cast<int>(value >> 16 & 65535));
  }
  /// Cut, or filled up with zeros, to eight bytes.
  LumpBuilder& name(std::string_view text) {
    bytes_ += text.substr(0, 8);
    return repeat(0, 8 - text.substr(0, 8).size());
  }
  LumpBuilder& append(const std::string& other) {
    bytes_ += other;
    return *this;
  }

  std::size_t size() const { return bytes_.size(); }
  const std::string& content() const { return bytes_; }

 private:
  std::string bytes_;
};

/// The bytes of a WAD: header, lumps, directory.
class WadBuilder {
 public:
  WadBuilder& add(std::string_view name, std::string content = {}) {
    lumps_.emplace_back(name, std::move(content));
    return *this;
  }
  WadBuilder& add(std::string_view name, const LumpBuilder& lump) {
    return add(name, lump.content());
  }

  std::string content(std::string_view kind = "PWAD") const {
    LumpBuilder lumps;
    LumpBuilder directory;
    for (const auto& [name, bytes] : lumps_) {
      directory.int32(static_cast<std::int64_t>(kHeader + lumps.size()));
      directory.int32(static_cast<std::int64_t>(bytes.size())).name(name);
      lumps.append(bytes);
    }
    LumpBuilder header;
    header.append(std::string(kind)).int32(static_cast<std::int64_t>(lumps_.size()));
    header.int32(static_cast<std::int64_t>(kHeader + lumps.size()));
    return header.content() + lumps.content() + directory.content();
  }

 private:
  static constexpr std::size_t kHeader = 12;
  std::vector<std::pair<std::string, std::string>> lumps_;
};

/// The WAD of these bytes, read from a file. Errors are without the path that they begin with.
inline tl::expected<Wad, std::string> openBytes(const std::string& content,
                                                std::uint64_t maxBytes = 1 << 26) {
  const auto path =
      std::filesystem::path(testing::TempDir()) / fmt::format("hearth-{}.wad", ::getpid());
  std::ofstream(path, std::ios::binary) << content;
  auto wad = Wad::open(path, maxBytes);
  std::filesystem::remove(path);
  if (wad) return wad;
  const std::string begin = path.string() + ": ";
  EXPECT_TRUE(wad.error().starts_with(begin)) << wad.error();
  return tl::unexpected(wad.error().substr(begin.size()));
}

/// A WAD without mistakes.
inline Wad opened(const WadBuilder& builder) {
  auto wad = openBytes(builder.content());
  if (!wad) ADD_FAILURE() << wad.error();
  return std::move(wad).value();
}

/// The bytes of a lump as they would lie in a WAD, as long as `content` is.
inline Bytes bytesOf(const std::string& content) {
  return {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
}

}  // namespace hearth::doom
