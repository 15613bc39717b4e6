#include "light/sampling/sample_blocks.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "math/tolerance.h"

namespace hearth {

SampleBlocks::SampleBlocks(const Level& level, const LitSurface& surface,
                           std::vector<SamplePoint> samples, int columns, int rows)
    : level_(level), normal_(surface.normal), samples_(std::move(samples)), columns_(columns) {
  const Vec3 inPlane = surface.grid.axisS - dot(surface.grid.axisS, normal_) * normal_;
  axisS_ = (1 / length(inPlane)) * inPlane;
  axisT_ = cross(normal_, axisS_);
  const auto addOnce = [](auto& ids, auto id) {
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  };
  points_.reserve(samples_.size());
  targets_.reserve(samples_.size());
  for (const SamplePoint& sample : samples_) addToArrays(sample);
  for (const Run& run : runs_) {
    addOnce(surfaces_, run.surface);
    addOnce(sectors_, level_[run.surface].sector);
  }
  blocks_.push_back({.column = 0,
                     .row = 0,
                     .columns = columns,
                     .rows = rows,
                     .box = {},
                     .sector = {},
                     .surface = {}});
  for (std::size_t i = 0; i < blocks_.size(); ++i) divide(i);
  measureAll();
}

void SampleBlocks::extend(Extent& extent, Vec3 p) {
  auto& [least, most] = extent;
  least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
  most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
}

void SampleBlocks::addToArrays(const SamplePoint& sample) {
  if (runs_.empty() || runs_.back().surface != sample.surface)
    runs_.push_back({sample.surface, points_.x.size(), 0});
  ++runs_.back().count;
  points_.add(sample.point);
  targets_.add(sample.target);
}

void SampleBlocks::divide(std::size_t index) {
  const Block block = blocks_[index];
  if (block.columns <= kLeast && block.rows <= kLeast) return;
  const auto halves = [](int count) {
    const int first = count <= kLeast ? count : (count / 2 + kLeast - 1) / kLeast * kLeast;
    return std::pair{first, count - first};
  };
  const auto [left, right] = halves(block.columns);
  const auto [upper, lower] = halves(block.rows);
  blocks_[index].firstPart = static_cast<std::uint32_t>(blocks_.size());
  const auto add = [&](int column, int row, int columns, int rows) {
    const Block part{.column = block.column + column,
                     .row = block.row + row,
                     .columns = columns,
                     .rows = rows,
                     .box = {},
                     .sector = {},
                     .surface = {}};
    if (areSpare(part)) return;
    blocks_.push_back(part);
    ++blocks_[index].parts;
  };
  add(0, 0, left, upper);
  add(left, 0, right, upper);
  add(0, upper, left, lower);
  add(left, upper, right, lower);
}

/// True of a block without samples.
bool SampleBlocks::areSpare(const Block& block) const {
  for (int j = block.row; j < block.row + block.rows; ++j)
    for (int i = block.column; i < block.column + block.columns; ++i)
      if (!samples_[index(i, j)].isSpare) return false;
  return true;
}

/// Parts come behind what they are parts of.
void SampleBlocks::measureAll() {
  std::vector<Extent> extents(blocks_.size());
  for (std::size_t i = blocks_.size(); i-- > 0;) {
    Block& block = blocks_[i];
    extents[i] = block.parts == 0 ? measureSamples(block) : joined(block, extents);
    block.box = boxOf(extents[i]);
  }
}

SampleBlocks::Extent SampleBlocks::measureSamples(Block& block) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Extent extent{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  const Vec3 origin = samples_.front().target;
  const SurfaceId surface = samples_[index(block.column, block.row)].surface;
  block.surface = surface;
  block.sector = level_[surface].sector;
  for (int j = block.row; j < block.row + block.rows; ++j)
    for (int i = block.column; i < block.column + block.columns; ++i) {
      const SamplePoint& sample = samples_[index(i, j)];
      block.samples += sample.isSpare ? 0 : 1;
      const Vec3 offset = sample.target - origin;
      extend(extent, {dot(offset, axisS_), dot(offset, axisT_), dot(offset, normal_)});
      if (sample.surface == surface) continue;
      block.surface.reset();
      if (level_[sample.surface].sector != level_[surface].sector) block.sector.reset();
    }
  return extent;
}

SampleBlocks::Extent SampleBlocks::joined(Block& block, std::span<const Extent> extents) const {
  const std::span<const Block> parts = partsOf(block);
  Extent extent = extents[block.firstPart];
  block.surface = parts.front().surface;
  block.sector = parts.front().sector;
  for (const Block& part : parts) block.samples += part.samples;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    extend(extent, extents[block.firstPart + i].least);
    extend(extent, extents[block.firstPart + i].most);
    if (parts[i].surface != block.surface) block.surface.reset();
    if (parts[i].sector != block.sector) block.sector.reset();
  }
  return extent;
}

TargetBox SampleBlocks::boxOf(const Extent& extent) const {
  constexpr double kThin = kHeightNoise;
  const auto& [least, most] = extent;
  TargetBox box;
  box.normal = normal_;
  const bool isFlat = most.z - least.z < kThin;
  for (const double z : {least.z, most.z}) {
    for (const double y : {least.y, most.y})
      for (const double x : {least.x, most.x})
        box.storage[box.count++] = samples_.front().target + x * axisS_ + y * axisT_ + z * normal_;
    if (isFlat) break;
  }
  return box;
}

ShaftTargets SampleBlocks::targetsOf(const Block& block) const {
  if (block.sector) return {block.box, {&*block.sector, 1}};
  return {block.box, sectors_};
}

}  // namespace hearth
