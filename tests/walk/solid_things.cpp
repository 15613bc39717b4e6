#include "walk_tests/solid_things.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "level/locate.h"
#include "level/thing_bodies.h"
#include "math/predicates.h"
#include "random_levels/random.h"
#include "walk_tests/starts.h"

namespace hearth::random_walks {

namespace {

using random_levels::Random;

/// The corners of a triangle round the origin of the plan, which is the middle of them.
std::array<Vec2, 3> triangle(Random& random) {
  const auto corner = [&] { return Vec2{random.real(-0.7, 0.7), random.real(-0.7, 0.7)}; };
  const Vec2 a = corner();
  const Vec2 b = random.chance(0.3) ? a : corner();
  return {a, b, Vec2{} - a - b};
}

void addSprite(Level& level, const SolidThing& thing) {
  Sprite& sprite = level.sprites.emplace_back();
  sprite.position = thing.position;
  sprite.sector = thing.sector;
  sprite.body = SpriteBody{thing.radius, thing.zTop - thing.position.z};
}

void addMesh(Level& level, const SolidThing& thing) {
  Mesh& mesh = level.meshes.emplace_back();
  mesh.position = thing.position;
  mesh.sector = thing.sector;
  mesh.firstFace = static_cast<std::uint32_t>(level.meshFaces.size());
  mesh.faceCount = 1;
  MeshFace& face = level.meshFaces.emplace_back();
  for (std::size_t i = 0; i < thing.corners.size(); ++i)
    face.corners[i] = {thing.corners[i].x, thing.corners[i].y,
                       i == 1 ? thing.zTop : thing.position.z};
}

}  // namespace

double apart(const SolidThing& thing, Vec2 feet, double radius) {
  double distance = kInfinity;
  double turns = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 a = thing.corners[i];
    const Vec2 b = thing.corners[(i + 1) % 3];
    distance = std::min(distance, length(nearestOnSegment(a, b, feet) - feet));
    turns += orientation(a, b, feet);
  }
  const bool isInside = std::abs(turns) == 3;
  return (isInside ? -distance : distance) - thing.radius - radius;
}

bool isIn(const SolidThing& thing, const Walker& walker, const Body& body) {
  return apart(thing, walker.feet.xy(), body.radius) < 0 && walker.feet.z < thing.zTop &&
         thing.position.z < walker.feet.z + body.height;
}

std::vector<SolidThing> addSolidThings(LoadedLevel& loaded, const RandomLevel& random, int count) {
  std::vector<SolidThing> things;
  Random choices(random.views.size() + loaded.level.segments.size());
  for (int i = 0; i < count; ++i) {
    const RandomView& view = choices.pickFrom(random.views);
    const auto sector = sectorNamed(loaded.level, view.sector);
    const Vec2 p = Vec2{view.x, view.y} + Vec2{choices.real(-1, 1), choices.real(-1, 1)};
    if (!sector || !contains(loaded.level, loaded.level[*sector], p)) continue;
    const double zBottom = loaded.scene().airBottom(loaded.level[*sector], p);
    const double room = loaded.scene().airTop(loaded.level[*sector], p) - zBottom;
    const double z = zBottom + (choices.chance(0.5) ? 0 : room * choices.unit());
    SolidThing thing{*sector, {p.x, p.y, z}, {p, p, p}, 0, z + choices.real(0.05, 2)};
    if (i % 2 == 0) {
      thing.radius = choices.real(0.05, 0.7);
      addSprite(loaded.level, thing);
    } else {
      std::ranges::transform(triangle(choices), thing.corners.begin(),
                             [p](Vec2 corner) { return p + corner; });
      addMesh(loaded.level, thing);
    }
    things.push_back(thing);
  }
  addBodies(loaded.level, loaded.geometry);
  return things;
}

}  // namespace hearth::random_walks
