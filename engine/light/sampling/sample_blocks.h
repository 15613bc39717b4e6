#pragma once

#include <cstddef>
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

/// A lattice of samples of one surface's lightmap, and a tree of blocks of them. First the samples
/// are parted by the surfaces on which they lie. Those of one surface follow one another in the
/// order in which a quadtree visits them, so a block is a range of these: its samples lie side by
/// side, and SIMD code reads them without gaps. Spare samples are in no block.
class SampleBlocks {
 public:
  /// Samples row by row, `columns` of them in each. `surface` gives only directions.
  SampleBlocks(const Level& level, const LitSurface& surface, std::vector<SamplePoint> samples,
               int columns);

  /// What holds some samples, in metres from the first of all along the axes and the normal.
  struct Extent {
    Vec3 least;
    Vec3 most;
  };
  struct Block {
    std::size_t first;  ///< in indices() and targets()
    std::size_t count;
    /// The sector in which all samples lie, if there is one, and the surface.
    std::optional<SectorId> sector;
    std::optional<SurfaceId> surface;
    Extent extent{};              ///< of the points where the samples' rays arrive
    std::uint32_t firstPart = 0;  ///< the parts of a block follow one another
    std::uint32_t parts = 0;
  };

  const Block& whole() const { return blocks_.front(); }
  std::span<const Block> partsOf(const Block& block) const {
    return std::span(blocks_).subspan(block.firstPart, block.parts);
  }
  /// The largest blocks that lie on one surface: one for each surface.
  std::span<const Block> onSurfaces() const {
    return whole().surface ? std::span(blocks_).first(1) : partsOf(whole());
  }

  const std::vector<SamplePoint>& samples() const { return samples_; }
  /// In the same order: where samples lie.
  SampleArrays points() const { return points_.arrays(); }
  /// The samples of a block, by their indices in the lattice.
  std::span<const std::uint32_t> indices(const Block& block) const {
    return std::span(indices_).subspan(block.first, block.count);
  }
  /// In the same order: where their rays arrive. Up to SampleArrays::kMaxLanes more can be read.
  SampleArrays targets(const Block& block) const { return targets_.arrays().from(block.first); }

  /// Samples that follow one another on one surface.
  struct Run {
    SurfaceId surface;
    std::size_t first;
    std::size_t count;
  };
  const std::vector<Run>& runs() const { return runs_; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  /// Contains the points where the samples' rays arrive.
  TargetBox boxOf(const Block& block) const;
  ShaftTargets targetsOf(const Block& block) const;

 private:
  struct Coordinates {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;

    explicit Coordinates(std::size_t count) : x(count), y(count), z(count) {}
    void set(std::size_t i, Vec3 p) { x[i] = p.x, y[i] = p.y, z[i] = p.z; }
    SampleArrays arrays() const { return {x.data(), y.data(), z.data()}; }
  };
  /// Columns and rows of the lattice around all samples on a surface.
  struct Part {
    SurfaceId surface;
    int left;
    int right;  ///< one more than the last
    int top;
    int bottom;
  };

  void addPoint(std::size_t index);
  std::vector<Part> partsOnSurfaces() const;
  void addSurfaces();
  void collect(const Part& part);
  void addRange(std::size_t first, std::size_t end, SurfaceId surface);
  void divide(std::size_t index);
  static void extend(Extent& extent, Vec3 p);
  void measureAll();
  Extent measureSamples(const Block& block) const;
  Extent joined(const Block& block) const;

  const Level& level_;
  Vec3 axisS_;  ///< unit vectors: nearly those of the surface's grid, and in its own plane
  Vec3 axisT_;
  Vec3 normal_;
  std::vector<SamplePoint> samples_;
  int columns_;
  Coordinates points_;
  std::vector<std::uint32_t> indices_;
  Coordinates targets_;
  std::vector<Run> runs_;
  std::vector<SectorId> sectors_;  ///< of all samples, each once
  std::vector<Block> blocks_;
};

}  // namespace hearth
