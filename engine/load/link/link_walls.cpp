#include <fmt/format.h>

#include "load/link/link.h"
#include "load/link/walls_behind.h"

namespace hearth {

namespace {

class WallLinker {
 public:
  WallLinker(Linking& linking, const Edge& edge, WallsBehind& behind)
      : linking_(linking),
        edge_(edge),
        behind_(behind),
        sector_(linking.level.sectors[edge.sector]),
        areHeightsKnown_(!linking.isDoubtful[edge.sector]) {}

  std::optional<Wall> link(const WallDescription& described) {
    if (const auto* solid = std::get_if<SolidDescription>(&described.kind))
      return linkSolid(*solid);
    if (const auto* portal = std::get_if<PortalDescription>(&described.kind)) {
      if (std::optional<Portal> linked = linkPortal(*portal)) return *linked;
    }
    if (const auto* stack = std::get_if<StackDescription>(&described.kind)) {
      if (std::optional<Stack> linked = linkStack(*stack)) return *std::move(linked);
    }
    return std::nullopt;
  }

 private:
  Solid linkSolid(const SolidDescription& described) {
    return {linking_.textures.link(described.texture)};
  }

  void reportUnknown(const NameReference& next) {
    if (linking_.report.isFull()) return linking_.report.error(next.place, "", "");
    std::vector<std::string_view> behind;
    for (const SectorId sector : behind_.sectors(
             SectorId(edge_.sector), linking_.outlines.from(edge_), linking_.outlines.to(edge_)))
      behind.push_back(linking_.level[sector].name);
    linking_.names.reportUnknown(linking_.report, next, sector_.name, behind);
  }

  std::optional<Portal> linkPortal(const PortalDescription& described) {
    if (!linking_.names.has(described.next.name)) {
      reportUnknown(described.next);
      return std::nullopt;
    }
    const std::optional<SectorId> next = linking_.names.link(linking_.report, described.next);
    if (!next) return std::nullopt;
    Portal portal{*next, {}, {}};
    if (described.upper) portal.upper = linking_.textures.link(*described.upper);
    if (described.lower) portal.lower = linking_.textures.link(*described.lower);
    if (described.maskedMiddle)
      portal.maskedMiddle = linking_.textures.link(*described.maskedMiddle);
    return portal;
  }

  std::optional<Stack> linkStack(const StackDescription& described) {
    Stack stack;
    bool isGood = true;
    double zBelow = sector_.floor.z;
    for (std::size_t i = 0; i < described.subWalls.size(); ++i) {
      const SubWallDescription& subWall = described.subWalls[i];
      const bool isLast = i + 1 == described.subWalls.size();
      const std::optional<double> zTop = topOf(subWall, isLast, zBelow);
      const std::optional<SubWallKind> kind = linkSubWall(subWall);
      isGood &= zTop && kind;
      if (zTop && kind) stack.subWalls.push_back({subWall.z.value_or(0), *kind});
      zBelow = zTop.value_or(zBelow);
    }
    return isGood ? std::optional(std::move(stack)) : std::nullopt;
  }

  std::optional<SubWallKind> linkSubWall(const SubWallDescription& described) {
    if (const auto* solid = std::get_if<SolidDescription>(&described.kind))
      return linkSolid(*solid);
    if (const auto* portal = std::get_if<PortalDescription>(&described.kind))
      if (std::optional<Portal> linked = linkPortal(*portal)) return *linked;
    return std::nullopt;
  }

  /// Absolute height of a sub-wall's top.
  std::optional<double> topOf(const SubWallDescription& subWall, bool isLast, double zBelow) {
    if (isLast) {
      if (!subWall.z) return sector_.ceiling.z;
      linking_.report.error(subWall.zPlace, "\"z\" on the topmost wall of a stack",
                            "remove it, that wall reaches the ceiling");
      return std::nullopt;
    }
    if (!subWall.z) {
      // Without a kind its z may be what could not be read.
      if (!std::holds_alternative<Unreadable>(subWall.kind))
        linking_.report.error(subWall.place, "a wall of a stack without \"z\"",
                              "give the height of its top above the floor");
      return std::nullopt;
    }
    const double zTop = sector_.floor.z + *subWall.z;
    if (zTop > zBelow && zTop < sector_.ceiling.z) return zTop;
    if (!areHeightsKnown_) return std::nullopt;
    linking_.report.error(
        subWall.zPlace,
        fmt::format("the top of the wall is {} m above the floor, not between {} and {}",
                    *subWall.z, zBelow - sector_.floor.z, sector_.ceiling.z - sector_.floor.z),
        "let \"z\" rise strictly from wall to wall inside the sector's height");
    return std::nullopt;
  }

  Linking& linking_;
  const Edge& edge_;
  WallsBehind& behind_;
  const Sector& sector_;
  bool areHeightsKnown_;
};

}  // namespace

void linkWalls(Linking& linking) {
  WallsBehind behind(linking);
  for (std::size_t i = 0; i < linking.outlines.edges.size(); ++i) {
    const Edge& edge = linking.outlines.edges[i];
    const OutlineLoop& loop = linking.outlines.sectors[edge.sector].loops[edge.loop];
    const bool isSameAsLast = linking.describedLoop(edge).walls.size() == 1 && i > loop.firstEdge;
    linking.walls.push_back(
        isSameAsLast ? linking.walls.back()
                     : WallLinker(linking, edge, behind).link(linking.describedWall(edge)));
  }
}

void linkLegend(Linking& linking) {
  if (!linking.description.grid) return;
  const auto link = [&](const std::optional<TextureDescription>& texture) {
    if (texture) linking.textures.link(*texture);
  };
  for (const LegendEntryDescription& entry : linking.description.grid->legend) {
    if (const auto* solid = std::get_if<GridSolidDescription>(&entry.kind)) {
      link(solid->wall);
      for (const auto& side : solid->sides) link(side);
    }
    if (const auto* air = std::get_if<GridAirDescription>(&entry.kind))
      for (const auto* texture :
           {&air->floor.texture, &air->ceiling.texture, &air->upper, &air->lower})
        link(*texture);
    if (const auto* next = std::get_if<GridNextDescription>(&entry.kind))
      for (const auto* texture : {&next->upper, &next->lower}) link(*texture);
  }
}

}  // namespace hearth
