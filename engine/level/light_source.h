#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "level/ids.h"
#include "level/spot.h"
#include "level/sun.h"
#include "math/vec.h"

namespace hearth {

struct CurvePoint {
  double distance;  ///< metres
  double level;     ///< of light, >= 0; can exceed 255

  friend constexpr bool operator==(CurvePoint, CurvePoint) = default;
};

/// A point light, or a ball of light if `radius` > 0; a spotlight if it has a `spot`. Or a sun, the
/// sky, an emitter, or light that bounces: then it has no place, and only `intensity` and `color`
/// count.
struct LightSource {
  Vec3 position;
  SectorId sector;
  /// Levels at distance 0, of a sun, of the sky above level ground, or of an emitter at a surface
  /// that sees nothing else.
  double intensity = 255;
  double falloff = 0;  ///< per metre: brightness is intensity / (1 + falloff * distance)
  std::vector<CurvePoint>
      curve;  ///< by rising distance; if not empty, it replaces intensity and falloff
  std::uint8_t color[3] = {255, 255, 255};
  double radius = 0;         ///< metres
  std::optional<Spot> spot;  ///< none: it shines all around
  std::optional<Sun> sun;
  bool isSky = false;  ///< all skies of a level, as one dome
  /// What surfaces reflect of all other light, in the channels of its colour. No level has such a
  /// light: a bake adds it.
  bool isBounced = false;
  std::string texture;  ///< of an emitter: all surfaces that wear it shine, from their front; not
                        ///< skies, sprites and middle textures. Else empty

  bool isEmitter() const { return !texture.empty(); }
  bool isArea() const { return isSky || isEmitter() || isBounced; }
  bool hasPlace() const { return !sun && !isArea(); }

  /// Light in levels at `distance` metres in full light, before colour.
  double brightnessAt(double distance) const;
  /// The same at a point, in the light of a spot as seen from its centre, or in that of a sun.
  double brightnessAt(Vec3 point) const;
  /// The distance, in metres, beyond which no channel exceeds `cutOff` levels: 0 if none ever does,
  /// infinity if one always does.
  double reach(double cutOff) const;
  /// The factor of the light in a channel: 0 red, 1 green, 2 blue.
  double colorFactor(int channel) const { return color[channel] / 255.0; }
  double greatestFactor() const;
  bool isColored() const { return color[0] != color[1] || color[1] != color[2]; }

  friend bool operator==(const LightSource&, const LightSource&) = default;
};

}  // namespace hearth
