#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

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

/// What walls say of movers that they start.
class SwitchLinker {
 public:
  explicit SwitchLinker(Linking& linking) : linking_(linking), names_(linking.description) {}

  void link(SegmentId segment) {
    // A wall may be split into several segments, and stand for many walls.
    const WallDescription& wall = linking_.describedWall(segment);
    if (wall.switched) {
      add({segment, std::nullopt, 0, false}, wall.switched->use);
      add({segment, 0, 0, true}, wall.switched->cross);
    }
    const auto* stack = std::get_if<StackDescription>(&wall.kind);
    if (!stack) return;
    for (std::uint32_t i = 0; i < stack->subWalls.size(); ++i) {
      const SubWallDescription& subWall = stack->subWalls[i];
      if (!subWall.switched) continue;
      add({segment, i, 0, false}, subWall.switched->use);
      add({segment, i, 0, true}, subWall.switched->cross);
    }
  }

 private:
  void add(MoverSwitch made, const std::vector<NameReference>& names) {
    for (const NameReference& name : names) {
      if (unknown_.contains(name.place)) continue;  // has been reported
      const auto mover = names_.link(linking_.report, name);
      if (!mover) {
        unknown_.insert(name.place);
        continue;
      }
      made.mover = *mover;
      linking_.level.switches.push_back(made);
    }
  }

  Linking& linking_;
  MoverNames names_;
  std::set<Place> unknown_;
};

}  // namespace

MoverNames::MoverNames(const LevelDescription& description) {
  for (const MoverDescription& mover : description.movers) {
    indices_.emplace(mover.name, names_.size());
    names_.push_back(mover.name);
  }
}

std::optional<std::size_t> MoverNames::link(Report& report, const NameReference& name) const {
  if (const auto found = indices_.find(name.name); found != indices_.end()) return found->second;
  report.error(name.place, fmt::format("there is no mover \"{}\"", name.name),
               report.isFull() ? "" : suggest(name.name, names_, "name a mover of this level"));
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
  SwitchLinker switches(linking);
  for (std::size_t i = 0; i < linking.level.segments.size(); ++i) switches.link(SegmentId(i));
}

}  // namespace hearth
