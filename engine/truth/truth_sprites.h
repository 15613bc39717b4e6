#pragma once

#include <vector>

#include "image/image.h"
#include "truth/thing_sectors.h"
#include "truth/trace.h"
#include "truth/truth_light.h"

namespace hearth {

/// The sprites of a level as one camera sees them, at time 0.
///
/// Works from what the author says of each, so that the renderer can be compared with it.
class TruthSprites {
 public:
  /// Keeps references to level and textures (by TextureId), not to the camera.
  TruthSprites(const Level& level, const std::vector<Image>& textures, const Shot& camera);

  /// What a look from `origin` meets of them in a stretch of air: the nearest that has no hole
  /// there; of two at one depth the later. What bounds the stretch and is no nearer is behind them.
  /// `direction` goes 1 m deep before the camera: so the parameters of its ray are depths.
  std::optional<TruthHit> nearest(Vec3 origin, Vec3 direction, const AirStretch& stretch) const;

 private:
  /// A sprite's image in space.
  struct Picture {
    const Sprite* sprite;
    SpriteView view;
    Vec3 lowerLeft;
    Vec3 right;              ///< of length 1, along the image's lower edge
    Vec3 up;                 ///< of length 1, along its left edge
    std::vector<bool> isIn;  ///< by SectorId

    Polygon outline() const;
  };

  Picture pictureOf(const Sprite& sprite, const Shot& camera) const;
  std::optional<TruthHit> meet(const Picture& picture, Vec3 origin, Vec3 direction) const;
  bool isHole(const TruthHit& hit) const;

  const std::vector<Image>& textures_;
  std::vector<Picture> pictures_;  ///< of all sprites, in their order
};

/// The texel of a sprite's image at a hit, also where rounding puts it on the image's far edge.
struct SpriteTexel {
  int x;
  int y;
};
SpriteTexel spriteTexelOf(const TruthHit& hit, const Image& image);

/// The point of air whose light a sprite takes, off the walls and flats around it.
AirPoint litPointOf(const Level& level, const Sprite& sprite);

}  // namespace hearth
