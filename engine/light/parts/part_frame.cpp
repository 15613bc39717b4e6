#include "light/parts/part_frame.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

#include "light/byte_stream.h"
#include "light/file_frame.h"
#include "light/saved_bake.h"
#include "math/check.h"

namespace hearth {

namespace {

// The layout, of which bake_part.md has the table.
constexpr FileFrame kPartFrame{
    .begin = "\x89HEARTP\n",
    .kind = "part of a bake",
    // To be raised with the layout, and with all that changes a sum: the rules of surfaces and
    // texel grids, the places of samples, and what light they get.
    .version = 2,
    .headerBytes = 52};
/// 1,000,000 times the major version, 1,000 times the minor one, and the patch.
constexpr std::uint32_t kProgram = HEARTH_VERSION;

struct PartHeader {
  std::uint32_t program;
  std::uint64_t fileBytes;
  std::uint32_t settingsBytes;
  PartNumber number;
  std::uint64_t geometry;
  std::uint64_t light;
};

PartHeader takePartHeader(ByteReader& in) {
  PartHeader header;
  header.program = in.take32();
  header.fileBytes = in.take64();
  header.settingsBytes = in.take32();
  header.number.part = in.take32();
  header.number.parts = in.take32();
  header.geometry = in.take64();
  header.light = in.take64();
  return header;
}

std::string versionText(std::uint32_t version) {
  return fmt::format("{}.{}.{}", version / 1'000'000, version / 1'000 % 1'000, version % 1'000);
}

}  // namespace

std::string framed(const BakeInParts& bake, PartNumber number,
                   std::span<const std::string> sumsOfTiles) {
  const std::string& settings = bake.settingsText();
  CHECK(settings.size() <= kMaxSettingsBytes, settings);
  std::uint64_t size = kPartFrame.headerBytes + settings.size() + FileFrame::kChecksumBytes;
  for (const std::string& sums : sumsOfTiles) size += sums.size();
  std::string bytes;
  bytes.reserve(size);
  bytes += kPartFrame.begin;
  put(bytes, kPartFrame.version);
  put(bytes, kProgram);
  put(bytes, size);
  put(bytes, static_cast<std::uint32_t>(settings.size()));
  put(bytes, number.part);
  put(bytes, number.parts);
  put(bytes, bake.geometryHash());
  put(bytes, bake.lightHash());
  bytes += settings;
  for (const std::string& sums : sumsOfTiles) bytes += sums;
  put(bytes, checksum(bytes));
  return bytes;
}

tl::expected<PartNumber, std::string> numberIn(const BakeInParts& bake, std::string_view bytes) {
  if (auto mistake = mistakeInFrame(kPartFrame, bytes)) return tl::unexpected(std::move(*mistake));
  ByteReader in(bytes.substr(FileFrame::kVersionEnd));
  const PartHeader header = takePartHeader(in);
  if (header.settingsBytes > in.left() - FileFrame::kChecksumBytes || header.number.part < 1 ||
      header.number.part > header.number.parts || header.number.parts > kMaxParts)
    return tl::unexpected(std::string("has a header that no part has"));
  const std::string_view settings = in.take(header.settingsBytes);
  if (header.program != kProgram)
    return tl::unexpected(fmt::format("was baked by version {} of the program, and this is {}",
                                      versionText(header.program), versionText(kProgram)));
  if (settings != bake.settingsText())
    return tl::unexpected(fmt::format("was baked with other settings: {:?}, not {:?}", settings,
                                      bake.settingsText()));
  if (header.geometry != bake.geometryHash())
    return tl::unexpected(std::string("was baked for other geometry than the level has now"));
  if (header.light != bake.lightHash())
    return tl::unexpected(std::string("was baked with other lights than the level has now"));
  return header.number;
}

std::string_view sumsIn(std::string_view bytes) {
  ByteReader in(bytes.substr(FileFrame::kVersionEnd));
  const PartHeader header = takePartHeader(in);
  in.take(header.settingsBytes);
  return in.take(in.left() - FileFrame::kChecksumBytes);
}

}  // namespace hearth
