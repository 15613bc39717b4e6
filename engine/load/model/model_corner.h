#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "load/model/model_report.h"
#include "load/model/model_text.h"

namespace hearth {

/// How many vertices of a kind there are, for the numbers that name them.
struct VertexCounts {
  std::size_t inFile = 0;
  std::size_t before = 0;  ///< the line: what negative numbers count back from
};

/// A corner of a face, as indices from 0.
struct CornerIndices {
  std::size_t position = 0;
  std::optional<std::size_t> image;
};

/// Reads `V`, `V/VT`, `V//VN` or `V/VT/VN`, of which VN is left out. Reports what is no corner, and
/// what names no vertex.
std::optional<CornerIndices> readCorner(std::string_view word, const ModelLine& line,
                                        const VertexCounts& positions, const VertexCounts& images,
                                        ModelReport& report);

}  // namespace hearth
