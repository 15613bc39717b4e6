// Bytes of a fuzzer as saved bakes of one level: each is refused with a message, or is light that
// can be drawn and saved again.

#include "light/saved_bake.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>

#include "light/geometry_hash.h"
#include "light/grid/texel_limits.h"
#include "load/load.h"
#include "math/check.h"
#include "render/renderer.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

// Offsets of the header: the table of engine/light/saved_bake.md.
constexpr std::size_t kSettingsBytesAt = 12;
constexpr std::size_t kFileBytesAt = 16;
constexpr std::size_t kGeometryAt = 24;
constexpr std::size_t kTexelAt = 32;
constexpr std::size_t kLightmapBytesAt = 44;
constexpr std::size_t kHeaderBytes = 52;
constexpr std::size_t kChecksumBytes = 4;

/// Of all lightmaps; a fuzzer packs as much into a few thousand bytes.
constexpr std::uint64_t kMaxLightBytes = 1 << 23;

/// The level is the program's argument to every input, so it is loaded once.
const LoadedLevel& level() {
  static const LoadedLevel loaded =
      loadLevel(test::inTree("tests/levels/rooms.json")).loaded.value();
  return loaded;
}

void put(std::string& bytes, std::size_t at, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<char>(number >> (8 * i));
}

std::uint64_t take(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i)
    number |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return number;
}

/// With the length, checksum and hash that no fuzzer would guess, so that it reaches what is behind
/// them. Sizes of texels that are refused are left to be refused.
std::string sealed(std::string bytes) {
  const std::size_t end = bytes.size() - kChecksumBytes;
  const auto texel = std::bit_cast<double>(take(bytes, kTexelAt, 8));
  if (!mistakeInTexel(level().scene(), texel))
    put(bytes, kGeometryAt, geometryHash(level().scene(), texel), 8);
  put(bytes, kFileBytesAt, bytes.size(), 8);
  put(bytes, end, crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), end), kChecksumBytes);
  return bytes;
}

/// With what stands in place of the packed lightmaps packed, so that the fuzzer reaches them.
std::string deflated(const std::string& bytes) {
  const std::size_t end = bytes.size() - kChecksumBytes;
  const std::size_t begin =
      std::min<std::size_t>(kHeaderBytes + take(bytes, kSettingsBytesAt, 4), end);
  uLongf size = compressBound(end - begin);
  std::string stream(size, '\0');
  CHECK(compress(reinterpret_cast<Bytef*>(stream.data()), &size,
                 reinterpret_cast<const Bytef*>(&bytes[begin]), end - begin) == Z_OK);
  stream.resize(size);
  std::string packed = bytes.substr(0, begin) + stream + bytes.substr(end);
  put(packed, kLightmapBytesAt, end - begin, 8);
  return packed;
}

void expectUsable(const BakedLight& light, double texel) {
  const Camera camera{SectorId(0), {1, 2, 1.5}, 30, -20, 90, 12, 8};
  (void)Renderer(level().scene(), level().textures, light).draw(camera, LightMode::Both);
  const auto again =
      decodeBake(level().scene(), encodeBake(level().scene(), light, texel, ""), kMaxLightBytes);
  CHECK(again);
  for (std::size_t i = 0; i < light.lightmaps.size(); ++i)
    CHECK(again->lightmaps[i].has_value() == light.lightmaps[i].has_value() &&
              (!light.lightmaps[i] || again->lightmaps[i]->levels == light.lightmaps[i]->levels),
          i);
}

void tryOut(const std::string& bytes) {
  const auto light = decodeBake(level().scene(), bytes, kMaxLightBytes);
  if (light)
    expectUsable(*light, std::bit_cast<double>(take(bytes, kTexelAt, 8)));
  else
    CHECK(!light.error().what.empty());
}

}  // namespace
}  // namespace hearth

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(data, data + size);
  hearth::tryOut(bytes);
  if (size < hearth::kHeaderBytes + hearth::kChecksumBytes) return 0;
  hearth::tryOut(hearth::sealed(bytes));
  hearth::tryOut(hearth::sealed(hearth::deflated(bytes)));
  return 0;
}
