#include "random_levels/walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "math/check.h"
#include "random_levels/texture_uses.h"

namespace hearth::random_levels {
namespace {

/// What two neighbours on one storey make of the walls between them.
enum class Border { Open, Closed, OneWay, StackOneSide, StackBothSides };

/// A straight part of a loop: the sectors on either side are the same all along.
struct Run {
  std::set<SectorIndex> here;   ///< owners of the faces in front, over all storeys
  std::set<SectorIndex> there;  ///< owners behind
};

class WallBuilder {
 public:
  WallBuilder(Random& random, Model& model, const WallStyle& style)
      : random_(random), model_(model), style_(style), edges_(model.mesh.edges()) {}

  void build() {
    for (SectorIndex s = 0; s < model_.sectors.size(); ++s) {
      Sector& sector = model_.sectors[s];
      const std::vector<std::vector<VertexId>> outlines = outlineOf(model_.mesh, sector.faces);
      for (std::size_t i = 0; i < outlines.size(); ++i) {
        sector.loops.push_back(makeLoop(s, outlines[i]));
        const bool isOnly = outlines.size() == 1;
        sector.loops[i].name = i > 0 || (isOnly && random_.chance(0.2))
                                   ? fmt::format("{}{}", random_.pick({"inner", "loop-"}), i)
                                   : "border";
      }
    }
  }

 private:
  // ---- loops

  Loop makeLoop(SectorIndex s, std::vector<VertexId> outline) {
    const auto start = static_cast<std::ptrdiff_t>(random_.below(outline.size()));
    std::rotate(outline.begin(), outline.begin() + start, outline.end());
    Loop loop;
    std::vector<Run> runs;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Run run = runOf(outline[i], outline[(i + 1) % outline.size()]);
      const Run before = runOf(outline[(i + outline.size() - 1) % outline.size()], outline[i]);
      const bool isSame = run.here == before.here && run.there == before.there;
      if (isSame && isStraight(outline, i) && random_.chance(style_.mergeFraction)) continue;
      loop.vertices.push_back(outline[i]);
      runs.push_back(run);
    }
    CHECK(loop.vertices.size() >= 3, loop.vertices.size());
    for (const Run& run : runs) loop.walls.push_back(makeWall(s, run));
    if (random_.chance(0.3)) makeAlike(s, loop);
    loop.isWoundWrongly = random_.chance(style_.wrongWinding);
    return loop;
  }

  Run runOf(VertexId a, VertexId b) const {
    Run run;
    run.here = model_.owners[edges_.at({a, b})];
    const auto reverse = edges_.find({b, a});
    if (reverse != edges_.end()) run.there = model_.owners[reverse->second];
    return run;
  }

  bool isStraight(const std::vector<VertexId>& outline, std::size_t i) const {
    const auto& v = model_.mesh.vertices;
    const Point before = v[outline[(i + outline.size() - 1) % outline.size()]];
    const Point after = v[outline[(i + 1) % outline.size()]];
    const Point here = v[outline[i]];
    return cross(here - before, after - here) == 0 && dot(here - before, after - here) > 0;
  }

  /// One wall for the whole loop, if all are solid or all lead to one sector.
  void makeAlike(SectorIndex s, Loop& loop) {
    const auto isPlainLike = [&](const Wall& wall) {
      if (wall.pieces.size() != 1) return false;
      const auto first = portalsOf(loop.walls[0]);
      const auto portals = portalsOf(wall);
      if (first.empty() || portals.empty()) return first.empty() && portals.empty();
      return first[0]->next == portals[0]->next;
    };
    if (!std::all_of(loop.walls.begin(), loop.walls.end(), isPlainLike)) return;
    const auto portals = portalsOf(loop.walls[0]);
    const Wall wall = portals.empty() ? solidWall(s) : portalWall(s, portals[0]->next);
    std::fill(loop.walls.begin(), loop.walls.end(), wall);
    loop.hasOneWall = true;
  }

  // ---- walls

  const Sector& sector(SectorIndex s) const { return model_.sectors[s]; }

  Wall makeWall(SectorIndex s, const Run& run) {
    std::optional<SectorIndex> level;    // the neighbour of the same storey
    std::vector<SectorIndex> elsewhere;  // those of others that overlap it in height
    for (const SectorIndex t : run.there) {
      if (run.here.contains(t)) continue;  // it has no wall here
      if (sector(t).storey == sector(s).storey) {
        level = t;
      } else if (sector(t).floor.z < sector(s).ceiling.z &&
                 sector(t).ceiling.z > sector(s).floor.z) {
        elsewhere.push_back(t);
      }
    }
    const bool canStack = sector(s).height() >= kMetre;
    if (level && canStack && !elsewhere.empty() && random_.chance(0.7)) {
      return stackOfStoreys(s, *level, random_.pickFrom(elsewhere));
    }
    if (level) return wallTowards(s, *level);
    if (!elsewhere.empty() && random_.chance(0.5)) {
      return portalWall(s, random_.pickFrom(elsewhere));
    }
    if (canStack && random_.chance(0.08)) return stackWall(s, s, random_.pick({"ss", "sss"}));
    return solidWall(s);
  }

  Wall wallTowards(SectorIndex s, SectorIndex t) {
    const bool isFirst = s < t;
    const bool canStack = sector(s).height() >= 500'000;
    switch (borderBetween(std::min(s, t), std::max(s, t))) {
      case Border::Closed:
        return solidWall(s);
      case Border::OneWay:
        return isFirst ? portalWall(s, t) : solidWall(s);
      case Border::StackOneSide:
        if (!isFirst) return portalWall(s, t);
        [[fallthrough]];
      case Border::StackBothSides:
        if (canStack) return stackWall(s, t, random_.pick({"sps", "psp", "ps", "sp", "spsps"}));
        [[fallthrough]];
      case Border::Open:
        break;
    }
    return portalWall(s, t);
  }

  Border borderBetween(SectorIndex first, SectorIndex second) {
    if (sector(first).isChainLink && sector(second).isChainLink) return Border::Open;
    const auto known = borders_.find({first, second});
    // Now and then a border changes on its way.
    if (known != borders_.end() && !random_.chance(0.1)) return known->second;
    const double dice = random_.unit();
    const Border border = dice < style_.stackFraction / 2 ? Border::StackOneSide
                          : dice < style_.stackFraction   ? Border::StackBothSides
                          : dice > 0.95                   ? Border::Closed
                          : dice > 0.9                    ? Border::OneWay
                                                          : Border::Open;
    borders_.insert({{first, second}, border});
    return border;
  }

  Wall solidWall(SectorIndex s) {
    return {{{SolidPiece{wallTexture(random_)}, sector(s).floor.z, sector(s).ceiling.z}}};
  }

  Wall portalWall(SectorIndex s, SectorIndex t) {
    return {{{portalTo(s, t, false), sector(s).floor.z, sector(s).ceiling.z}}};
  }

  PortalPiece portalTo(SectorIndex s, SectorIndex t, bool isInStack) {
    const Sector& from = sector(s);
    const Sector& to = sector(t);
    PortalPiece portal{.next = t, .texture = {}, .upper = {}, .lower = {}, .maskedMiddle = {}};
    // Between two skies the step shows the sky, but only where there is an opening beside it.
    const bool showsSky = !isInStack && to.ceiling.z > from.floor.z && to.floor.z < from.ceiling.z;
    const bool areSkies = showsSky && from.ceiling.isSky && to.ceiling.isSky;
    const bool areSkyFloors = showsSky && from.floor.isSky && to.floor.isSky;
    const bool needsUpper = to.ceiling.z < from.ceiling.z && !areSkies;
    const bool needsLower = to.floor.z > from.floor.z && !areSkyFloors;
    if (random_.chance(0.5)) {
      portal.texture = wallTexture(random_);
      return portal;
    }
    if (needsUpper || random_.chance(0.6)) portal.upper = wallTexture(random_);
    if (needsLower || random_.chance(0.6)) portal.lower = wallTexture(random_);
    return portal;
  }

  // ---- stacks

  /// `pattern` from bottom to top: `s` for a solid, `p` for a portal to `t`.
  Wall stackWall(SectorIndex s, SectorIndex t, const std::string& pattern) {
    const std::vector<Um> cuts = randomCuts(s, t, pattern.size() - 1);
    Wall wall;
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
      Piece piece{SolidPiece{wallTexture(random_)}, 0, 0};
      if (pattern[i] == 'p') piece.kind = portalTo(s, t, true);
      wall.pieces.push_back(piece);
    }
    setHeights(s, wall, cuts);
    return wall;
  }

  /// Portals to the sectors of two storeys, with or without a solid between them.
  Wall stackOfStoreys(SectorIndex s, SectorIndex t, SectorIndex u) {
    if (sector(u).floor.z < sector(t).floor.z) std::swap(t, u);
    Wall wall{{{portalTo(s, t, true), 0, 0}}};
    std::vector<Um> cuts{sector(t).ceiling.z, sector(u).floor.z};
    if (random_.chance(0.3)) cuts = randomCuts(s, t, 2);
    const bool areInside =
        sector(s).floor.z < cuts[0] && cuts[0] < cuts[1] && cuts[1] < sector(s).ceiling.z;
    if (areInside) {
      wall.pieces.push_back({SolidPiece{wallTexture(random_)}, 0, 0});
    } else {
      cuts = sector(s).floor.z < cuts[0] && cuts[0] < sector(s).ceiling.z ? std::vector<Um>{cuts[0]}
                                                                          : randomCuts(s, t, 1);
    }
    wall.pieces.push_back({portalTo(s, u, true), 0, 0});
    setHeights(s, wall, cuts);
    return wall;
  }

  /// `count` heights strictly inside `s`, rising: eighths of its height, or heights of `t`.
  std::vector<Um> randomCuts(SectorIndex s, SectorIndex t, std::size_t count) {
    const Um bottom = sector(s).floor.z;
    const Um top = sector(s).ceiling.z;
    std::set<Um> cuts;
    for (const Um z : {sector(t).floor.z, sector(t).ceiling.z}) {
      if (cuts.size() < count && bottom < z && z < top && random_.chance(0.5)) cuts.insert(z);
    }
    while (cuts.size() < count) {
      const Um step = (top - bottom) / 10'000 * 1'250;  // an eighth, in whole 10 um
      cuts.insert(bottom + random_.between(1, 7) * step);
    }
    return {cuts.begin(), cuts.end()};
  }

  void setHeights(SectorIndex s, Wall& wall, const std::vector<Um>& cuts) {
    CHECK(cuts.size() + 1 == wall.pieces.size(), cuts.size());
    for (std::size_t i = 0; i < wall.pieces.size(); ++i) {
      wall.pieces[i].bottom = i == 0 ? sector(s).floor.z : cuts[i - 1];
      wall.pieces[i].top = i == cuts.size() ? sector(s).ceiling.z : cuts[i];
    }
  }

  Random& random_;
  Model& model_;
  const WallStyle& style_;
  std::map<EdgeKey, FaceId> edges_;
  std::map<std::pair<SectorIndex, SectorIndex>, Border> borders_;
};

}  // namespace

void makeWalls(Random& random, Model& model, const WallStyle& style) {
  WallBuilder(random, model, style).build();
}

}  // namespace hearth::random_levels
