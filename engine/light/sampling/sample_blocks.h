#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "level/level.h"
#include "light/lit_surface.h"
#include "light/rays/shaft.h"
#include "light/sampling/sample_arrays.h"
#include "light/sampling/sample_placement.h"

namespace hearth {

/// A lattice of samples of one surface's lightmap, and a quadtree of blocks of them, whose leaves
/// have kLeast samples a side. There are no blocks of nothing but spare samples.
class SampleBlocks {
 public:
  /// Samples row by row, `columns` x `rows` of them. `surface` gives only directions.
  SampleBlocks(const Level& level, const LitSurface& surface, std::vector<SamplePoint> samples,
               int columns, int rows);

  struct Block {
    int column;
    int row;
    int columns;
    int rows;
    TargetBox box;  ///< contains the points where the samples' rays arrive
    /// The sector in which all samples lie, if there is one, and the surface.
    std::optional<SectorId> sector;
    std::optional<SurfaceId> surface;
    int samples = 0;              ///< without spare ones
    std::uint32_t firstPart = 0;  ///< the parts of a block follow one another
    std::uint32_t parts = 0;
  };

  const Block& whole() const { return blocks_.front(); }
  std::span<const Block> partsOf(const Block& block) const {
    return std::span(blocks_).subspan(block.firstPart, block.parts);
  }
  const std::vector<SamplePoint>& samples() const { return samples_; }
  /// In the same order: where samples lie, and where their rays arrive.
  SampleArrays points() const { return points_.arrays(); }
  SampleArrays targets() const { return targets_.arrays(); }

  /// Samples that follow one another on one surface.
  struct Run {
    SurfaceId surface;
    std::size_t first;
    std::size_t count;
  };
  const std::vector<Run>& runs() const { return runs_; }
  /// The surfaces on which they lie, each once.
  const std::vector<SurfaceId>& surfaces() const { return surfaces_; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  ShaftTargets targetsOf(const Block& block) const;

 private:
  static constexpr int kLeast = 4;

  struct Coordinates {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;

    void reserve(std::size_t count) { x.reserve(count), y.reserve(count), z.reserve(count); }
    void add(Vec3 p) { x.push_back(p.x), y.push_back(p.y), z.push_back(p.z); }
    SampleArrays arrays() const { return {x.data(), y.data(), z.data()}; }
  };

  void addToArrays(const SamplePoint& sample);
  void divide(std::size_t index);
  bool areSpare(const Block& block) const;
  /// What holds some samples, in metres from the first of all along the axes and the normal.
  struct Extent {
    Vec3 least;
    Vec3 most;
  };
  static void extend(Extent& extent, Vec3 p);
  void measureAll();
  Extent measureSamples(Block& block) const;
  Extent joined(Block& block, std::span<const Extent> extents) const;
  TargetBox boxOf(const Extent& extent) const;

  const Level& level_;
  Vec3 axisS_;  ///< unit vectors: nearly those of the surface's grid, and in its own plane
  Vec3 axisT_;
  Vec3 normal_;
  std::vector<SamplePoint> samples_;
  int columns_;
  Coordinates points_;
  Coordinates targets_;
  std::vector<Run> runs_;
  std::vector<SurfaceId> surfaces_;
  std::vector<SectorId> sectors_;  ///< of all samples, each once
  std::vector<Block> blocks_;
};

}  // namespace hearth
