#include "random_levels/thing_places.h"

#include <algorithm>
#include <cmath>

#include "math/trig.h"

namespace hearth::random_levels {
namespace {

constexpr double kLeastAir = 0.1;    // m between floor and ceiling
constexpr double kFromFlats = 0.02;  // m, where slopes are rounded

std::vector<WallOfSector> wallsOf(const Model& model) {
  std::vector<WallOfSector> walls;
  for (SectorIndex s = 0; s < model.sectors.size(); ++s)
    for (const Loop& loop : model.sectors[s].loops)
      for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const VertexId end = loop.vertices[(i + 1) % loop.vertices.size()];
        walls.push_back({s, &loop.walls[i], metres(model.mesh.vertices[loop.vertices[i]]),
                         metres(model.mesh.vertices[end])});
      }
  return walls;
}

}  // namespace

const PortalPiece* onlyPortal(const Wall& wall) {
  return wall.pieces.size() == 1 ? std::get_if<PortalPiece>(&wall.pieces[0].kind) : nullptr;
}

bool isPortal(const WallOfSector& at) { return onlyPortal(*at.wall) != nullptr; }

bool isSolid(const WallOfSector& at) { return at.wall->pieces.size() == 1 && !isPortal(at); }

Vec2 along(double angle) {
  const SinCos turn = sinCosDegrees(angle);
  return {turn.cos, turn.sin};
}

ThingPlaces::ThingPlaces(Random& random, const Model& model, const std::vector<RandomView>& views)
    : random_(random), model_(model), views_(views), walls_(wallsOf(model)) {}

std::optional<Place> ThingPlaces::put(SectorIndex s, Vec2 p, double z) const {
  const Sector& sector = model_.sectors[s];
  const double low = model_.floorAt(sector, p) + (sector.floor.wedge ? kFromFlats : 0);
  const double high = model_.ceilingAt(sector, p) - (sector.ceiling.wedge ? kFromFlats : 0);
  if (high - low < kLeastAir) return std::nullopt;
  return Place{s, {p.x, p.y, std::clamp(rounded(z), low, high)}};
}

bool ThingPlaces::isOnFloor(const Place& place) const {
  const Vec3 p = place.position;
  return std::abs(p.z - model_.floorAt(model_.sectors[place.sector], p.xy())) <= kFromFlats;
}

SectorIndex ThingPlaces::nearSector() {
  if (random_.chance(0.2)) return random_.below(model_.sectors.size());
  const std::string& name = random_.pickFrom(views_).sector;
  const auto found = std::ranges::find(model_.sectors, name, &Sector::name);
  return static_cast<SectorIndex>(found - model_.sectors.begin());
}

std::optional<Vec2> ThingPlaces::before(const WallOfSector& wall, Interval share, Interval metres) {
  const Vec2 onIt = lerp(wall.a, wall.b, random_.real(share.low, share.high));
  const Vec2 p = rounded(onIt + random_.real(metres.low, metres.high) * wall.inward());
  if (!model_.coversMap(model_.sectors[wall.sector], p)) return std::nullopt;
  return p;
}

std::optional<Place> ThingPlaces::beforeEye(double middleAbove) {
  const RandomView& view = random_.pickFrom(views_);
  const double depth = random_.real(0.3, 3);
  const double side = random_.real(-0.6, 0.6) * depth * tanDegrees(std::min(view.fov / 2, 50.0));
  const Vec2 forward = along(view.angle);
  const Vec2 p = rounded(Vec2{view.x, view.y} + depth * forward + side * turned90(forward));
  const double middle = view.z + depth * tanDegrees(view.pitch) + random_.real(-0.3, 0.3);
  const double z = middle - middleAbove;
  std::vector<SectorIndex> sectors;
  for (SectorIndex s = 0; s < model_.sectors.size(); ++s) {
    const Sector& sector = model_.sectors[s];
    if (!model_.coversMap(sector, p)) continue;
    const bool isBeside = model_.floorAt(sector, p) > middle || model_.ceilingAt(sector, p) < z;
    if (!isBeside) sectors.push_back(s);
    if (!isBeside && sector.name == view.sector) sectors.assign(20, s);
  }
  if (sectors.empty()) return std::nullopt;
  return put(random_.pickFrom(sectors), p, z);
}

std::optional<ThingPlaces::AtFlatPortal> ThingPlaces::atFlatPortal() {
  const SectorIndex s = nearSector();
  const Sector& sector = model_.sectors[s];
  if (!sector.ceiling.flatPortal && !sector.floor.flatPortal) return std::nullopt;
  const std::vector<VertexId>& border = sector.loops[0].vertices;
  Vec2 corner = metres(model_.mesh.vertices[random_.pickFrom(border)]);
  for (int i = 0; i < 2; ++i) {
    const double share = random_.unit();
    corner = lerp(corner, metres(model_.mesh.vertices[random_.pickFrom(border)]), share);
  }
  const Vec2 p = rounded(corner);
  if (!model_.coversMap(sector, p)) return std::nullopt;
  return AtFlatPortal{s, p, metres(sector.ceiling.flatPortal ? sector.ceiling.z : sector.floor.z)};
}

std::optional<Place> ThingPlaces::behindMiddle() {
  const auto wall = wallNear([](const WallOfSector& at) {
    const PortalPiece* portal = onlyPortal(*at.wall);
    return portal && portal->maskedMiddle;
  });
  if (!wall) return std::nullopt;
  const SectorIndex next = onlyPortal(*wall->wall)->next;
  const Vec2 onIt = lerp(wall->a, wall->b, random_.real(0.2, 0.8));
  const Vec2 p = rounded(onIt - random_.real(0.05, 0.6) * wall->inward());
  const Sector& sector = model_.sectors[next];
  if (!model_.coversMap(sector, p)) return std::nullopt;
  const double z =
      std::max(model_.floorAt(sector, p), metres(model_.sectors[wall->sector].floor.z));
  return put(next, p, z + random_.pick({0.0, 0.2, 0.6}));
}

}  // namespace hearth::random_levels
