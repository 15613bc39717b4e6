#include "random_levels/places.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/check.h"

namespace hearth::random_levels {
namespace {

constexpr double kFromWalls = 0.01;  // m, of places that are to be clear of walls
constexpr double kFromFlats = 0.02;  // m
constexpr double kLeastAir = 0.1;    // m between floor and ceiling
constexpr int kAttempts = 200;

/// Whether `next` has a wall between the same vertices with a plain portal back to `s`.
bool leadsBack(const Sector& next, SectorIndex s, VertexId a, VertexId b) {
  for (const Loop& loop : next.loops) {
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const bool isSame =
          loop.vertices[i] == b && loop.vertices[(i + 1) % loop.vertices.size()] == a;
      if (!isSame || loop.walls[i].pieces.size() != 1) continue;
      const auto portals = portalsOf(loop.walls[i]);
      if (portals.size() == 1 && portals[0]->next == s) return true;
    }
  }
  return false;
}

}  // namespace

Places::Places(Random& random, const Model& model, std::set<Feature>& features)
    : random_(random), model_(model), features_(features) {}

/// With a random height, if there is air at `p`.
std::optional<Place> Places::at(SectorIndex s, Vec2 p) {
  const Sector& sector = model_.sectors[s];
  const double low = model_.floorAt(sector, p);
  const double high = model_.ceilingAt(sector, p);
  if (high - low < kLeastAir) return std::nullopt;
  const double z = rounded(random_.real(low + kFromFlats, high - kFromFlats));
  return Place{s, {p.x, p.y, z}};
}

std::optional<Place> Places::inSector(SectorIndex s) {
  const Sector& sector = model_.sectors[s];
  const Face& face = model_.mesh.faces[random_.pickFrom(sector.faces)];
  // One draw a statement: the order in which arguments are evaluated is the compiler's choice.
  Vec2 c = metres(model_.mesh.vertices[random_.pickFrom(face.loops[0])]);
  for (int i = 0; i < 2; ++i) {
    const Vec2 corner = metres(model_.mesh.vertices[random_.pickFrom(face.loops[0])]);
    c = lerp(c, corner, random_.unit());
  }
  const Vec2 p{rounded(c.x), rounded(c.y)};
  if (!model_.coversMap(sector, p)) return std::nullopt;
  if (model_.distanceToWalls(sector, p) < kFromWalls) return std::nullopt;
  return at(s, p);
}

Place Places::anywhere() {
  for (int i = 0; i < 100 * kAttempts; ++i) {
    if (const auto place = inSector(random_.below(model_.sectors.size()))) return *place;
  }
  const bool hasAir = false;
  CHECK(hasAir, model_.sectors.size());
  return {};
}

/// In the opening of a portal that both sides draw alike: there, both see the same.
std::optional<Place> Places::onPortalLine() {
  for (int i = 0; i < kAttempts; ++i) {
    const SectorIndex s = random_.below(model_.sectors.size());
    const Loop& loop = random_.pickFrom(model_.sectors[s].loops);
    const std::size_t w = random_.below(loop.vertices.size());
    const auto portals = portalsOf(loop.walls[w]);
    if (portals.size() != 1 || loop.walls[w].pieces.size() != 1) continue;
    const Sector& next = model_.sectors[portals[0]->next];
    const VertexId v0 = loop.vertices[w];
    const VertexId v1 = loop.vertices[(w + 1) % loop.vertices.size()];
    const Point a = model_.mesh.vertices[v0];
    const Point b = model_.mesh.vertices[v1];
    if (!leadsBack(next, s, v0, v1) || distance(a, b) < 0.1) continue;
    // A half or a quarter of the way is exact, or rounded in the last bit only.
    const Vec2 p = lerp(metres(a), metres(b), random_.pick({0.5, 0.25, 0.75}));
    const auto place = at(s, p);
    if (!place) continue;
    const double z = place->position.z;
    if (z < model_.floorAt(next, p) + kFromFlats || z > model_.ceilingAt(next, p) - kFromFlats) {
      continue;
    }
    return place;
  }
  return std::nullopt;
}

/// Exactly on the line of a wall that runs along an axis, beyond its end: the eye or light sees the
/// wall edge-on.
std::optional<Place> Places::inLineWithWall() {
  for (int i = 0; i < kAttempts; ++i) {
    const auto place = inSector(random_.below(model_.sectors.size()));
    if (!place) continue;
    const Sector& other = random_.pickFrom(model_.sectors);
    const Loop& loop = random_.pickFrom(other.loops);
    const std::size_t w = random_.below(loop.vertices.size());
    const Point a = model_.mesh.vertices[loop.vertices[w]];
    const Point b = model_.mesh.vertices[loop.vertices[(w + 1) % loop.vertices.size()]];
    if (a.x != b.x && a.y != b.y) continue;
    Vec2 p = place->position.xy();
    (a.x == b.x ? p.x : p.y) = a.x == b.x ? metres(a.x) : metres(a.y);
    const Sector& sector = model_.sectors[place->sector];
    if (!model_.coversMap(sector, p) || model_.distanceToWalls(sector, p) < kFromWalls) continue;
    if (const auto moved = at(place->sector, p)) return moved;
  }
  return std::nullopt;
}

/// Above the sky ceiling of a sector, or below its sky floor.
std::optional<Place> Places::outsideSky(bool isAbove) {
  for (int i = 0; i < kAttempts; ++i) {
    auto place = inSector(random_.below(model_.sectors.size()));
    if (!place) continue;
    const Sector& sector = model_.sectors[place->sector];
    const Flat& sky = isAbove ? sector.ceiling : sector.floor;
    if (!sky.isSky) continue;
    const double away = random_.pick({0.5, 0.25, 1.0, 1.75, 3.0});
    place->position.z = metres(sky.z) + (isAbove ? away : -away);
    return place;
  }
  return std::nullopt;
}

RandomLight Places::light() {
  RandomLight light;
  std::optional<Place> place;
  const auto choose = [&](std::optional<Place> found, Feature feature) {
    if (found) features_.insert(feature);
    place = found;
  };
  const double dice = random_.unit();
  const bool isOutside = dice < 0.3;
  if (dice < 0.15) {
    choose(outsideSky(true), Feature::LightAboveSky);
  } else if (dice < 0.3) {
    choose(outsideSky(false), Feature::LightBelowSkyFloor);
  } else if (dice < 0.42) {
    choose(onPortalLine(), Feature::LightOnPortalLine);
  } else if (dice < 0.6) {
    choose(inLineWithWall(), Feature::LightInLineWithWall);
  }
  light.place = place ? *place : anywhere();
  // Where it could be taken to be in two sectors, or is outside of its own, it says which it is.
  const bool isUnique = model_.sectorsAround(light.place.position, 0.002).size() == 1;
  light.namesSector = (isOutside && place) || !isUnique || random_.chance(0.4);
  if (!light.namesSector) features_.insert(Feature::LightWithoutSector);
  light.intensity = random_.pick({60.0, 120.0, 200.0, 255.0, 400.0, 97.5});
  light.falloff = random_.pick({0.0, 0.25, 0.5, 1.0, 2.0, 0.1});
  return light;
}

std::vector<RandomLight> Places::lights(std::size_t count) {
  std::vector<RandomLight> lights;
  for (std::size_t i = 0; i < count; ++i) lights.push_back(light());
  return lights;
}

RandomView Places::lookFrom(const Place& place) {
  RandomView view;
  view.sector = model_.sectors[place.sector].name;
  view.x = place.position.x;
  view.y = place.position.y;
  view.z = place.position.z;
  if (random_.chance(0.3)) {
    view.angle = 45 * static_cast<double>(random_.below(8));
    features_.insert(Feature::ViewAlongAxis);
  } else {
    view.angle = rounded(random_.real(0, 360));
  }
  if (random_.chance(0.4)) {
    view.pitch = random_.pick({-60.0, -30.0, 10.0, 45.0, 60.0, 22.5});
    features_.insert(Feature::ViewUpOrDown);
  }
  view.fov = random_.pick({90.0, 90.0, 60.0, 30.0, 120.0, 150.0, 73.5});
  constexpr std::array<std::array<int, 2>, 8> kSizes{
      {{160, 100}, {160, 100}, {160, 100}, {160, 100}, {161, 99}, {80, 50}, {1, 100}, {33, 1}}};
  const auto& size = random_.pickFrom(kSizes);
  view.width = size[0];
  view.height = size[1];
  return view;
}

std::vector<RandomView> Places::views(std::size_t count) {
  std::vector<RandomView> views;
  for (std::size_t i = 0; i < count; ++i) {
    std::optional<Place> place;
    const double dice = random_.unit();
    if (dice < 0.15) {
      place = onPortalLine();
      if (place) features_.insert(Feature::ViewOnPortalLine);
    } else if (dice < 0.35) {
      place = inLineWithWall();
      if (place) features_.insert(Feature::ViewInLineWithWall);
    }
    views.push_back(lookFrom(place ? *place : anywhere()));
    views.back().name = fmt::format("view{}", i);
  }
  return views;
}

}  // namespace hearth::random_levels
