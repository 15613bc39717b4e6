#include "light/rays/passage.h"

namespace hearth {

namespace {

EndHeights flatLine(double z) { return {z, z}; }

/// A passage while it is found.
class Narrowing {
 public:
  explicit Narrowing(const ShaftHull::Slice& hull) : hull_(hull) {}

  const ShaftPassage& passage() const { return passage_; }

  void letThroughAbove(EndHeights line) {
    passage_.isShut |= hull_.isBelow(line);
    passage_.isOpen &= hull_.isAbove(line);
  }
  void letThroughBelow(EndHeights line) {
    passage_.isShut |= hull_.isAbove(line);
    passage_.isOpen &= hull_.isBelow(line);
  }

  /// What is beyond a flat portal has left the sector through it, and is nothing to the opening;
  /// likewise what has ended in a sky.
  void addHeights(const Scene& scene, const Sector& sector, const LightOpening& opening,
                  SkyIs sky) {
    const auto takesAll = [sky](const Flat& flat, const std::optional<Slope>& slope) {
      return flat.flatPortal || (sky == SkyIs::TheEnd && flat.isSky && !slope);
    };
    if (takesAll(sector.floor, sector.floorSlope) && opening.zBottom <= scene.zFloor(sector))
      passage_.isShut |= hull_.isBelow(flatLine(opening.zBottom));
    else
      letThroughAbove(flatLine(opening.zBottom));
    if (takesAll(sector.ceiling, sector.ceilingSlope) && opening.zTop >= scene.zCeiling(sector))
      passage_.isShut |= hull_.isAbove(flatLine(opening.zTop));
    else
      letThroughBelow(flatLine(opening.zTop));
  }

  /// Of the sector's own slopes rays meet those that are no skies; of the next sector's all.
  void addSlopes(const Scene& scene, const Sector& sector, const Segment& wall,
                 const LightOpening& opening) {
    const auto isSolid = [](const Flat& flat) { return !flat.isSky && !flat.flatPortal; };
    if (sector.floorSlope || sector.ceilingSlope) {
      const AirLines near = airAlong(scene, wall, hull_.from, hull_.to);
      if (sector.floorSlope && isSolid(sector.floor)) letThroughAbove(near.bottom);
      if (sector.ceilingSlope && isSolid(sector.ceiling)) letThroughBelow(near.top);
    }
    const Sector& next = scene[opening.next];
    if (next.floorSlope || next.ceilingSlope) {
      const AirLines far = airAlong(scene, scene[opening.twin], 1 - hull_.from, 1 - hull_.to);
      if (next.floorSlope) letThroughAbove(far.bottom);
      if (next.ceilingSlope) letThroughBelow(far.top);
    }
  }

  /// Some of what comes to a masked middle texture may meet a hole and some not.
  void addMaskedMiddles(const Scene& scene, const LightOpening& opening) {
    for (const SurfaceId id : scene.maskedMiddlesIn(opening))
      passage_.isOpen &= hull_.isAbove(flatLine(scene.geometryOf(id).zTop)) ||
                         hull_.isBelow(flatLine(scene.geometryOf(id).zBottom));
  }

 private:
  const ShaftHull::Slice& hull_;
  ShaftPassage passage_;
};

}  // namespace

AirLines airAlong(const Scene& scene, const Segment& wall, double from, double to) {
  const AirColumn first = scene.airAt(wall, from);
  const AirColumn last = scene.airAt(wall, to);
  return {{first.zBottom, last.zBottom}, {first.zTop, last.zTop}};
}

ShaftPassage passageThrough(const Scene& scene, const Sector& sector, const Segment& wall,
                            const LightOpening& opening, const ShaftHull::Slice& slice, SkyIs sky) {
  Narrowing narrowing(slice);
  narrowing.addHeights(scene, sector, opening, sky);
  narrowing.addSlopes(scene, sector, wall, opening);
  narrowing.addMaskedMiddles(scene, opening);
  return narrowing.passage();
}

bool haveLeftBefore(const Scene& scene, const Sector& sector, const Segment& wall,
                    const ShaftHull::Slice& slice, SkyIs sky) {
  if (sector.floor.flatPortal && slice.isBelow(flatLine(scene.zFloor(sector)))) return true;
  if (sector.ceiling.flatPortal && slice.isAbove(flatLine(scene.zCeiling(sector)))) return true;
  if (sky == SkyIs::Passed || (!sector.floor.isSky && !sector.ceiling.isSky)) return false;
  const AirLines air = airAlong(scene, wall, slice.from, slice.to);
  return (sector.floor.isSky && slice.isBelow(air.bottom)) ||
         (sector.ceiling.isSky && slice.isAbove(air.top));
}

}  // namespace hearth
