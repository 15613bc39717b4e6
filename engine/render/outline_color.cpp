#include "render/outline_color.h"

#include <cstddef>
#include <variant>

#include "render/segment_colors.h"

namespace hearth {

namespace {

/// On which side of the nearer of two pixels the other one lies.
enum class Neighbour { Left, Right, AboveOrBelow };

bool opensTo(const Flat& flat, const Flat& other) {
  return flat.flatPortal && flat.flatPortal == other.flatPortal;
}

bool partedByFlatPortal(const Sector& a, const Sector& b) {
  return opensTo(a.floor, b.ceiling) || opensTo(a.ceiling, b.floor);
}

/// Seen from the front the loop goes on to the right.
const Segment& besideInLoop(const Scene& scene, SegmentId id, Neighbour side) {
  const Segment& segment = scene[id];
  const Loop& loop = scene[segment.sector].loops[segment.loop];
  const std::size_t place = id.index() - loop.first.index();
  const std::size_t offset = side == Neighbour::Right ? 1 : loop.count - 1;
  return scene[SegmentId(loop.first.index() + (place + offset) % loop.count)];
}

/// Of the edge of a wall. Where it ends at an opening, that is the opening's, too.
Rgb colorOfEdge(const Scene& scene, SegmentId wall, Neighbour side) {
  if (leadsOn(scene, scene[wall]) || side == Neighbour::AboveOrBelow)
    return colorOf(scene, scene[wall]);
  return colorOf(scene, besideInLoop(scene, wall, side));
}

bool isBorderInStack(const Scene& scene, const Surface& a, const Surface& b) {
  return a.segment && a.segment == b.segment &&
         std::holds_alternative<Stack>(scene[*a.segment].wall);
}

/// Of the edge of the nearer surface, beyond which the farther one shows.
Rgb colorOfEdge(const Scene& scene, const Surface& near, const Surface& far, Neighbour side) {
  const bool isSameSector = near.sector == far.sector;
  if (!isSameSector && partedByFlatPortal(scene[near.sector], scene[far.sector]))
    return kFlatPortalColor;
  if (isBorderInStack(scene, near, far)) return kFlatPortalColor;
  if (near.segment && (!isSameSector || far.segment))
    return colorOfEdge(scene, *near.segment, side);
  // A flat ends at walls of its own sector, or at an opening.
  if (!isSameSector) return kWayOnColor;
  const auto wall = near.segment ? near.segment : far.segment;
  return wall ? colorOf(scene, scene[*wall]) : kWallColor;
}

std::optional<Rgb> colorBetween(const Scene& scene, const ShownSurface& a, const ShownSurface& b,
                                bool areInRow) {
  if (!a.surface || !b.surface || a.surface == b.surface) return std::nullopt;
  const bool isFirstNearer = a.depth <= b.depth;
  const Surface& near = scene[isFirstNearer ? *a.surface : *b.surface];
  const Surface& far = scene[isFirstNearer ? *b.surface : *a.surface];
  if (isSky(near.kind) && isSky(far.kind)) return std::nullopt;
  const Neighbour side =
      !areInRow ? Neighbour::AboveOrBelow : (isFirstNearer ? Neighbour::Right : Neighbour::Left);
  return colorOfEdge(scene, near, far, side);
}

}  // namespace

std::optional<Rgb> outlineColor(const Scene& scene, const ShownSurface& pixel,
                                const ShownSurface& left, const ShownSurface& above) {
  if (const auto color = colorBetween(scene, left, pixel, true)) return color;
  return colorBetween(scene, above, pixel, false);
}

}  // namespace hearth
