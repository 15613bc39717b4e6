#include "saved_room.h"

#include <fmt/format.h>
#include <zlib.h>

#include "light/saved_bake.h"
#include "support/level_text.h"

namespace hearth::test {

void put(std::string& bytes, std::size_t at, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<char>(number >> (8 * i));
}

std::string sealed(std::string bytes) {
  put(bytes, kFileBytesAt, bytes.size(), 8);
  const std::size_t end = bytes.size() - kChecksumBytes;
  put(bytes, end, crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), end));
  return bytes;
}

std::string packed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  EXPECT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                     reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
            Z_OK);
  packed.resize(size);
  return packed;
}

std::string SavedRoom::roomText(std::string_view eastEnd) {
  return fmt::format("{{'light': 0, 'sectors': {{{}}}}}",
                     sectorText("room", fmt::format("0,0, {0},0, {0},2, 0,2", eastEnd), 0, 2,
                                "{'texture': '#808080'}"));
}

BakedRoom SavedRoom::roomOf(std::string_view eastEnd) {
  return {roomText(eastEnd),
          "{'lights': [{'x':1,'y':1,'z':0,'color':'#ff8000'},{'x':1,'y':1,'z':0.5,'intensity':9}],"
          " 'bake': {'texel': 1}}"};
}

std::string SavedRoom::saved() const {
  return encodeBake(room_.scene(), room_.light(), 1, kSettings);
}

std::string SavedRoom::lightmaps() const {
  const std::string bytes = saved();
  std::string lightmaps(10'000, '\0');
  uLongf size = lightmaps.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(lightmaps.data()), &size,
                       reinterpret_cast<const Bytef*>(&bytes[kPackedAt]),
                       bytes.size() - kPackedAt - kChecksumBytes),
            Z_OK);
  lightmaps.resize(size);
  return lightmaps;
}

std::string SavedRoom::withLightmaps(const std::string& lightmaps) const {
  std::string bytes = withPacked(packed(lightmaps));
  put(bytes, kLightmapBytesAt, lightmaps.size(), 8);
  return sealed(std::move(bytes));
}

std::string SavedRoom::withPacked(std::string_view packed) const {
  std::string bytes = saved().substr(0, kPackedAt);
  bytes += packed;
  bytes.append(kChecksumBytes, '\0');
  return sealed(std::move(bytes));
}

std::string SavedRoom::mistakeIn(std::string_view bytes) const {
  const auto read = decodeBake(room_.scene(), bytes, kMuchLight);
  if (read) return "";
  EXPECT_FALSE(read.error().isTooLarge);
  return read.error().what;
}

std::string SavedRoom::mistakeAfter(const Change& change) const {
  std::string bytes = saved();
  change(bytes);
  return mistakeIn(sealed(std::move(bytes)));
}

std::string SavedRoom::mistakeAfterInLightmaps(const Change& change) const {
  std::string bytes = lightmaps();
  change(bytes);
  return mistakeIn(withLightmaps(bytes));
}

}  // namespace hearth::test
