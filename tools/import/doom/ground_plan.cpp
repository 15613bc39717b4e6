#include "import/doom/ground_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hearth::doom {

namespace {

std::vector<Heights> mendedHeights(const Map& map, Doors doors, Findings& findings) {
  std::vector<Heights> heights = heightsOf(map, doors);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (heights[i].ceiling >= heights[i].floor) continue;
    findings.push_back({Outcome::Repaired, Part::Sector, i,
                        "its ceiling lies below its floor: it is closed at the floor"});
    heights[i].ceiling = heights[i].floor;
  }
  return heights;
}

/// By line, how many walls it is at which a player can start something: before its front, or, of
/// those that are crossed, on either side.
std::map<std::uint32_t, std::size_t> countStartingWalls(const Map& map, const Regions& plane) {
  std::map<std::uint32_t, std::size_t> counts;
  for (std::uint32_t h = 0; h < plane.halfEdges.size(); ++h) {
    const auto& face = plane.halfEdges[h].face;
    if (!face || !plane.halfEdges[h].region) continue;
    const LineType* type = findLineType(map.lines[face->line].special);
    const bool isCrossed = type && type->activation == Activation::Walk;
    if (isCrossed ? plane.isPortal(h) : face->side == map.lines[face->line].sides[0])
      ++counts[face->line];
  }
  return counts;
}

void keepReachable(MapMovers& movers, const Map& map, const Regions& plane) {
  const std::map<std::uint32_t, std::size_t> walls = countStartingWalls(map, plane);
  std::set<std::uint32_t> sectors;
  for (const Region& region : plane.regions) sectors.insert(region.sector);
  movers.keep(
      [&](std::uint32_t line) {
        const auto found = walls.find(line);
        return found == walls.end() ? std::size_t{0} : found->second;
      },
      [&](std::uint32_t sector) { return sectors.contains(sector); });
}

/// Of a part that shows at several ends the first that has height counts.
void addPart(ShownPart part, std::vector<ShownPart>& parts) {
  const auto known = std::ranges::find(parts, part.part, &ShownPart::part);
  if (known == parts.end())
    parts.push_back(std::move(part));
  else if (known->bottom == known->top)
    *known = std::move(part);
}

void tellOf(const MapMovers& movers, Findings& findings) {
  for (const LineFate& fate : movers.lines)
    if (!fate.isImported())
      findings.push_back({Outcome::Dropped, Part::Line, fate.line, fate.reason});
  findings.insert(findings.end(), movers.findings.begin(), movers.findings.end());
}

}  // namespace

tl::expected<GroundPlan, std::string> GroundPlan::of(const Map& map, Doors doors,
                                                     Findings& findings) {
  std::vector<Heights> heights = mendedHeights(map, doors, findings);
  MapMovers movers = doors == Doors::Moving ? doom::moversOf(map, heights) : MapMovers{};
  auto plane = findRegions(map, movers.starters(), findings);
  if (!plane) return tl::unexpected(std::move(plane.error()));
  if (plane->regions.empty())
    return tl::unexpected(std::string("its lines enclose nothing: there is no level in it"));
  keepReachable(movers, map, *plane);
  tellOf(movers, findings);
  return GroundPlan(map, *std::move(plane), std::move(heights), std::move(movers));
}

GroundPlan::GroundPlan(const Map& map, Regions plane, std::vector<Heights> heights,
                       MapMovers movers)
    : map_(&map),
      plane_(std::move(plane)),
      heights_(std::move(heights)),
      movers_(std::move(movers)) {
  nameRegions();
  indexMovers();
}

void GroundPlan::nameRegions() {
  regionsOf_.resize(map_->sectors.size());
  for (std::uint32_t i = 0; i < plane_.regions.size(); ++i) {
    const std::uint32_t sector = plane_.regions[i].sector;
    regionsOf_[sector].push_back(i);
    const std::size_t part = regionsOf_[sector].size();
    names_.push_back(part == 1 ? fmt::format("{}", sector) : fmt::format("{}.{}", sector, part));
  }
}

void GroundPlan::indexMovers() {
  moversOf_.resize(map_->sectors.size());
  for (std::size_t i = 0; i < movers_.movers.size(); ++i) {
    for (const std::uint32_t sector : movers_.movers[i].sectors) moversOf_[sector].push_back(i);
    for (const std::uint32_t line : movers_.movers[i].lines) startedBy_[line].push_back(i);
  }
}

std::vector<std::size_t> GroundPlan::startedBy(std::uint32_t line) const {
  const auto found = startedBy_.find(line);
  return found == startedBy_.end() ? std::vector<std::size_t>{} : found->second;
}

Space GroundPlan::spaceAt(std::uint32_t region, std::span<const std::size_t> moved) const {
  Heights heights = heights_[plane_.regions[region].sector];
  for (const std::size_t index : moversOf(region)) {
    if (std::ranges::find(moved, index) == moved.end()) continue;
    const MapMover& mover = movers_.movers[index];
    (mover.part == FlatPart::Floor ? heights.floor : heights.ceiling) = mover.motion.to;
  }
  const Sector& sector = sectorOf(region);
  return {heights.floor * kUnit, heights.ceiling * kUnit, sector.ceilingFlat == kSkyFlat,
          sector.floorFlat == kSkyFlat};
}

Space GroundPlan::lastingSpaceOf(std::uint32_t region) const {
  Space space = spaceOf(region);
  const Space moved = spaceAt(region, moversOf(region));
  space.floor = std::max(space.floor, moved.floor);
  space.ceiling = std::min(space.ceiling, moved.ceiling);
  return space;
}

std::vector<ShownPart> GroundPlan::partsAtAnyEnd(std::uint32_t h) const {
  std::vector<std::size_t> movers = moversOf(*halfEdge(h).region);
  if (isPortal(h)) {
    const std::vector<std::size_t>& behindIt = moversOf(*behind(h).region);
    movers.insert(movers.end(), behindIt.begin(), behindIt.end());
  }
  std::vector<ShownPart> parts = shownParts(h);
  for (std::uint32_t ends = 1; ends < 1U << movers.size(); ++ends) {
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < movers.size(); ++i)
      if ((ends >> i & 1U) != 0) moved.push_back(movers[i]);
    for (ShownPart& part : partsAt(h, moved)) addPart(std::move(part), parts);
  }
  return parts;
}

std::vector<ShownPart> GroundPlan::partsAt(std::uint32_t h,
                                           std::span<const std::size_t> moved) const {
  const Face& face = halfEdge(h).face ? *halfEdge(h).face : *behind(h).face;
  const Space own = spaceAt(*halfEdge(h).region, moved);
  if (!isPortal(h)) return {solidPart(face, own)};
  const Side& side = map_->sides[face.side];
  const Space next = spaceAt(*behind(h).region, moved);
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

ShownPart GroundPlan::solidPart(const Face& face, const Space& own) const {
  const Side& side = map_->sides[face.side];
  ShownPart part{WallPart::Solid, own.floor, own.ceiling, &face, side.middle};
  for (const std::string* other : {&side.upper, &side.lower})
    if (part.texture == kNoTexture) part.texture = *other;
  return part;
}

}  // namespace hearth::doom
