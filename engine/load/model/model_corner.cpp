#include "load/model/model_corner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>

namespace hearth {

namespace {

struct CornerWords {
  std::array<std::string_view, 3> parts;  ///< empty where it has none
  bool hasMore = false;
};

CornerWords cornerWords(std::string_view word) {
  CornerWords words;
  for (std::string_view& part : words.parts) {
    const std::size_t size = std::min(word.find('/'), word.size());
    part = word.substr(0, size);
    words.hasMore = size < word.size();
    word.remove_prefix(std::min(size + 1, word.size()));
  }
  return words;
}

/// What is too large to tell is as large as can be told.
std::optional<std::int64_t> wholeNumber(std::string_view text) {
  using Limits = std::numeric_limits<std::int64_t>;
  std::int64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc::invalid_argument || stop != end) return std::nullopt;
  if (error != std::errc::result_out_of_range) return number;
  return text.starts_with('-') ? Limits::min() : Limits::max();
}

std::optional<std::size_t> indexOf(std::int64_t number, const VertexCounts& counts) {
  const auto inFile = static_cast<std::int64_t>(counts.inFile);
  const auto before = static_cast<std::int64_t>(counts.before);
  if (number > 0 && number <= inFile) return static_cast<std::size_t>(number - 1);
  if (number < 0 && number >= -before) return static_cast<std::size_t>(before + number);
  return std::nullopt;
}

void reportNoVertex(std::string_view kind, std::string_view number, bool isNegative,
                    const VertexCounts& counts, const ModelLine& line, ModelReport& report) {
  report.error(line.number,
               isNegative ? fmt::format("there is no {} {}: {} stand before this line", kind,
                                        shortened(number), counts.before)
                          : fmt::format("there is no {} {}: the file has {}", kind,
                                        shortened(number), counts.inFile),
               "count them from 1, or with -1 for the last one before the line");
}

}  // namespace

std::optional<CornerIndices> readCorner(std::string_view word, const ModelLine& line,
                                        const VertexCounts& positions, const VertexCounts& images,
                                        ModelReport& report) {
  const auto [parts, hasMore] = cornerWords(word);
  const auto [position, image, normal] = parts;
  const std::optional<std::int64_t> v = wholeNumber(position);
  const std::optional<std::int64_t> vt = wholeNumber(image);
  if (!v || (!vt && !image.empty()) || (!wholeNumber(normal) && !normal.empty()) || hasMore) {
    report.error(line.number, fmt::format("\"{}\" is no corner of a face", shortened(word)),
                 "write V, V/VT, V//VN or V/VT/VN with whole numbers");
    return std::nullopt;
  }
  CornerIndices corner;
  const std::optional<std::size_t> positionIndex = indexOf(*v, positions);
  if (!positionIndex) {
    reportNoVertex("vertex", position, *v < 0, positions, line, report);
    return std::nullopt;
  }
  corner.position = *positionIndex;
  if (!vt) return corner;
  corner.image = indexOf(*vt, images);
  if (corner.image) return corner;
  reportNoVertex("texture vertex", image, *vt < 0, images, line, report);
  return std::nullopt;
}

}  // namespace hearth
