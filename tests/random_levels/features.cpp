#include "random_levels/features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace hearth::random_levels {
namespace {

/// A wall with its place: sector, loop and number of its first vertex.
struct WallAt {
  SectorIndex sector;
  const Wall* wall;
  VertexId a;
  VertexId b;
};

class FeatureFinder {
 public:
  explicit FeatureFinder(const Model& model) : model_(model) {
    for (SectorIndex s = 0; s < model.sectors.size(); ++s) {
      for (const Loop& loop : model.sectors[s].loops) {
        for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
          const VertexId end = loop.vertices[(i + 1) % loop.vertices.size()];
          walls_.push_back({s, &loop.walls[i], loop.vertices[i], end});
        }
      }
    }
  }

  std::set<Feature> find() {
    for (const Sector& sector : model_.sectors) {
      findShape(sector);
      findSpelling(sector);
      findWedge(sector, sector.floor, Feature::SlopedFloor);
      findWedge(sector, sector.ceiling, Feature::SlopedCeiling);
    }
    for (const WallAt& wall : walls_) {
      findStack(wall);
      for (const PortalPiece* portal : portalsOf(*wall.wall)) findBorder(wall, *portal);
      for (const Piece& piece : wall.wall->pieces) findPiece(wall, piece);
    }
    findSharedVertices();
    findFlatPortals();
    findOverlaps();
    findDeepChain();
    return features_;
  }

 private:
  void note(Feature feature, bool isThere = true) {
    if (isThere) features_.insert(feature);
  }
  Point point(VertexId v) const { return model_.mesh.vertices[v]; }

  // ---- shapes

  void findShape(const Sector& sector) {
    const std::vector<VertexId>& border = sector.loops[0].vertices;
    for (std::size_t i = 0; i < border.size(); ++i) {
      const Point a = point(border[i]);
      const Point b = point(border[(i + 1) % border.size()]);
      const Point c = point(border[(i + 2) % border.size()]);
      note(Feature::NonConvexSector, cross(b - a, c - b) < 0);
    }
    for (std::size_t i = 0; i < sector.loops.size(); ++i) {
      findNearVertices(sector.loops[i]);
      if (i > 0) findHole(sector.loops[i]);
      for (std::size_t j = 0; j < i; ++j) findTouch(sector.loops[i], sector.loops[j], j == 0);
    }
    note(Feature::ClosedDoor, sector.height() == 0);
  }

  void findHole(const Loop& hole) {
    const bool isSolid = std::all_of(hole.walls.begin(), hole.walls.end(),
                                     [](const Wall& wall) { return portalsOf(wall).empty(); });
    note(isSolid ? Feature::Pillar : Feature::FilledInnerLoop);
  }

  bool areNear(VertexId a, VertexId b) const {
    return a != b && distance(point(a), point(b)) < 0.051;
  }

  void findNearVertices(const Loop& loop) {
    for (const VertexId a : loop.vertices) {
      for (const VertexId b : loop.vertices) note(Feature::NearVerticesInLoop, areNear(a, b));
    }
  }

  void findTouch(const Loop& inner, const Loop& other, bool isBorder) {
    for (const VertexId v : inner.vertices) {
      for (std::size_t i = 0; i < other.vertices.size(); ++i) {
        const VertexId w = other.vertices[i];
        const Point d = point(other.vertices[(i + 1) % other.vertices.size()]) - point(w);
        const Point p = point(v) - point(w);
        const bool isOnWall = cross(d, p) == 0 && dot(d, p) > 0 && dot(d, p) < dot(d, d);
        note(Feature::NearVerticesBetweenLoops, areNear(v, w));
        note(isBorder ? Feature::InnerLoopAtBorderVertex : Feature::InnerLoopsTouch, v == w);
        note(isBorder ? Feature::InnerLoopAtBorderWall : Feature::InnerLoopsTouch, isOnWall);
      }
    }
  }

  void findSharedVertices() {
    std::map<VertexId, std::set<SectorIndex>> sectors;
    for (const WallAt& wall : walls_) sectors[wall.a].insert(wall.sector);
    for (const auto& [vertex, around] : sectors) note(Feature::SharedVertex, around.size() >= 4);
  }

  // ---- walls

  void findStack(const WallAt& at) {
    const std::vector<Piece>& pieces = at.wall->pieces;
    std::set<SectorIndex> nexts;
    for (const PortalPiece* portal : portalsOf(*at.wall)) nexts.insert(portal->next);
    note(Feature::StackToSeveralSectors, nexts.size() > 1);
    const auto isSolid = [&](std::size_t i) {
      return std::holds_alternative<SolidPiece>(pieces[i].kind);
    };
    for (std::size_t i = 0; i + 2 < pieces.size(); ++i) {
      const bool isMixed = isSolid(i) == isSolid(i + 2) && isSolid(i) != isSolid(i + 1);
      if (!isMixed) continue;
      note(isSolid(i) ? Feature::SolidPortalSolid : Feature::PortalSolidPortal);
    }
    if (pieces.size() < 2) return;
    for (const SectorIndex next : nexts) {
      const Sector& other = model_.sectors[next];
      note(Feature::SlopeBesideStack, other.floor.wedge || other.ceiling.wedge);
    }
  }

  void findPiece(const WallAt& at, const Piece& piece) {
    const auto* portal = std::get_if<PortalPiece>(&piece.kind);
    if (!portal) return findTexture(std::get<SolidPiece>(piece.kind).texture);
    const Sector& next = model_.sectors[portal->next];
    note(Feature::StepUp, next.floor.z > piece.bottom);
    note(Feature::StepDown, next.ceiling.z < piece.top);
    note(Feature::StepsFillRange,
         std::max(next.floor.z, piece.bottom) >= std::min(next.ceiling.z, piece.top) &&
             piece.bottom < piece.top);
    note(Feature::UpperAndLower, portal->upper && portal->lower);
    note(Feature::PortalWithoutTexture, !portal->texture && !portal->upper && !portal->lower);
    note(Feature::MiddleTexture, portal->maskedMiddle.has_value());
    note(Feature::MiddleInStack, portal->maskedMiddle && at.wall->pieces.size() > 1);
    for (const auto& texture :
         {portal->texture, portal->upper, portal->lower, portal->maskedMiddle}) {
      if (texture) findTexture(*texture);
    }
    const Sector& here = model_.sectors[at.sector];
    note(Feature::ContinuingSlope, areContinuous(at, here, next));
  }

  /// `at` leads to `portal.next`: what the two sectors are to each other, and what leads back.
  void findBorder(const WallAt& at, const PortalPiece& portal) {
    const Sector& here = model_.sectors[at.sector];
    const Sector& next = model_.sectors[portal.next];
    note(Feature::EqualFloors, here.floor.z == next.floor.z);
    note(Feature::EqualCeilings, here.ceiling.z == next.ceiling.z);
    note(Feature::CeilingAtNeighboursFloor, here.ceiling.z == next.floor.z);
    const bool areSkies = here.ceiling.isSky && next.ceiling.isSky;
    note(Feature::SkyStep, areSkies && here.ceiling.z != next.ceiling.z);
    note(Feature::NeighbouringSkyFloors, here.floor.isSky && next.floor.isSky);
    bool hasWayBack = false;
    bool hasSameEnds = false;
    for (const WallAt& other : walls_) {
      if (other.sector != portal.next || !liesOpposite(at, other)) continue;
      hasSameEnds |= other.a == at.b && other.b == at.a;
      for (const PortalPiece* back : portalsOf(*other.wall)) {
        hasWayBack |= back->next == at.sector;
        note(Feature::MiddlesBackToBack,
             portal.maskedMiddle && back->maskedMiddle && back->next == at.sector);
      }
    }
    note(Feature::OneWayPortal, !hasWayBack);
    note(Feature::WallsSplitDifferently, !hasSameEnds);
  }

  /// Whether the two walls run along each other, the opposite way, for more than a point.
  bool liesOpposite(const WallAt& wall, const WallAt& other) const {
    const Point d = point(wall.b) - point(wall.a);
    const Point p = point(other.b) - point(wall.a);
    const Point q = point(other.a) - point(wall.a);
    if (cross(d, p) != 0 || cross(d, q) != 0 || dot(d, q) <= dot(d, p)) return false;
    return dot(d, q) > 0 && dot(d, p) < dot(d, d);
  }

  // ---- slopes

  void findWedge(const Sector& sector, const Flat& flat, Feature feature) {
    if (!flat.wedge) return;
    const Wedge& wedge = *flat.wedge;
    const std::vector<VertexId>& border = sector.loops[0].vertices;
    note(feature);
    note(Feature::SlopedTriangle, border.size() == 3);
    note(Feature::SlopeOfManyVertices, border.size() >= 6);
    note(Feature::SlopeWithNulls, !wedge.nulls.empty());
    note(Feature::RelativeSlope, wedge.isRelative);
    note(Feature::SidewallZref, wedge.sidewall.zref.has_value());
    note(Feature::LevelSlope, length(wedge.gradient) == 0);
    findTexture(wedge.sidewall);
    for (const VertexId v : border) {
      const double miss = wedge.at(metres(point(v))) - metres(sector.height());
      note(Feature::SlopeTouchesOpposite, std::abs(miss) < 1e-9);
    }
  }

  bool areContinuous(const WallAt& at, const Sector& here, const Sector& next) const {
    const Vec2 a = metres(point(at.a));
    const Vec2 b = metres(point(at.b));
    const auto areEqual = [](double p, double q) { return std::abs(p - q) < 1e-9; };
    const bool floors = here.floor.wedge && next.floor.wedge &&
                        here.floor.wedge->gradient == next.floor.wedge->gradient &&
                        length(here.floor.wedge->gradient) > 0 &&
                        areEqual(model_.floorAt(here, a), model_.floorAt(next, a)) &&
                        areEqual(model_.floorAt(here, b), model_.floorAt(next, b));
    const bool ceilings = here.ceiling.wedge && next.ceiling.wedge &&
                          here.ceiling.wedge->gradient == next.ceiling.wedge->gradient &&
                          length(here.ceiling.wedge->gradient) > 0 &&
                          areEqual(model_.ceilingAt(here, a), model_.ceilingAt(next, a)) &&
                          areEqual(model_.ceilingAt(here, b), model_.ceilingAt(next, b));
    return floors || ceilings;
  }

  // ---- spellings

  void findTexture(const TextureUse& use) {
    note(Feature::TextureScale, use.scale.has_value());
    note(Feature::TextureAlong, use.along.has_value());
    note(Feature::TextureZref, use.zref.has_value());
    note(Feature::PlainColour, use.name.starts_with('#'));
    if (!use.offset) return;
    for (const double offset : *use.offset) {
      note(Feature::NegativeOffset, offset < 0);
      note(Feature::FractionalOffset, offset != std::floor(offset));
    }
  }

  void findSpelling(const Sector& sector) {
    note(sector.light ? Feature::SectorLight : Feature::NoSectorLight);
    note(Feature::HyphenatedName, sector.name.find('-') != std::string::npos);
    note(Feature::SkyCeiling, sector.ceiling.isSky);
    note(Feature::SkyFloor, sector.floor.isSky);
    for (const Flat* flat : {&sector.floor, &sector.ceiling}) {
      if (flat->flatPortal) {
        note(flat->isFlatPortalObject ? Feature::FlatPortalAsObject : Feature::FlatPortalAsString);
        continue;
      }
      findTexture(flat->texture);
      note(Feature::RelativeFlat, flat->isRelative);
    }
    note(Feature::FlatPortalChain, sector.floor.flatPortal && sector.ceiling.flatPortal);
    for (const Loop& loop : sector.loops) {
      note(Feature::WrongWinding, loop.isWoundWrongly);
      note(Feature::OneWallForLoop, loop.hasOneWall);
    }
  }

  // ---- sectors above each other

  void findFlatPortals() {
    for (FlatPortalIndex i = 0; i < model_.flatPortals.size(); ++i) {
      std::set<std::vector<FaceId>> above;
      std::set<std::vector<FaceId>> below;
      for (const Sector& sector : model_.sectors) {
        std::vector<FaceId> faces = sector.faces;
        std::sort(faces.begin(), faces.end());
        if (sector.floor.flatPortal == i) above.insert(faces);
        if (sector.ceiling.flatPortal == i) below.insert(faces);
      }
      note(Feature::FlatPortalCutDifferently, above != below);
    }
  }

  void findOverlaps() {
    for (const std::set<SectorIndex>& owners : model_.owners) {
      for (const SectorIndex s : owners) {
        for (const SectorIndex t : owners) {
          const Sector& a = model_.sectors[s];
          const Sector& b = model_.sectors[t];
          const Um shared = std::min(a.ceiling.z, b.ceiling.z) - std::max(a.floor.z, b.floor.z);
          note(Feature::OverlappingSectors, s != t && shared > 0);
        }
      }
    }
  }

  // ---- long views

  /// Looks from the first link of a chain to the last, at a height that all of them leave open.
  void findDeepChain() {
    std::vector<SectorIndex> links;
    for (SectorIndex s = 0; s < model_.sectors.size(); ++s) {
      if (model_.sectors[s].isChainLink) links.push_back(s);
    }
    if (links.empty()) return;
    Um low = std::numeric_limits<Um>::min();
    Um high = std::numeric_limits<Um>::max();
    for (const SectorIndex s : links) {
      low = std::max(low, model_.sectors[s].floor.z);
      high = std::min(high, model_.sectors[s].ceiling.z);
    }
    if (low >= high) return;
    const std::size_t count = portalsAlong(links.front(), middle(links.front()),
                                           middle(links.back()), low + (high - low) / 2);
    note(Feature::DeepPortalChain, count >= 12);
  }

  Vec2 middle(SectorIndex s) const {
    const std::vector<VertexId>& border = model_.sectors[s].loops[0].vertices;
    Vec2 sum;
    for (const VertexId v : border) sum = sum + metres(point(v));
    return 1 / static_cast<double>(border.size()) * sum;
  }

  /// How many plain portals the straight line crosses before it ends or meets something else.
  std::size_t portalsAlong(SectorIndex s, Vec2 from, Vec2 to, Um z) const {
    const Vec2 d = to - from;
    double passed = 0;
    for (std::size_t count = 0;; ++count) {
      const WallAt* nearest = nullptr;
      double nearestT = 1;
      for (const WallAt& at : walls_) {
        const Vec2 a = metres(point(at.a));
        const Vec2 edge = metres(point(at.b)) - a;
        const double across = cross(edge, d);
        if (at.sector != s || across >= 0) continue;  // only walls that it leaves through
        const double t = cross(a - from, edge) / cross(d, edge);
        const double along = cross(a - from, d) / cross(d, edge);
        if (t <= passed || t >= nearestT || along < 0 || along > 1) continue;
        nearest = &at;
        nearestT = t;
      }
      if (!nearest || nearest->wall->pieces.size() != 1) return count;
      const auto portals = portalsOf(*nearest->wall);
      if (portals.empty()) return count;
      const Sector& next = model_.sectors[portals[0]->next];
      if (z <= next.floor.z || z >= next.ceiling.z) return count;
      s = portals[0]->next;
      passed = nearestT;
    }
  }

  const Model& model_;
  std::vector<WallAt> walls_;
  std::set<Feature> features_;
};

}  // namespace

std::set<Feature> featuresOf(const Model& model) { return FeatureFinder(model).find(); }

}  // namespace hearth::random_levels
