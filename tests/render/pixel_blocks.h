#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "render/group_mapping.h"
#include "render/pixel_block.h"

namespace hearth::test {

/// The number of a row's first pixel.
inline std::size_t pixelOfRow(std::size_t row) { return row * PixelBlock::kLanes; }

/// Makes a block of rows with these parameters in all columns, at most PixelBlock::kRows.
inline void setRows(PixelBlock& block, const std::vector<double>& parameters) {
  block.rows = static_cast<int>(parameters.size());
  for (std::size_t row = 0; row < parameters.size(); ++row)
    for (std::size_t lane = 0; lane < PixelBlock::kLanes; ++lane)
      block.parameters[pixelOfRow(row) + lane] = parameters[row];
}

/// Makes all pixels of a block's rows show the surface.
inline void setFull(PixelBlock& block) {
  block.columns.rows.begin.fill(block.firstRow);
  block.columns.rows.end.fill(block.firstRow + block.rows);
  block.columns.fullBegin = block.firstRow;
  block.columns.fullEnd = block.firstRow + block.rows;
}

/// The same mapping in all columns.
inline GroupMapping inAllColumns(const SpanMapping& mapping) {
  const auto affine = [](const Affine& along) {
    LaneAffine lanes;
    lanes.atZero.fill(along.atZero);
    lanes.per.fill(along.per);
    return lanes;
  };
  const auto axis = [&](const ImageAxis& along) {
    LaneImageAxis lanes{affine(along.place), {}, along.texelsPerPlace, along.offset};
    lanes.origin.fill(along.origin);
    return lanes;
  };
  GroupMapping group{.isPlane = mapping.isPlane,
                     .isLevel = mapping.isPlane && mapping.rise == 0,
                     .isSky = mapping.isSky,
                     .height = mapping.height,
                     .rise = {},
                     .depth = {},
                     .u = axis(mapping.u),
                     .v = axis(mapping.v),
                     .s = affine(mapping.s),
                     .t = affine(mapping.t)};
  group.rise.fill(mapping.rise);
  group.depth.fill(mapping.depth);
  return group;
}

/// How a block notes a way between two texels.
inline std::uint32_t minusFraction(double fraction) {
  const auto number = static_cast<std::uint16_t>(-std::lround(fraction * 0x8000));
  return std::uint32_t{number} * 0x10001;
}

}  // namespace hearth::test
