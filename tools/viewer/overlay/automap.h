#pragma once

#include <vector>

#include "image/pixel_rows.h"
#include "level/scene.h"
#include "render/span.h"
#include "walk/walker.h"

namespace hearth {

/// The sectors that the player has seen since the walk began.
class SeenSectors {
 public:
  explicit SeenSectors(const Level& level) : level_(&level), isSeen_(level.sectors.size(), false) {}
  /// In another version of the level: sectors of the same names.
  SeenSectors(const Level& level, const SeenSectors& before);

  void add(SectorId sector) { isSeen_[sector.index()] = true; }
  /// Adds the sector of a span.
  void add(const Span& span);
  bool has(SectorId sector) const { return isSeen_[sector.index()]; }

 private:
  const Level* level_;
  std::vector<bool> isSeen_;
};

/// The kinds of wall that the map's colours distinguish.
enum class WallKind {
  Solid,
  Step,     ///< opens, but not over the whole height
  Opening,  ///< opens all of it
};
WallKind wallKind(const Scene& scene, const Segment& segment);

inline constexpr Rgb kSolidColor = {255, 255, 255};
inline constexpr Rgb kStepColor = {255, 160, 48};
inline constexpr Rgb kOpeningColor = {112, 112, 128};
inline constexpr Rgb kMapFlatPortalColor = {64, 160, 255};
inline constexpr Rgb kPlayerColor = {96, 255, 96};

/// How much of the map the picture's shorter side shows.
inline constexpr double kFirstMapMetres = 32;
/// One step of zooming, nearer or farther; within 2 m and 4 km.
double zoomedIn(double metres);
double zoomedOut(double metres);

/// Where points of the map are in a picture.
struct MapScale {
  Vec2 middle;  ///< of the picture, in pixels
  Vec2 center;  ///< the point of the map there, in metres
  double pixelsPerMetre;

  Vec2 toPicture(Vec2 world) const { return middle + pixelsPerMetre * (world - center); }
  Vec2 toWorld(Vec2 pixel) const { return center + 1 / pixelsPerMetre * (pixel - middle); }
};
/// The scale of a map that `drawAutomap` draws.
MapScale mapScale(int width, int height, const Eye& eye, double metres);

/// Draws the map over a picture that it darkens: x to the right, y down, the player in the middle,
/// an arrow in the direction of the view. It shows only sectors that were seen; those wholly above
/// or below the player's body are dim. Outlines of flat portals are dotted over the walls.
void drawAutomap(const PixelRows& picture, const Scene& scene, const SeenSectors& seen,
                 const Eye& eye, double metres);

}  // namespace hearth
