#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "load/link/link.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Collects the flats that name the same pair of sectors.
class FlatPortalLinker {
 public:
  explicit FlatPortalLinker(Linking& linking) : linking_(linking) {}

  /// A flat of `sector` that leads `to` the other side; it takes the flat portal's height.
  void add(SectorId sector, const FlatDescription& described, bool isFloor, Flat& flat) {
    const FlatPortalDescription& next = *described.next;
    const std::optional<FlatPortalId> id = idOf(next, flat.z);
    if (!id) {
      linking_.isDoubtful[sector.index()] = true;
      flat.texture = linking_.textures.standIn();
      return;
    }
    FlatPortal& flatPortal = linking_.level.flatPortals[id->index()];
    if (std::abs(flat.z - flatPortal.z) > kAuthorNoise)
      linking_.report.error(
          described.zPlace,
          fmt::format("flat portal at height {}, where the others of \"{}\" are at {}", flat.z,
                      flatPortal.name, flatPortal.z),
          "give all flats with one \"next\" the same z");
    flat.z = flatPortal.z;
    flat.flatPortal = id;
    (isFloor ? flatPortal.upper : flatPortal.lower).push_back(sector);
  }

  /// The two named sectors must be members.
  void checkMembers() const {
    for (const auto& [names, known] : known_) {
      const FlatPortal& flatPortal = linking_.level.flatPortals[known.id.index()];
      checkMember(known.next->up, known.up, flatPortal.upper, "floor", flatPortal.name);
      checkMember(known.next->down, known.down, flatPortal.lower, "ceiling", flatPortal.name);
    }
  }

 private:
  struct Known {
    FlatPortalId id;
    SectorId up;
    SectorId down;
    const FlatPortalDescription* next;
  };

  std::optional<FlatPortalId> idOf(const FlatPortalDescription& next, double z) {
    const auto names = std::pair(next.up.name, next.down.name);
    if (const auto found = known_.find(names); found != known_.end()) return found->second.id;
    const std::optional<SectorId> up = linking_.names.link(linking_.report, next.up);
    const std::optional<SectorId> down = linking_.names.link(linking_.report, next.down);
    if (!up || !down) return std::nullopt;
    std::vector<FlatPortal>& flatPortals = linking_.level.flatPortals;
    const FlatPortalId id(flatPortals.size());
    flatPortals.push_back({fmt::format("{}-{}", next.up.name, next.down.name), z, {}, {}});
    known_.emplace(names, Known{id, *up, *down, &next});
    return id;
  }

  void checkMember(const NameReference& name, SectorId id, const std::vector<SectorId>& members,
                   std::string_view flat, const std::string& flatPortal) const {
    if (linking_.isDoubtful[id.index()] || std::binary_search(members.begin(), members.end(), id))
      return;
    linking_.report.error(
        name.place,
        fmt::format("the {} of sector \"{}\" is no part of the flat portal \"{}\"", flat, name.name,
                    flatPortal),
        fmt::format("give that {} the same \"next\"", flat));
  }

  Linking& linking_;
  std::map<std::pair<std::string, std::string>, Known> known_;
};

class FlatLinker {
 public:
  explicit FlatLinker(Linking& linking) : linking_(linking), flatPortals_(linking) {}

  void linkSector(std::size_t index) {
    const SectorDescription& described = linking_.description.sectors[index];
    Sector& sector = linking_.level.sectors[index];
    sector.name = described.name;
    sector.light = described.light.value_or(linking_.description.light.value_or(0));
    linking_.isDoubtful[index] = !described.floor.isReadable || !described.ceiling.isReadable ||
                                 !linking_.outlines.sectors[index].isSound;
    linkFlat(SectorId(index), described.floor, described.slopeFloor, true, sector.floor);
    linkFlat(SectorId(index), described.ceiling, described.slopeCeil, false, sector.ceiling);
    checkHeights(index);
  }

  void finish() const { flatPortals_.checkMembers(); }

 private:
  void linkFlat(SectorId sector, const FlatDescription& described,
                const std::optional<SlopeDescription>& slope, bool isFloor, Flat& flat) {
    flat.z = described.z;
    flat.isSky = described.isSky;
    if (slope && (described.next || described.isSky))
      linking_.report.error(
          slope->place,
          fmt::format("a slope on a flat that is {}", described.next ? "a flat portal" : "sky"),
          "remove one of them");
    if (described.next) {
      flat.isSky = false;
      return flatPortals_.add(sector, described, isFloor, flat);
    }
    if (!described.texture && described.isReadable)
      linking_.report.error(described.place,
                            fmt::format("the {} of sector \"{}\" has no texture",
                                        isFloor ? "floor" : "ceiling", linking_.level[sector].name),
                            "give it a \"texture\"");
    flat.texture = described.texture ? linking_.textures.link(*described.texture)
                                     : linking_.textures.standIn();
  }

  void checkHeights(std::size_t index) {
    const SectorDescription& described = linking_.description.sectors[index];
    Sector& sector = linking_.level.sectors[index];
    if (sector.ceiling.z >= sector.floor.z) return;
    if (described.floor.isReadable && described.ceiling.isReadable)
      linking_.report.error(
          described.ceiling.zPlace,
          fmt::format("the ceiling of sector \"{}\" is at {}, below its floor at {}", sector.name,
                      sector.ceiling.z, sector.floor.z),
          "raise the ceiling or lower the floor");
    linking_.isDoubtful[index] = true;
    sector.ceiling.z = sector.floor.z;
  }

  Linking& linking_;
  FlatPortalLinker flatPortals_;
};

}  // namespace

void linkFlats(Linking& linking) {
  const std::size_t count = linking.description.sectors.size();
  linking.level.sectors.resize(count);
  linking.isDoubtful.resize(count);
  FlatLinker linker(linking);
  for (std::size_t i = 0; i < count; ++i) linker.linkSector(i);
  linker.finish();
}

}  // namespace hearth
