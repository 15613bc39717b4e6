#pragma once

#include <optional>
#include <vector>

#include "image/image.h"
#include "truth/trace.h"
#include "truth/truth_emission.h"
#include "truth/truth_light.h"
#include "truth/truth_sprites.h"

namespace hearth {

enum class TruthLightMode {
  Both,
  None,  ///< the texture's colour alone
  Only,  ///< the light in place of the texture; skies white
};

struct TruthPixel {
  Rgb color;   ///< rounded half up
  Vec3 exact;  ///< red, green, blue before rounding, 0..255
  Vec3 light;  ///< the factors of red, green and blue, 0..1; 1 for sky, what is bright, and
               ///< without light
  TruthHit hit;
};

/// Texel coordinates of a hit on an image of that size, not wrapped: the texel is (floor x, floor
/// y).
Vec2 texelOf(const TruthHit& hit, int width, int height);

/// A level and its things seen by one camera, pixel by pixel, with exact light: the reference for
/// pictures.
///
/// Pixel positions (i, j) are real numbers, in pixels from the picture's upper left corner: the
/// centre of the first pixel is (0.5, 0.5).
class TruthView {
 public:
  /// Keeps references to level and textures (by TextureId), not to the camera, whose eye must be
  /// in its sector. `ballPoints` as TruthLight takes them.
  TruthView(const Level& level, const std::vector<Image>& textures, const Shot& camera,
            int ballPoints = TruthLight::kBallPoints);

  TruthHit hit(double i, double j) const;

  /// Texel coordinates of a hit on its image.
  Vec2 texelAt(const TruthHit& hit) const;

  TruthPixel pixel(double i, double j, TruthLightMode mode) const;

  /// Whether one surface and one texel of it cover the circle of `radius` pixels around (i, j), as
  /// far as eight points on the circle tell.
  bool isClear(double i, double j, double radius) const;

  Image picture(TruthLightMode mode) const;

 private:
  Vec3 directionTo(double i, double j) const;
  std::optional<TruthHit> nearestThing(Vec3 direction, const AirStretch& air) const;
  Vec3 textureColor(const TruthHit& hit) const;
  Vec3 lightOn(const TruthHit& hit) const;
  Vec3 lightOnSprite(const Sprite& sprite) const;

  const Level& level_;
  const std::vector<Image>& textures_;
  Shot camera_;  ///< its eye clear of walls and flats
  TruthLight light_;
  TruthEmission emission_;
  TruthSprites sprites_;
};

}  // namespace hearth
