#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "support/baked_room.h"

namespace hearth::test {

// Where the fields of a saved bake lie: the table of saved_bake.md.
inline constexpr std::size_t kVersionAt = 8;
inline constexpr std::size_t kSettingsBytesAt = 12;
inline constexpr std::size_t kFileBytesAt = 16;
inline constexpr std::size_t kGeometryAt = 24;
inline constexpr std::size_t kTexelAt = 32;
inline constexpr std::size_t kLightmapsAt = 40;
inline constexpr std::size_t kLightmapBytesAt = 44;
inline constexpr std::size_t kHeaderBytes = 52;
inline constexpr std::size_t kChecksumBytes = 4;

inline constexpr std::string_view kSettings = "--samples 4";
/// Bytes of light that no level of these tests has.
inline constexpr std::uint64_t kMuchLight = 1 << 24;

void put(std::string& bytes, std::size_t at, std::uint64_t number, std::size_t size = 4);

/// The bytes with the length and the checksum that they must have.
std::string sealed(std::string bytes);

/// As one zlib stream.
std::string packed(const std::string& bytes);

/// A room open to its sky, lit red and white from its middle, and all of its light in bytes.
class SavedRoom : public testing::Test {
 protected:
  using Change = std::function<void(std::string&)>;

  static constexpr std::size_t kPackedAt = kHeaderBytes + kSettings.size();
  /// Bytes before the texels of a lightmap: numbers below 128 take one each.
  static constexpr std::ptrdiff_t kMapHeader = 6;

  static std::string roomText(std::string_view eastEnd);
  static BakedRoom roomOf(std::string_view eastEnd);

  std::string saved() const;
  /// Those of the saved bake, unpacked.
  std::string lightmaps() const;
  /// The saved bake with other lightmaps, packed and counted as they must be.
  std::string withLightmaps(const std::string& lightmaps) const;
  /// The saved bake with other bytes where its packed lightmaps are.
  std::string withPacked(std::string_view packed) const;

  /// What is wrong with the bytes, which are not too much light; empty if nothing is.
  std::string mistakeIn(std::string_view bytes) const;
  /// The same after a change to the file, behind a checksum that is right.
  std::string mistakeAfter(const Change& change) const;
  /// The same after a change to the lightmaps.
  std::string mistakeAfterInLightmaps(const Change& change) const;

  const BakedRoom room_ = roomOf("2");
};

}  // namespace hearth::test
