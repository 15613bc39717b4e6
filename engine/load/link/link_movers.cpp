#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "load/link/link.h"
#include "load/suggest.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

class MoverLinker {
 public:
  explicit MoverLinker(Linking& linking) : linking_(linking) {}

  void link(const MoverDescription& described) {
    Mover mover{
        described.name, {}, described.part, described.to, described.speed, described.wait, {}, {}};
    mover.trigger = described.trigger;
    for (const NameReference& name : described.sectors)
      if (const auto sector = linking_.names.link(linking_.report, name)) {
        takeFlat(described, *sector, name.place);
        mover.sectors.push_back(*sector);
        validateStart(described.part, mover.sectors.front(), *sector, name.place);
      }
    for (const NameReference& name : described.zones)
      if (const auto zone = linking_.names.link(linking_.report, name))
        mover.zones.push_back(*zone);
    linking_.level.movers.push_back(std::move(mover));
  }

  void linkNames(const std::vector<NameReference>& names) const {
    for (const NameReference& name : names) linkMover(linking_.report, linking_.description, name);
  }

 private:
  const FlatDescription& flatOf(SectorId sector, FlatPart part) const {
    const SectorDescription& described = linking_.description.sectors[sector.index()];
    return part == FlatPart::Floor ? described.floor : described.ceiling;
  }

  /// A flat that can move, and that no other mover has.
  void takeFlat(const MoverDescription& mover, SectorId sector, Place place) {
    const SectorDescription& described = linking_.description.sectors[sector.index()];
    const FlatDescription& flat = flatOf(sector, mover.part);
    const auto& slope = mover.part == FlatPart::Floor ? described.slopeFloor : described.slopeCeil;
    if (flat.isSky || flat.next || slope)
      linking_.report.error(place,
                            fmt::format("the {} of sector \"{}\" {}, and cannot move",
                                        name(mover.part), described.name,
                                        flat.isSky  ? "is sky"
                                        : flat.next ? "is a flat portal"
                                                    : "carries a slope"),
                            "name another sector, or make that flat a plain one");
    const auto [taken, isFirst] = movers_.try_emplace({sector, mover.part}, &mover);
    if (!isFirst)
      linking_.report.error(place,
                            fmt::format("the {} of sector \"{}\" moves with \"{}\" already",
                                        name(mover.part), described.name, taken->second->name),
                            "let one mover move it");
  }

  /// All flats of a mover start at the height of its first.
  void validateStart(FlatPart part, SectorId first, SectorId sector, Place place) const {
    const FlatDescription& from = flatOf(first, part);
    const FlatDescription& flat = flatOf(sector, part);
    if (!from.isReadable || !flat.isReadable || std::abs(flat.z - from.z) <= kAuthorNoise) return;
    linking_.report.error(
        place,
        fmt::format("the {} of sector \"{}\" is at {}, that of \"{}\" at {}", name(part),
                    linking_.level[sector].name, flat.z, linking_.level[first].name, from.z),
        "let all flats of a mover start at one height");
  }

  Linking& linking_;
  std::map<std::pair<SectorId, FlatPart>, const MoverDescription*> movers_;
};

/// Calls `visit` for each list of movers that a wall or sub-wall names.
template <typename Visit>
void forEachSwitch(const LevelDescription& description, Visit&& visit) {
  const auto visitKind = [&](const auto& kind) {
    if (const auto* portal = std::get_if<PortalDescription>(&kind)) visit(portal->cross);
  };
  for (const SectorDescription& sector : description.sectors)
    for (const LoopDescription& loop : sector.loops)
      for (const WallDescription& wall : loop.walls) {
        visit(wall.use);
        visitKind(wall.kind);
        const auto* stack = std::get_if<StackDescription>(&wall.kind);
        if (!stack) continue;
        for (const SubWallDescription& subWall : stack->subWalls) {
          visit(subWall.use);
          visitKind(subWall.kind);
        }
      }
}

}  // namespace

std::optional<std::size_t> linkMover(Report& report, const LevelDescription& description,
                                     const NameReference& name) {
  const std::vector<MoverDescription>& movers = description.movers;
  const auto found = std::ranges::find(movers, name.name, &MoverDescription::name);
  if (found != movers.end()) return static_cast<std::size_t>(found - movers.begin());
  std::vector<std::string_view> known;
  for (const MoverDescription& mover : movers) known.push_back(mover.name);
  report.error(name.place, fmt::format("there is no mover \"{}\"", name.name),
               suggest(name.name, known, "name a mover of this level"));
  return std::nullopt;
}

LevelDescription descriptionAt(LevelDescription description, std::span<const double> shares) {
  std::map<std::string_view, std::size_t> sectors;
  for (std::size_t i = 0; i < description.sectors.size(); ++i)
    sectors.emplace(description.sectors[i].name, i);
  for (std::size_t i = 0; i < description.movers.size(); ++i) {
    const MoverDescription& mover = description.movers[i];
    for (const NameReference& name : mover.sectors) {
      SectorDescription& sector = description.sectors[sectors.at(name.name)];
      double& z = (mover.part == FlatPart::Floor ? sector.floor : sector.ceiling).z;
      z = std::lerp(z, mover.to, shares[i]);
    }
  }
  description.player.reset();
  return description;
}

void linkMovers(Linking& linking) {
  MoverLinker linker(linking);
  for (const MoverDescription& mover : linking.description.movers) linker.link(mover);
  forEachSwitch(linking.description,
                [&](const std::vector<NameReference>& names) { linker.linkNames(names); });
}

}  // namespace hearth
