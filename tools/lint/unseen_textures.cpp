#include <fmt/format.h>

#include <set>

#include "lint/authored_wall.h"
#include "lint/sector_graph.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr std::string_view kAdvice = "leave it out, or give the sectors the heights that show it";

bool isLowerStep(SurfaceKind kind) {
  return kind == SurfaceKind::LowerStep || kind == SurfaceKind::StackLowerStep;
}

bool isUpperStep(SurfaceKind kind) {
  return kind == SurfaceKind::UpperStep || kind == SurfaceKind::StackUpperStep;
}

/// Asks for each texture of a step or opening whether some surface wears it. One may be given to
/// many walls, as the `upper` of a wall that stands for all of a loop, or to both steps of a wall.
class UnseenFinder {
 public:
  UnseenFinder(const LintedLevel& linted, Findings& findings)
      : linted_(linted), findings_(findings), moving_(linted.level()) {
    for (const SurfaceId surface : linted.scene().shownSurfaces()) wear(surface);
  }

  void lookAtWall(const Segment& segment, const WallDescription& wall) {
    const Sector& sector = linted_.level()[segment.sector];
    if (isClosed(sector) || moving_.has(segment)) return;
    if (const auto* portal = std::get_if<PortalDescription>(&wall.kind))
      lookAtPortal(sector, *portal);
    if (const auto* stack = std::get_if<StackDescription>(&wall.kind))
      for (const SubWallDescription& part : stack->subWalls)
        if (const auto* portal = std::get_if<PortalDescription>(&part.kind))
          lookAtPortal(sector, *portal);
  }

 private:
  void wear(SurfaceId id) {
    const Surface& surface = linted_.level()[id];
    const bool isMiddle = surface.kind == SurfaceKind::MaskedMiddle;
    if (!isMiddle && !isLowerStep(surface.kind) && !isUpperStep(surface.kind)) return;
    const PortalDescription& portal =
        *authoredWallAt(linted_, *surface.segment, linted_.scene().geometryOf(id).zBottom).portal;
    const auto& worn =
        isMiddle ? portal.maskedMiddle : (isLowerStep(surface.kind) ? portal.lower : portal.upper);
    worn_.insert(worn->name.place);
  }

  /// A door, which may be meant to open.
  static bool isClosed(const Sector& sector) {
    return sector.ceiling.z - sector.floor.z <= kAuthorNoise;
  }

  /// A wedge of the sector hides steps that are there.
  void lookAtPortal(const Sector& sector, const PortalDescription& portal) {
    if (portal.maskedMiddle && !sector.ceilingSlope && !sector.floorSlope)
      lookAtPart(*portal.maskedMiddle, "middle",
                 fmt::format("none of it hangs in an opening to sector \"{}\"", portal.next.name));
    const bool isOne =
        portal.upper && portal.lower && portal.upper->name.place == portal.lower->name.place;
    if (isOne && !sector.floorSlope && !sector.ceilingSlope)
      return lookAtPart(*portal.upper, "texture",
                        fmt::format("there is no step to sector \"{}\"", portal.next.name));
    if (isOne) return;
    if (portal.upper && !sector.ceilingSlope)
      lookAtPart(*portal.upper, "upper",
                 fmt::format("the ceiling of sector \"{}\" is not lower", portal.next.name));
    if (portal.lower && !sector.floorSlope)
      lookAtPart(*portal.lower, "lower",
                 fmt::format("the floor of sector \"{}\" is not higher", portal.next.name));
  }

  void lookAtPart(const TextureDescription& texture, std::string_view key,
                  const std::string& reason) {
    if (worn_.contains(texture.name.place)) return;
    findings_.add(FindingKind::UnseenTexture, texture.name.place,
                  fmt::format("this \"{}\" never shows: {}", key, reason), kAdvice);
  }

  const LintedLevel& linted_;
  Findings& findings_;
  MovingWalls moving_;  ///< what shows at these changes
  std::set<Place> worn_;
};

}  // namespace

void findUnseenTextures(const LintedLevel& linted, Findings& findings) {
  UnseenFinder finder(linted, findings);
  for (const Segment& segment : linted.level().segments)
    finder.lookAtWall(segment, linted.source.wall(segment.id));
}

}  // namespace hearth
