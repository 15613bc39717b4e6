#include "load/positions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "level/locate.h"
#include "load/suggest.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

BoxTree boxesOf(const Level& level) {
  std::vector<Box> boxes;
  for (const Sector& sector : level.sectors) boxes.push_back(sector.box);
  return BoxTree(boxes);
}

double distanceToWall(const Segment& segment, Vec2 p) {
  return length(nearestOnSegment(segment.p0, segment.p1, p) - p);
}

bool liesInOutline(const Level& level, const Sector& sector, Vec2 p) {
  if (contains(level, sector, p)) return true;
  const auto segments = level.segmentsOf(sector);
  return std::any_of(segments.begin(), segments.end(), [&](const Segment& segment) {
    return distanceToWall(segment, p) <= kPositionSlack;
  });
}

/// Whether `z` is in the endless column above a sector's sky, or below its sky floor.
bool liesInSky(const Sector& sector, double z) {
  return (sector.ceiling.isSky && z > sector.ceiling.z) ||
         (sector.floor.isSky && z < sector.floor.z);
}

bool isMember(const std::vector<SectorId>& members, SectorId sector) {
  return std::find(members.begin(), members.end(), sector) != members.end();
}

/// Whether `p` lies in an opening from one sector to another.
bool opensTo(const Scene& scene, const Sector& sector, SectorId next, Vec3 p) {
  for (const Segment& segment : scene.segmentsOf(sector))
    for (const LightOpening& opening : scene.lightOpeningsOf(segment))
      if (opening.next == next && p.z >= opening.zBottom - kPositionSlack &&
          p.z <= opening.zTop + kPositionSlack && distanceToWall(segment, p.xy()) <= kPositionSlack)
        return true;
  for (const Flat* flat : {&sector.floor, &sector.ceiling}) {
    if (!flat->flatPortal || std::abs(flat->z - p.z) > kPositionSlack) continue;
    const FlatPortal& flatPortal = scene[*flat->flatPortal];
    if (isMember(flat == &sector.floor ? flatPortal.lower : flatPortal.upper, next)) return true;
  }
  return false;
}

/// Metres from `p` to the outline of a sector; 0 inside.
double distanceOnPlan(const Scene& scene, const Sector& sector, Vec2 p) {
  if (contains(scene.level(), sector, p)) return 0;
  double distance = std::numeric_limits<double>::infinity();
  for (const Segment& segment : scene.segmentsOf(sector))
    distance = std::min(distance, distanceToWall(segment, p));
  return distance;
}

/// Metres from `p` to the air of a sector, nearly: its slopes are taken as they are above `p`.
double distanceTo(const Scene& scene, const Sector& sector, Vec3 p) {
  const double aside = distanceOnPlan(scene, sector, p.xy());
  const double above =
      std::max({0.0, scene.airBottom(sector, p.xy()) - p.z, p.z - scene.airTop(sector, p.xy())});
  return std::sqrt(aside * aside + above * above);
}

double distanceToBox(const Sector& sector, Vec2 p) {
  const Vec2 gap{std::max({0.0, sector.box.min.x - p.x, p.x - sector.box.max.x}),
                 std::max({0.0, sector.box.min.y - p.y, p.y - sector.box.max.y})};
  return length(gap);
}

/// The sector of the least `distanceTo`, and that; none of a level without segments.
template <typename DistanceTo>
std::pair<const Sector*, double> nearestTo(const Level& level, Vec2 p, DistanceTo&& distanceTo) {
  const Sector* nearest = nullptr;
  double best = std::numeric_limits<double>::infinity();
  for (const Sector& candidate : level.sectors) {
    if (candidate.segmentCount == 0 || distanceToBox(candidate, p) >= best) continue;
    const double distance = distanceTo(candidate);
    if (distance < best) nearest = &candidate, best = distance;
  }
  return {nearest, best};
}

std::string listed(const Level& level, const std::vector<SectorId>& found) {
  std::vector<std::string> names;
  for (const SectorId id : found) names.push_back(fmt::format("\"{}\"", level[id].name));
  if (names.size() > 8) names.resize(8);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string text(Vec2 p) { return fmt::format("({}, {})", p.x, p.y); }
std::string text(Vec3 p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

}  // namespace

Locator::Locator(const Scene& scene) : scene_(scene), sectors_(boxesOf(scene.level())) {}

std::vector<SectorId> Locator::sectorsAt(Vec3 p) const {
  std::vector<SectorId> found;
  sectors_.query(grown({p.xy(), p.xy()}, kPositionSlack), [&](std::uint32_t i) {
    if (contains(scene_, scene_.level().sectors[i], p, kPositionSlack))
      found.push_back(SectorId(i));
  });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<SectorId> Locator::skySectorsAt(Vec3 p) const {
  std::vector<SectorId> found;
  sectors_.query(grown({p.xy(), p.xy()}, kPositionSlack), [&](std::uint32_t i) {
    const Sector& sector = scene_.level().sectors[i];
    if (liesInSky(sector, p.z) && liesInOutline(scene_.level(), sector, p.xy()))
      found.push_back(SectorId(i));
  });
  std::sort(found.begin(), found.end());
  return found;
}

tl::expected<SectorId, Locator::Failure> Locator::locate(Vec3 p, std::optional<SectorId> sector,
                                                         PositionOf what) const {
  if (sector) {
    const Sector& named = scene_[*sector];
    if (contains(scene_, named, p, kPositionSlack)) return *sector;
    if (what == PositionOf::Light && liesInSky(named, p.z) &&
        liesInOutline(scene_.level(), named, p.xy()))
      return *sector;
    return tl::unexpected(outside(p, sector));
  }
  std::vector<SectorId> found = sectorsAt(p);
  if (found.empty() && what == PositionOf::Light) found = skySectorsAt(p);
  if (found.empty()) return tl::unexpected(outside(p, std::nullopt));
  return choose(p, found);
}

tl::expected<SectorId, Locator::Failure> Locator::locateOnFloor(
    Vec2 p, std::optional<SectorId> sector) const {
  const auto onFloor = [&](SectorId id) { return Vec3{p.x, p.y, scene_.airBottom(scene_[id], p)}; };
  if (sector) return locate(onFloor(*sector), sector, PositionOf::Camera);
  std::vector<SectorId> found;
  sectors_.query(grown({p, p}, kPositionSlack), [&](std::uint32_t i) {
    const Sector& candidate = scene_.level().sectors[i];
    // A floor that is a flat portal bears nothing; what it is open to is found, too.
    if (!candidate.floor.flatPortal && liesInOutline(scene_.level(), candidate, p))
      found.emplace_back(i);
  });
  std::sort(found.begin(), found.end());
  if (found.empty()) return tl::unexpected(outsideOnPlan(p));
  const Vec3 first = onFloor(found.front());
  for (const SectorId other : found)
    if (std::abs(onFloor(other).z - first.z) > kPositionSlack)
      return tl::unexpected(Failure{
          fmt::format("{} lies in several sectors: {}", text(p), listed(scene_.level(), found)),
          "say in which with \"sector\", or how high with \"z\""});
  return choose(first, found);
}

/// Where all of several sectors are open to each other at `p`, directly or through others of them,
/// any of them gives the same picture.
tl::expected<SectorId, Locator::Failure> Locator::choose(Vec3 p,
                                                         const std::vector<SectorId>& found) const {
  std::vector<SectorId> reached{found.front()};
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const SectorId other : found)
      if (!isMember(reached, other) && (opensTo(scene_, scene_[reached[i]], other, p) ||
                                        opensTo(scene_, scene_[other], reached[i], p)))
        reached.push_back(other);
  if (reached.size() == found.size()) return found.front();
  return tl::unexpected(severalAt(p, found));
}

Locator::Failure Locator::severalAt(Vec3 p, const std::vector<SectorId>& found) const {
  return {fmt::format("{} lies in several sectors: {}", text(p), listed(scene_.level(), found)),
          "say in which with \"sector\""};
}

Locator::Failure Locator::outsideOnPlan(Vec2 p) const {
  const auto [nearest, distance] = nearestTo(
      scene_.level(), p, [&](const Sector& sector) { return distanceOnPlan(scene_, sector, p); });
  if (!nearest) return {fmt::format("{} lies in no sector", text(p)), "move it"};
  return {fmt::format("{} lies in no sector; the nearest is \"{}\", {:.6g} m away", text(p),
                      nearest->name, distance),
          "move it inside a sector"};
}

Locator::Failure Locator::outside(Vec3 p, std::optional<SectorId> sector) const {
  const std::vector<SectorId> found = sectorsAt(p);
  const std::string where =
      sector ? fmt::format("outside its sector \"{}\"", scene_[*sector].name) : "in no sector";
  if (!found.empty())
    return {fmt::format("{} lies {}, in \"{}\"", text(p), where, scene_[found.front()].name),
            fmt::format("name that sector, or move it into \"{}\"", scene_[*sector].name)};
  const auto [nearest, best] = nearestTo(scene_.level(), p.xy(), [&](const Sector& candidate) {
    return distanceTo(scene_, candidate, p);
  });
  if (!nearest) return {fmt::format("{} lies {}", text(p), where), "move it"};
  if (contains(scene_.level(), *nearest, p.xy()))
    return {fmt::format("{} lies {}; it is {:.6g} m {} sector \"{}\"", text(p), where, best,
                        p.z > scene_.airTop(*nearest, p.xy()) ? "above the ceiling of"
                                                              : "below the floor of",
                        nearest->name),
            "correct its z"};
  if (sector && nearest->id == *sector)
    return {fmt::format("{} lies {:.6g} m {}", text(p), best, where), "move it inside"};
  return {fmt::format("{} lies {}; the nearest is \"{}\", {:.6g} m away", text(p), where,
                      nearest->name, best),
          "move it inside a sector"};
}

std::optional<SectorId> findSector(const Level& level, std::string_view name) {
  const auto found = std::ranges::find(level.sectors, name, &Sector::name);
  if (found == level.sectors.end()) return std::nullopt;
  return SectorId(static_cast<std::size_t>(found - level.sectors.begin()));
}

tl::expected<SectorId, std::string> locatePosition(const Scene& scene, Vec3 p,
                                                   std::optional<std::string_view> sectorName) {
  const auto sector = sectorName ? findSector(scene.level(), *sectorName) : std::nullopt;
  std::vector<std::string_view> names;
  for (const Sector& each : scene.level().sectors) names.push_back(each.name);
  if (sectorName && !sector)
    return tl::unexpected(fmt::format("there is no sector \"{}\", {}", *sectorName,
                                      suggest(*sectorName, names, "name a sector of the level")));
  const auto found = Locator(scene).locate(p, sector, PositionOf::Camera);
  if (found) return *found;
  return tl::unexpected(found.error().message + ", " + found.error().advice);
}

}  // namespace hearth
