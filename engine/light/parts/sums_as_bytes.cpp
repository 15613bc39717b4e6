#include "light/parts/sums_as_bytes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "light/baking/light_sum.h"

namespace hearth {

namespace {

/// Calls visit(i, expected(i)) for all units in order. What is expected of one continues the plane
/// through its neighbours to the left and above, so where light is smooth, differences are small.
template <typename Visit>
void forEachExpected(std::span<const double> units, int width, int height, Visit&& visit) {
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < units.size();)
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < columns; ++column, ++i) {
        const double left = column > 0 ? units[i - 1] : 0;
        const double upper = row > 0 ? units[i - columns] : 0;
        const double corner = column > 0 && row > 0 ? units[i - columns - 1] : 0;
        visit(i, static_cast<std::int64_t>(left + upper - corner));
      }
}

}  // namespace

void putSums(std::string& bytes, const TexelSums& sums, const TexelRect& tile) {
  const TexelSums lit = sums.cropped();
  const TexelRect& rect = lit.rect();
  if (rect.count() == 0) return putShort(bytes, 0);
  for (const int number :
       {lit.channels(), rect.i0 - tile.i0, rect.j0 - tile.j0, rect.width, rect.height})
    putShort(bytes, static_cast<std::uint64_t>(number));
  const std::size_t before = bytes.size();
  bytes.resize(before + lit.units().size() * kMostOfShort);
  char* at = &bytes[before];
  forEachExpected(lit.units(), rect.width, rect.height, [&](std::size_t i, std::int64_t expected) {
    const auto unit = static_cast<std::int64_t>(lit.units()[i]);
    at = writeShort(at, folded(unit - expected));
  });
  bytes.resize(static_cast<std::size_t>(at - bytes.data()));
}

std::optional<TexelSums> takeSums(ByteReader& in, const TexelRect& tile) {
  const auto channels = in.takeShort32();
  if (!channels || *channels == 2 || *channels > 3) return std::nullopt;
  if (*channels == 0) return TexelSums({tile.i0, tile.j0, 0, 0}, 1);
  std::array<std::uint32_t, 4> numbers{};
  for (std::uint32_t& number : numbers) {
    const auto taken = in.takeShort32();
    if (!taken) return std::nullopt;
    number = *taken;
  }
  const auto [i, j, width, height] = numbers;
  const auto isIn = [](std::uint32_t first, std::uint32_t count, int of) {
    return count > 0 && std::uint64_t{first} + count <= static_cast<std::uint64_t>(of);
  };
  if (!isIn(i, width, tile.width) || !isIn(j, height, tile.height)) return std::nullopt;
  TexelSums sums({tile.i0 + static_cast<int>(i), tile.j0 + static_cast<int>(j),
                  static_cast<int>(width), static_cast<int>(height)},
                 static_cast<int>(*channels));
  bool areSums = true;
  forEachExpected(sums.units(), sums.rect().width, sums.rect().height,
                  [&](std::size_t k, std::int64_t expected) {
                    const auto difference = in.takeShort64();
                    // Both are too small for their sum to overflow.
                    constexpr auto kMost = std::int64_t{1} << 60;
                    const std::int64_t off = unfolded(difference.value_or(0));
                    const bool isSum = difference && -kMost < off && off < kMost &&
                                       expected + off >= 0 &&
                                       static_cast<double>(expected + off) <= LightSum::kFull;
                    areSums &= isSum;
                    if (isSum) sums.units()[k] = static_cast<double>(expected + off);
                  });
  if (!areSums) return std::nullopt;
  return sums;
}

}  // namespace hearth
