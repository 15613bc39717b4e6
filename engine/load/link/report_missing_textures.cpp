#include <fmt/format.h>

#include <set>
#include <tuple>

#include "load/link/link.h"

namespace hearth {

namespace {

/// Which flat of the next sector lets a step show, and where the step is.
struct StepWords {
  std::string_view flat;
  std::string_view lies;
  std::string_view where;
  std::string_view key;
};

StepWords wordsOf(SurfaceKind step) {
  if (step == SurfaceKind::LowerStep || step == SurfaceKind::StackLowerStep)
    return {"floor", "higher", "below", "lower"};
  return {"ceiling", "lower", "above", "upper"};
}

class MissingTextureReporter {
 public:
  MissingTextureReporter(const Linking& linking, Report& report)
      : linking_(linking), report_(report) {}

  void tell(const MissingTexture& missing) {
    const Segment& segment = linking_.level[missing.segment];
    const std::optional<SectorId> next = targetOf(segment.wall, missing.subWall);
    if (linking_.isDoubtful[segment.sector.index()]) return;
    if (next && linking_.isDoubtful[next->index()]) return;
    if (isSidewall(missing.kind) && next)
      tellSidewall(*next, segment.sector, missing.kind == SurfaceKind::FloorSidewall);
    else
      tellStep(missing, next);
  }

 private:
  void tellSidewall(SectorId sloped, SectorId seenFrom, bool isFloor) {
    if (!sidewalls_.insert({sloped, isFloor}).second) return;
    const SectorDescription& sector = linking_.description.sectors[sloped.index()];
    report_.error((isFloor ? sector.slopeFloor : sector.slopeCeil)->place,
                  fmt::format("sector \"{}\" sees the side of this slope, which has no texture",
                              linking_.level[seenFrom].name),
                  "give the slope a \"sidewall\"");
  }

  void tellStep(const MissingTexture& missing, std::optional<SectorId> next) {
    const std::uint32_t edge = linking_.edgeOf[missing.segment.index()];
    if (!steps_.insert({edge, missing.subWall, missing.kind}).second) return;
    const WallDescription& wall = linking_.describedWall(missing.segment);
    const SectorId here = linking_.level[missing.segment].sector;
    const bool isOfGrid = linking_.description.sectors[here.index()].isOfGrid;
    // All walls towards cells of one entry wear its texture.
    if (isOfGrid && !gridSteps_.insert({wall.place, missing.kind}).second) return;
    const StackDescription* stack = std::get_if<StackDescription>(&wall.kind);
    const StepWords words = wordsOf(missing.kind);
    report_.error(stack ? stack->subWalls[missing.subWall].place : wall.place,
                  fmt::format("the {} of sector \"{}\" is {}{}: the wall {} the opening "
                              "shows and has no texture",
                              words.flat, next ? linking_.level[*next].name : "", words.lies,
                              heightsOf(missing, next), words.where),
                  isOfGrid ? fmt::format("give this entry \"{}\"", words.key)
                           : fmt::format("give the wall \"{}\" or \"texture\"", words.key));
  }

  /// Of the two flats, where these are all that makes the step: one of them may be the mistake.
  std::string heightsOf(const MissingTexture& missing, std::optional<SectorId> next) const {
    const bool isStep =
        missing.kind == SurfaceKind::LowerStep || missing.kind == SurfaceKind::UpperStep;
    if (!next || !isStep) return "";
    const Sector& here = linking_.level[linking_.level[missing.segment].sector];
    const Sector& there = linking_.level[*next];
    const bool isFloor = missing.kind == SurfaceKind::LowerStep;
    if (isFloor ? here.floorSlope || there.floorSlope : here.ceilingSlope || there.ceilingSlope)
      return "";
    const SectorGeometry& own = linking_.scene().geometryOf(here);
    const SectorGeometry& other = linking_.scene().geometryOf(there);
    return fmt::format(" ({} m, here {} m)", isFloor ? other.zFloor : other.zCeiling,
                       isFloor ? own.zFloor : own.zCeiling);
  }

  const Linking& linking_;
  Report& report_;
  std::set<std::pair<SectorId, bool>> sidewalls_;
  std::set<std::tuple<std::uint32_t, std::uint32_t, SurfaceKind>> steps_;
  std::set<std::pair<Place, SurfaceKind>> gridSteps_;
};

}  // namespace

void reportMissingTextures(const Linking& linking, std::span<const MissingTexture> missing,
                           Report& report) {
  MissingTextureReporter reporter(linking, report);
  for (const MissingTexture& each : missing) reporter.tell(each);
}

}  // namespace hearth
