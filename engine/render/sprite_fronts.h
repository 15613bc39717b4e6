#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "level/scene.h"
#include "level/sprite_index.h"
#include "level/sprite_sectors.h"
#include "render/by_id.h"
#include "render/by_strip.h"
#include "render/camera.h"
#include "render/segment_columns.h"
#include "render/standing_kernels.h"

namespace hearth {

/// A sprite before the eye.
class SpriteFront {
 public:
  /// `view` is what it shows, on a screen of this width.
  SpriteFront(const Sprite& sprite, const SpriteView& view, const SpriteRect& rect,
              const Projection& projection, int width);

  SurfaceId surface() const { return surface_; }
  std::uint32_t thing() const { return thing_; }  ///< see Sprite
  const SpriteView& view() const { return *view_; }
  bool lies() const { return lies_; }
  double zBottom() const { return zBottom_; }
  double zTop() const { return zTop_; }  ///< of what stands

  /// Columns outside which it does not show; empty if it shows in none.
  ColumnRange columns() const { return columns_; }

  const StandingEdge& lowerEdge() const { return lower_; }

  /// A stretch of a ray, in metres of depth: more than `from`, up to `to`.
  struct Depths {
    double from;
    double to;

    /// Cuts off where a linear function of the depth, `atEye` at the eye, is negative.
    void keepPositive(double atEye, double perMetre);
  };
  /// Of the ray with this slant, over or below what lies. Empty where it passes beside.
  Depths over(double slant) const;

 private:
  CameraPoint at(double right, double up) const;
  ColumnRange columnsIn(const Projection& projection, int width) const;

  SurfaceId surface_;
  std::uint32_t thing_;
  const SpriteView* view_;
  bool lies_;
  double zBottom_;
  double zTop_;
  StandingEdge lower_;
  CameraPoint up_;  ///< along its left edge; 0 where it stands
  ColumnRange columns_;
};

/// The sprites of the sectors in view, each sector's found once in a frame. Those of a sector are
/// near to far, by the depth of their position.
class SpriteFronts {
 public:
  /// Forgets all sectors, and begins a frame.
  void clear() {
    fronts_.clear();
    begun_ = 0;
    guests_.clear();
    sectors_.clear();
  }

  /// Those found in this frame.
  std::size_t count() const { return fronts_.size(); }

  bool has(SectorId sector) const { return fronts_.has(sector); }

  /// Finds those of another sector that may show in some of these columns.
  void find(const Scene& scene, const SpriteIndex& index, const Camera& camera,
            const Projection& projection, SectorId sector, ColumnRange columns);

  /// Those of a sector for which they have been found. Valid until `find` is called again.
  std::span<const SpriteFront> of(SectorId sector) const { return fronts_.of(sector); }
  /// Those of them that may show in a strip, by their numbers in `of`, rising.
  std::span<const std::uint32_t> inStrip(SectorId sector, int strip) const {
    return byStrip_[fronts_.placeOf(sector)].in(strip);
  }

 private:
  /// A sprite that reaches beyond its own sector, and where it is in this frame.
  struct Guest {
    std::uint32_t sprite;
    std::size_t begin;  ///< its sectors are [begin, end) of sectors_
    std::size_t end;
  };

  bool isIn(const Scene& scene, const Projection& projection, double seconds, std::uint32_t sprite,
            SectorId sector);
  Guest guestOf(const Scene& scene, const Projection& projection, double seconds,
                std::uint32_t sprite);

  ById<SectorId, SpriteFront> fronts_;
  std::vector<ByStrip> byStrip_;  ///< of each sector in their order; more is memory of other frames
  std::size_t begun_ = 0;         ///< sectors
  std::vector<Guest> guests_;
  std::vector<SectorId> sectors_;
  SpriteSectors finder_;
  // Of the present sector:
  std::vector<std::uint32_t> found_;  ///< sprites
  std::vector<SpriteFront> unsorted_;
  std::vector<std::pair<double, std::uint32_t>> nearToFar_;  ///< depths and indices of these
};

}  // namespace hearth
