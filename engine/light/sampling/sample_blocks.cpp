#include "light/sampling/sample_blocks.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "math/tolerance.h"

namespace hearth {

namespace {

/// Columns and rows of samples that follow one another row by row.
constexpr int kCell = 4;
/// A block of no more samples has no parts.
constexpr std::size_t kLeastBlock = std::size_t{kCell} * kCell;

}  // namespace

SampleBlocks::SampleBlocks(const Level& level, const LitSurface& surface,
                           std::vector<SamplePoint> samples, int columns)
    : level_(level),
      normal_(surface.normal),
      samples_(std::move(samples)),
      columns_(columns),
      points_(samples_.size()),
      targets_(samples_.size() + SampleArrays::kMaxLanes) {
  const Vec3 inPlane = surface.grid.axisS - dot(surface.grid.axisS, normal_) * normal_;
  axisS_ = (1 / length(inPlane)) * inPlane;
  axisT_ = cross(normal_, axisS_);
  for (std::size_t i = 0; i < samples_.size(); ++i) addPoint(i);
  addSurfaces();
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i].surface) divide(i);
  measureAll();
}

void SampleBlocks::addPoint(std::size_t index) {
  const SamplePoint& sample = samples_[index];
  if (runs_.empty() || runs_.back().surface != sample.surface)
    runs_.push_back({sample.surface, index, 0});
  ++runs_.back().count;
  points_.set(index, sample.point);
}

std::vector<SampleBlocks::Part> SampleBlocks::partsOnSurfaces() const {
  std::vector<Part> parts;
  for (const Run& run : runs_) {
    const auto place = [&](std::size_t index) {
      return std::pair{static_cast<int>(index) % columns_, static_cast<int>(index) / columns_};
    };
    const auto [left, top] = place(run.first);
    const auto [right, bottom] = place(run.first + run.count - 1);
    const Part here = top == bottom ? Part{run.surface, left, right + 1, top, top + 1}
                                    : Part{run.surface, 0, columns_, top, bottom + 1};
    const auto found = std::ranges::find(parts, run.surface, &Part::surface);
    if (found == parts.end()) {
      parts.push_back(here);
      continue;
    }
    found->left = std::min(found->left, here.left);
    found->right = std::max(found->right, here.right);
    found->top = std::min(found->top, here.top);
    found->bottom = std::max(found->bottom, here.bottom);
  }
  return parts;
}

/// Adds the whole and, if it lies on several surfaces, the parts on each of them.
void SampleBlocks::addSurfaces() {
  indices_.reserve(samples_.size());
  const std::vector<Part> parts = partsOnSurfaces();
  blocks_.reserve(1 + parts.size() + samples_.size() / 8);
  if (parts.size() > 1) blocks_.push_back({.first = 0, .count = 0, .sector = {}, .surface = {}});
  for (const Part& part : parts) {
    const std::size_t first = indices_.size();
    collect(part);
    addRange(first, indices_.size(), part.surface);
    const SectorId sector = level_[part.surface].sector;
    if (std::ranges::find(sectors_, sector) == sectors_.end()) sectors_.push_back(sector);
  }
  if (parts.size() == 1) return;
  Block& whole = blocks_.front();
  whole.count = indices_.size();
  if (sectors_.size() == 1) whole.sector = sectors_.front();
  whole.firstPart = 1;
  whole.parts = static_cast<std::uint32_t>(parts.size());
}

/// Appends the samples of a surface, quarter by quarter.
void SampleBlocks::collect(const Part& part) {
  const auto& [surface, left, right, top, bottom] = part;
  if (right - left <= kCell && bottom - top <= kCell) {
    for (int row = top; row < bottom; ++row)
      for (int column = left; column < right; ++column) {
        const std::size_t at = index(column, row);
        if (samples_[at].isSpare || samples_[at].surface != surface) continue;
        targets_.set(indices_.size(), samples_[at].target);
        indices_.push_back(static_cast<std::uint32_t>(at));
      }
    return;
  }
  const auto middle = [](int first, int end) {
    const int count = end - first;
    return count <= kCell ? end : first + (count / 2 + kCell - 1) / kCell * kCell;
  };
  const int column = middle(left, right);
  const int row = middle(top, bottom);
  collect({surface, left, column, top, row});
  if (column < right) collect({surface, column, right, top, row});
  if (row < bottom) collect({surface, left, column, row, bottom});
  if (column < right && row < bottom) collect({surface, column, right, row, bottom});
}

void SampleBlocks::addRange(std::size_t first, std::size_t end, SurfaceId surface) {
  blocks_.push_back(
      {.first = first, .count = end - first, .sector = level_[surface].sector, .surface = surface});
}

/// In four parts, or fewer.
void SampleBlocks::divide(std::size_t index) {
  const Block block = blocks_[index];
  if (block.count <= kLeastBlock) return;
  const std::size_t quarter = (block.count + 4 * kLeastBlock - 1) / (4 * kLeastBlock) * kLeastBlock;
  blocks_[index].firstPart = static_cast<std::uint32_t>(blocks_.size());
  for (std::size_t first = 0; first < block.count; first += quarter) {
    addRange(block.first + first, block.first + std::min(first + quarter, block.count),
             *block.surface);
    ++blocks_[index].parts;
  }
}

void SampleBlocks::extend(Extent& extent, Vec3 p) {
  auto& [least, most] = extent;
  least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
  most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
}

/// Parts come behind what they are parts of.
void SampleBlocks::measureAll() {
  for (std::size_t i = blocks_.size(); i-- > 0;)
    blocks_[i].extent = blocks_[i].parts == 0 ? measureSamples(blocks_[i]) : joined(blocks_[i]);
}

SampleBlocks::Extent SampleBlocks::measureSamples(const Block& block) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Extent extent{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  const Vec3 origin = samples_.front().target;
  const SampleArrays at = targets(block);
  for (std::size_t i = 0; i < block.count; ++i) {
    const Vec3 offset = Vec3{at.x[i], at.y[i], at.z[i]} - origin;
    extend(extent, {dot(offset, axisS_), dot(offset, axisT_), dot(offset, normal_)});
  }
  return extent;
}

SampleBlocks::Extent SampleBlocks::joined(const Block& block) const {
  Extent extent = partsOf(block).front().extent;
  for (const Block& part : partsOf(block)) {
    extend(extent, part.extent.least);
    extend(extent, part.extent.most);
  }
  return extent;
}

TargetBox SampleBlocks::boxOf(const Block& block) const {
  constexpr double kThin = kHeightNoise;
  const auto& [least, most] = block.extent;
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
  if (block.sector) return {boxOf(block), {&*block.sector, 1}};
  return {boxOf(block), sectors_};
}

}  // namespace hearth
