#include "import/doom/patch.h"

#include <fmt/format.h>

#include <algorithm>

namespace hearth::doom {

namespace {

constexpr std::size_t kPatchHeader = 8;
constexpr std::size_t kColumnOffset = 4;
constexpr std::size_t kPostHeader = 3;
constexpr std::size_t kPostFrame = kPostHeader + 1;  // what a post has beside its pixels
constexpr std::uint8_t kEndOfColumn = 255;

/// Bytes of the longest column that makes sense, each of its pixels a post: a broken one may
/// otherwise go on through the rest of a large lump.
constexpr std::size_t kMaxColumn = kMaxSide * (kPostFrame + 1) + 1;

std::optional<std::string> mistakeInHeader(Bytes patch) {
  if (patch.size() < kPatchHeader)
    return fmt::format("has {} bytes, too few for a patch", patch.size());
  const int width = int16At(patch, 0);
  const int height = int16At(patch, 2);
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
    return fmt::format("is no patch: a side of {} x {} pixels is not within 1..{}", width, height,
                       kMaxSide);
  if (patch.size() < kPatchHeader + kColumnOffset * static_cast<std::size_t>(width))
    return fmt::format("has {} bytes, too few for {} columns", patch.size(), width);
  return std::nullopt;
}

/// Rows above the picture are taken from the end of a post, and its first ones shown in their
/// place: walls were drawn for this.
void drawPost(Bytes pixels, int x, int top, const Palette& palette, Picture& picture) {
  const int count = static_cast<int>(pixels.size()) + std::min(top, 0);
  const int first = std::max(top, 0);
  const int end = std::min(count, picture.image.height() - first);
  for (int i = 0; i < end; ++i)
    picture.draw(x, first + i, palette[pixels[static_cast<std::size_t>(i)]]);
}

/// False where the column breaks off.
bool drawColumn(Bytes column, int x, int top, const Palette& palette, Picture& picture) {
  int row = -1;
  while (!column.empty() && column[0] != kEndOfColumn) {
    if (column.size() < kPostHeader) return false;
    const std::size_t length = column[1];
    if (column.size() < kPostFrame + length) return false;
    row = column[0] > row ? column[0] : row + column[0];
    drawPost(column.subspan(kPostHeader, length), x, top + row, palette, picture);
    column = column.subspan(kPostFrame + length);
  }
  return !column.empty();
}

}  // namespace

tl::expected<PatchHeader, std::string> readPatchHeader(Bytes patch) {
  if (auto mistake = mistakeInHeader(patch)) return tl::unexpected(*std::move(mistake));
  return PatchHeader{int16At(patch, 0), int16At(patch, 2), int16At(patch, 4), int16At(patch, 6)};
}

int widthOfPatch(Bytes patch) { return patch.size() < kPatchHeader ? 0 : int16At(patch, 0); }

std::optional<std::string> drawPatch(Bytes patch, int left, std::span<const int> tops,
                                     const Palette& palette, Picture& picture) {
  if (auto mistake = mistakeInHeader(patch)) return mistake;
  std::optional<std::string> first;
  const int end = std::min<int>(int16At(patch, 0), picture.image.width() - left);
  for (int i = std::max(0, -left); i < end; ++i) {
    const std::int64_t begin =
        int32At(patch, kPatchHeader + kColumnOffset * static_cast<std::size_t>(i));
    const auto size = static_cast<std::int64_t>(patch.size());
    const bool isInside = begin >= 0 && begin < size;
    const Bytes rest = isInside ? patch.subspan(static_cast<std::size_t>(begin)) : Bytes{};
    const Bytes column = rest.first(std::min(rest.size(), kMaxColumn));
    const int x = left + i;
    const int top = tops[static_cast<std::size_t>(x)];
    if (!drawColumn(column, x, top, palette, picture) && !first)
      first = isInside ? fmt::format("breaks off in column {}", i)
                       : fmt::format("has column {} at byte {} of {}", i, begin, size);
  }
  return first;
}

}  // namespace hearth::doom
