#include "light/parts/sums_as_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "light/baking/light_sum.h"

namespace hearth {

namespace {

/// Numbers of a row that take equally many bytes.
constexpr std::size_t kGroup = 8;
constexpr std::size_t kMostOfNumber = sizeof(std::uint64_t);

std::size_t groupFrom(std::size_t first, std::size_t rowSize) {
  return std::min(kGroup, rowSize - first);
}

/// Calls visit(k, expected(k)) for units of a row in order, from `first` on. What is expected of
/// one continues the plane through its neighbours to the left and above, so where light is smooth,
/// differences are small. Beyond the rectangle all is dark.
template <typename Visit>
void forEachExpected(std::span<const double> row, std::span<const double> above, std::size_t first,
                     std::size_t count, Visit&& visit) {
  double left = first > 0 ? row[first - 1] : 0;
  double corner = first > 0 ? above[first - 1] : 0;
  for (std::size_t k = first; k < first + count; ++k) {
    visit(k, static_cast<std::int64_t>(left + above[k] - corner));
    left = row[k];
    corner = above[k];
  }
}

/// A row as bytes; `memory` is used for it.
std::string_view asBytes(std::span<const double> row, std::span<const double> above,
                         std::vector<char>& memory) {
  // After each number, another one has room.
  memory.resize((row.size() + kGroup) * (kMostOfNumber + 1));
  char* at = memory.data();
  std::array<std::uint64_t, kGroup> numbers;
  for (std::size_t first = 0; first < row.size(); first += kGroup) {
    const std::size_t count = groupFrom(first, row.size());
    std::uint64_t all = 0;
    forEachExpected(row, above, first, count, [&](std::size_t k, std::int64_t expected) {
      const std::uint64_t number = folded(static_cast<std::int64_t>(row[k]) - expected);
      numbers[k - first] = number;
      all |= number;
    });
    const auto bytes = static_cast<std::size_t>(std::bit_width(all) + 7) / 8;
    *at++ = static_cast<char>(bytes);
    // All bytes of each, the upper ones of which the next number overwrites.
    for (std::size_t i = 0; i < count; ++i, at += bytes)
      for (std::size_t byte = 0; byte < kMostOfNumber; ++byte)
        at[byte] = static_cast<char>(numbers[i] >> (8 * byte));
  }
  return {memory.data(), at};
}

/// Sets a sum to what was expected and a difference. False if that is no sum.
bool setSum(std::int64_t expected, std::int64_t difference, double& sum) {
  // Both are too small for their sum to overflow.
  constexpr auto kMost = std::int64_t{1} << 60;
  if (difference <= -kMost || kMost <= difference) return false;
  sum = static_cast<double>(expected + difference);
  return 0 <= sum && sum <= LightSum::kFull;
}

/// False if no such row stands there.
bool takeRow(ByteReader& in, std::span<const double> above, std::span<double> row) {
  for (std::size_t first = 0; first < row.size(); first += kGroup) {
    const std::size_t count = groupFrom(first, row.size());
    const std::optional<std::size_t> bytes = in.takeByte();
    if (!bytes || *bytes > kMostOfNumber || in.left() < count * *bytes) return false;
    bool areSums = true;
    forEachExpected(row, above, first, count, [&](std::size_t k, std::int64_t expected) {
      areSums &= areSums && setSum(expected, unfolded(in.takeNumber(*bytes)), row[k]);
    });
    if (!areSums) return false;
  }
  return true;
}

}  // namespace

void putSums(std::string& bytes, const TexelSums& sums, const TexelRect& tile) {
  const TexelRect lit = sums.litTexels();
  if (lit.count() == 0) return putShort(bytes, 0);
  for (const int number :
       {sums.channels(), lit.i0 - tile.i0, lit.j0 - tile.j0, lit.width, lit.height})
    putShort(bytes, static_cast<std::uint32_t>(number));
  constexpr std::int64_t kUsualBytes = 3;  // of a number
  bytes.reserve(bytes.size() +
                static_cast<std::size_t>(kUsualBytes * lit.count() * sums.channels()));
  const std::vector<double> dark(static_cast<std::size_t>(lit.width));
  std::vector<char> memory;
  for (int channel = 0; channel < sums.channels(); ++channel) {
    std::span<const double> above = dark;
    for (int j = lit.j0; j < lit.j0 + lit.height; ++j) {
      const auto row = sums.unitsInRow(channel, lit.i0, j, lit.width);
      bytes += asBytes(row, above, memory);
      above = row;
    }
  }
}

std::optional<TexelSums> takeSums(ByteReader& in, const TexelRect& tile) {
  const auto channels = in.takeShort();
  if (!channels || *channels == 2 || *channels > 3) return std::nullopt;
  if (*channels == 0) return TexelSums({tile.i0, tile.j0, 0, 0}, 1);
  std::array<std::uint32_t, 4> numbers{};
  for (std::uint32_t& number : numbers) {
    const auto taken = in.takeShort();
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
  const std::vector<double> dark(width);
  std::span<const double> above;
  for (std::size_t begin = 0; begin < sums.units().size(); begin += width) {
    if (begin % (std::size_t{width} * height) == 0) above = dark;  // a channel begins
    const std::span<double> row = sums.units().subspan(begin, width);
    if (!takeRow(in, above, row)) return std::nullopt;
    above = row;
  }
  return sums;
}

}  // namespace hearth
