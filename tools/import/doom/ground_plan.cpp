#include "import/doom/ground_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hearth::doom {

tl::expected<GroundPlan, std::string> GroundPlan::of(const Map& map, Doors doors,
                                                     Findings& findings) {
  auto plane = findRegions(map, findings);
  if (!plane) return tl::unexpected(std::move(plane.error()));
  if (plane->regions.empty())
    return tl::unexpected(std::string("its lines enclose nothing: there is no level in it"));
  return GroundPlan(map, *std::move(plane), heightsOf(map, doors), findings);
}

GroundPlan::GroundPlan(const Map& map, Regions plane, std::vector<Heights> heights,
                       Findings& findings)
    : map_(&map), plane_(std::move(plane)), heights_(std::move(heights)) {
  mendHeights(findings);
  nameRegions();
}

void GroundPlan::mendHeights(Findings& findings) {
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    if (heights_[i].ceiling >= heights_[i].floor) continue;
    findings.push_back({Outcome::Repaired, Part::Sector, i,
                        "its ceiling lies below its floor: it is closed at the floor"});
    heights_[i].ceiling = heights_[i].floor;
  }
}

void GroundPlan::nameRegions() {
  std::vector<int> parts(map_->sectors.size());
  for (const Region& region : plane_.regions) {
    const int part = ++parts[region.sector];
    names_.push_back(part == 1 ? fmt::format("{}", region.sector)
                               : fmt::format("{}.{}", region.sector, part));
  }
}

Space GroundPlan::spaceOf(std::uint32_t region) const {
  const Heights& heights = heights_[plane_.regions[region].sector];
  const Sector& sector = sectorOf(region);
  return {heights.floor * kUnit, heights.ceiling * kUnit, sector.ceilingFlat == kSkyFlat,
          sector.floorFlat == kSkyFlat};
}

bool GroundPlan::isPortal(std::uint32_t h) const {
  const auto isTwoSided = [](const HalfEdge& side) { return side.face && side.face->isTwoSided; };
  return behind(h).region && (isTwoSided(halfEdge(h)) || isTwoSided(behind(h)));
}

std::vector<ShownPart> GroundPlan::shownParts(std::uint32_t h) const {
  const Face& face = halfEdge(h).face ? *halfEdge(h).face : *behind(h).face;
  if (!isPortal(h)) return {solidPart(h, face)};
  const Side& side = map_->sides[face.side];
  const Space own = spaceOf(*halfEdge(h).region);
  const Space next = spaceOf(*behind(h).region);
  std::vector<ShownPart> parts;
  // Between two skies, sky shows. What a wall above all openings shows hangs down to its floor.
  if (next.floor > own.floor && !(own.isOverSky && next.isOverSky))
    parts.push_back(
        {WallPart::Lower, own.floor, std::min(next.floor, own.ceiling), &face, side.lower});
  const double bottom = std::max(own.floor, next.floor);
  const double top = std::min(own.ceiling, next.ceiling);
  if (hasMaskedMiddle(h) && bottom < top)
    parts.push_back({WallPart::Middle, bottom, top, &face, side.middle});
  if (std::max(next.ceiling, next.floor) < own.ceiling && !(own.isUnderSky && next.isUnderSky))
    parts.push_back(
        {WallPart::Upper, std::max(next.ceiling, own.floor), own.ceiling, &face, side.upper});
  return parts;
}

/// What a side has that is not there is seen from nowhere.
bool GroundPlan::hasMaskedMiddle(std::uint32_t h) const {
  const auto& face = halfEdge(h).face;
  return face && face->isTwoSided && map_->sides[face->side].middle != kNoTexture;
}

ShownPart GroundPlan::solidPart(std::uint32_t h, const Face& face) const {
  const Side& side = map_->sides[face.side];
  const Space own = spaceOf(*halfEdge(h).region);
  ShownPart part{WallPart::Solid, own.floor, own.ceiling, &face, side.middle};
  for (const std::string* other : {&side.upper, &side.lower})
    if (part.texture == kNoTexture) part.texture = *other;
  return part;
}

}  // namespace hearth::doom
