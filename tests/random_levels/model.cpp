#include "random_levels/model.h"

#include <algorithm>

namespace hearth::random_levels {

double Model::floorAt(const Sector& sector, Vec2 p) const {
  return metres(sector.floor.z) + (sector.floor.wedge ? sector.floor.wedge->at(p) : 0);
}

double Model::ceilingAt(const Sector& sector, Vec2 p) const {
  return metres(sector.ceiling.z) - (sector.ceiling.wedge ? sector.ceiling.wedge->at(p) : 0);
}

bool Model::coversMap(const Sector& sector, Vec2 p) const {
  return std::any_of(sector.faces.begin(), sector.faces.end(),
                     [&](FaceId f) { return contains(mesh, mesh.faces[f], p); });
}

double Model::distanceToWalls(const Sector& sector, Vec2 p) const {
  double nearest = 1e9;
  for (const Loop& loop : sector.loops) {
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const Vec2 a = metres(mesh.vertices[loop.vertices[i]]);
      const Vec2 b = metres(mesh.vertices[loop.vertices[(i + 1) % loop.vertices.size()]]);
      nearest = std::min(nearest, distanceToSegment(p, a, b));
    }
  }
  return nearest;
}

std::vector<SectorIndex> Model::sectorsAround(Vec3 p, double margin) const {
  std::vector<SectorIndex> result;
  for (SectorIndex s = 0; s < sectors.size(); ++s) {
    const Sector& sector = sectors[s];
    if (p.z < floorAt(sector, p.xy()) - margin || p.z > ceilingAt(sector, p.xy()) + margin) {
      continue;
    }
    if (coversMap(sector, p.xy()) || distanceToWalls(sector, p.xy()) < margin) result.push_back(s);
  }
  return result;
}

double Model::floorArea(const Sector& sector) const {
  double area = 0;
  for (const FaceId f : sector.faces) area += areaOf(mesh, mesh.faces[f]);
  return area;
}

std::vector<const PortalPiece*> portalsOf(const Wall& wall) {
  std::vector<const PortalPiece*> portals;
  for (const Piece& piece : wall.pieces) {
    if (const auto* portal = std::get_if<PortalPiece>(&piece.kind)) portals.push_back(portal);
  }
  return portals;
}

}  // namespace hearth::random_levels
