#include "random_levels/storeys.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "random_levels/texture_uses.h"

namespace hearth::random_levels {
namespace {

using Region = std::vector<FaceId>;

/// Which faces share an edge.
std::map<FaceId, std::vector<FaceId>> neighboursOf(const Mesh& mesh) {
  std::map<FaceId, std::vector<FaceId>> neighbours;
  const std::map<EdgeKey, FaceId> edges = mesh.edges();
  for (const auto& [edge, face] : edges) {
    const auto reverse = edges.find({edge.second, edge.first});
    if (reverse != edges.end()) neighbours[face].push_back(reverse->second);
  }
  return neighbours;
}

/// Few heights, so that they coincide often; tenths, so that not all are exact in binary.
class HeightPalette {
 public:
  explicit HeightPalette(Random& random) : random_(random) {
    for (int i = 0; i < 3; ++i) {
      floors_.push_back(random.pick<Um>({0, 0, 250'000, 500'000, -250'000, 300'000, 1'000'000}));
      ceilings_.push_back(
          random.pick<Um>({2'000'000, 2'500'000, 3'000'000, 2'250'000, 1'700'000, 4'000'000}));
      rooms_.push_back(random.pick<Um>({1'500'000, 2'000'000, 2'500'000, 1'750'000, 2'100'000}));
    }
  }
  Um floor() { return random_.pickFrom(floors_); }
  Um ceiling() { return random_.pickFrom(ceilings_); }
  Um room() { return random_.pickFrom(rooms_); }  ///< of an upper storey, from floor to ceiling

 private:
  Random& random_;
  std::vector<Um> floors_;
  std::vector<Um> ceilings_;
  std::vector<Um> rooms_;
};

class StoreyBuilder {
 public:
  StoreyBuilder(Random& random, Model& model, const StoreyStyle& style)
      : random_(random),
        model_(model),
        style_(style),
        neighbours_(neighboursOf(model.mesh)),
        heights_(random) {
    model_.owners.resize(model_.mesh.faces.size());
  }

  void build() {
    buildGround();
    for (std::size_t storey = 1; storey < style_.storeys; ++storey) buildAbove(storey);
    if (style_.hasDoors) makeDoors();
    makeSkies();
  }

 private:
  // ---- sharing out

  void buildGround() {
    Region cells;
    for (FaceId f = 0; f < model_.mesh.faces.size(); ++f) {
      if (f < style_.chainLinks) {
        addGroundSector({f}).isChainLink = true;
      } else if (model_.mesh.faces[f].isInset) {
        if (!random_.chance(0.45)) addGroundSector({f});
      } else if (!random_.chance(style_.voidFraction)) {
        cells.push_back(f);
      }
    }
    if (cells.empty()) return;
    for (Region& region : grow(cells, style_.groundSectors)) addGroundSector(std::move(region));
  }

  /// Splits `faces` into about `count` connected regions.
  std::vector<Region> grow(Region faces, std::size_t count) {
    random_.shuffle(faces);
    std::set<FaceId> free(faces.begin(), faces.end());
    std::vector<Region> regions;
    for (std::size_t i = 0; i < std::min(count, faces.size()); ++i) {
      regions.push_back({faces[i]});
      free.erase(faces[i]);
    }
    while (!free.empty()) {
      if (growOne(regions, free)) continue;
      regions.push_back({*free.begin()});
      free.erase(free.begin());
    }
    return regions;
  }

  /// Adds one free neighbour to one region; false when none has any.
  bool growOne(std::vector<Region>& regions, std::set<FaceId>& free) {
    std::vector<std::pair<std::size_t, FaceId>> steps;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      for (const FaceId face : regions[r]) {
        for (const FaceId next : neighbours_[face]) {
          if (free.contains(next)) steps.push_back({r, next});
        }
      }
    }
    if (steps.empty()) return false;
    const auto [r, face] = random_.pickFrom(steps);
    regions[r].push_back(face);
    free.erase(face);
    return true;
  }

  Sector& addGroundSector(Region faces) {
    Sector& sector = addSector(0, std::move(faces));
    sector.floor.z = heights_.floor();
    sector.ceiling.z = std::max(heights_.ceiling(), sector.floor.z + 700'000);
    return sector;
  }

  Sector& addSector(std::size_t storey, Region faces) {
    const SectorIndex index = model_.sectors.size();
    for (const FaceId face : faces) model_.owners[face].insert(index);
    Sector sector;
    const bool hasHyphen = style_.hasHyphens && random_.chance(0.4);
    sector.name =
        fmt::format("{}{}{}", random_.pick({"s", "room", "hall"}), hasHyphen ? "-" : "", index);
    sector.storey = storey;
    sector.faces = std::move(faces);
    if (random_.chance(0.5)) sector.light = random_.pick({0.0, 0.1, 0.25, 0.4, 0.7, 1.0});
    sector.floor.texture = flatTexture(random_);
    sector.ceiling.texture = flatTexture(random_);
    sector.floor.isRelative = random_.chance(0.3);
    sector.ceiling.isRelative = random_.chance(0.3);
    model_.sectors.push_back(std::move(sector));
    return model_.sectors.back();
  }

  // ---- storeys above

  void buildAbove(std::size_t storey) {
    const std::size_t groups = random_.chance(0.25) ? 2 : 1;
    for (std::size_t i = 0; i < groups; ++i) addFlatPortal(storey);
    if (random_.chance(0.6)) addRoomsBeside(storey);
    if (random_.chance(0.5)) raiseOneBeside(storey);
  }

  /// One to three sectors below, joined to one to three above over the same faces.
  void addFlatPortal(std::size_t storey) {
    std::vector<SectorIndex> lower;
    Um z = -100 * kMetre;
    for (SectorIndex s = 0; s < model_.sectors.size(); ++s) {
      const Sector& sector = model_.sectors[s];
      const bool fits = sector.storey + 1 == storey && !sector.ceiling.flatPortal;
      if (fits && !sector.isChainLink) lower.push_back(s);
    }
    if (lower.empty()) return;
    random_.shuffle(lower);
    lower.resize(std::min(lower.size(), 1 + random_.below(3)));
    Region faces;
    for (const SectorIndex s : lower) {
      z = std::max(z, model_.sectors[s].ceiling.z);
      faces.insert(faces.end(), model_.sectors[s].faces.begin(), model_.sectors[s].faces.end());
    }
    const FlatPortalIndex index = model_.flatPortals.size();
    const SectorIndex firstUpper = model_.sectors.size();
    for (Region& region : grow(faces, 1 + random_.below(3))) {
      Sector& upper = addSector(storey, std::move(region));
      upper.floor = flatPortalFlat(z, index);
      upper.ceiling.z = z + heights_.room();
    }
    const SectorIndex up = firstUpper + random_.below(model_.sectors.size() - firstUpper);
    model_.flatPortals.push_back({up, lower[random_.below(lower.size())]});
    for (const SectorIndex s : lower) {
      model_.sectors[s].ceiling = flatPortalFlat(z, index);
    }
    spellFlatPortal(index);
  }

  static Flat flatPortalFlat(Um z, FlatPortalIndex index) {
    Flat flat;
    flat.z = z;
    flat.flatPortal = index;
    return flat;
  }

  void spellFlatPortal(FlatPortalIndex index) {
    const auto hasHyphen = [&](SectorIndex s) {
      return model_.sectors[s].name.find('-') != std::string::npos;
    };
    const FlatPortal& flatPortal = model_.flatPortals[index];
    const bool isObjectOnly = hasHyphen(flatPortal.up) || hasHyphen(flatPortal.down);
    for (Sector& sector : model_.sectors) {
      for (Flat* flat : {&sector.floor, &sector.ceiling}) {
        if (flat->flatPortal == index)
          flat->isFlatPortalObject = isObjectOnly || random_.chance(0.4);
      }
    }
  }

  /// Rooms of this storey that stand on solid ground, or on the same place as rooms below.
  void addRoomsBeside(std::size_t storey) {
    Um base = 0;
    std::set<FaceId> taken;
    for (const Sector& sector : model_.sectors) {
      if (sector.storey != storey) continue;
      base = sector.floor.z;
      taken.insert(sector.faces.begin(), sector.faces.end());
    }
    Region faces;
    for (FaceId f = style_.chainLinks; f < model_.mesh.faces.size(); ++f) {
      if (!taken.contains(f) && faces.size() < 4 && random_.chance(0.5)) faces.push_back(f);
    }
    if (faces.empty() || taken.empty()) return;
    for (Region& region : grow(faces, 1 + random_.below(2))) {
      Sector& sector = addSector(storey, std::move(region));
      sector.floor.z = base + random_.pick<Um>({0, 0, 250'000, -500'000, -1'250'000});
      sector.ceiling.z = sector.floor.z + heights_.room();
    }
  }

  /// Makes a room of the ground as high as the storey above, so that it looks into both.
  void raiseOneBeside(std::size_t storey) {
    std::vector<SectorIndex> low;
    Um top = 0;
    for (SectorIndex s = 0; s < model_.sectors.size(); ++s) {
      const Sector& sector = model_.sectors[s];
      if (sector.storey == storey) top = std::max(top, sector.ceiling.z);
      if (sector.storey == 0 && !sector.ceiling.flatPortal && !sector.isChainLink) low.push_back(s);
    }
    if (low.empty()) return;
    Sector& sector = model_.sectors[random_.pickFrom(low)];
    sector.ceiling.z = std::max(sector.ceiling.z, top);
  }

  // ---- doors and skies

  std::vector<SectorIndex> roomsWithoutFlatPortals() const {
    std::vector<SectorIndex> rooms;
    for (SectorIndex s = 0; s < model_.sectors.size(); ++s) {
      const Sector& sector = model_.sectors[s];
      if (!sector.floor.flatPortal && !sector.ceiling.flatPortal && !sector.isChainLink) {
        rooms.push_back(s);
      }
    }
    return rooms;
  }

  /// A closed door, and a room whose floor is the ceiling of another.
  void makeDoors() {
    std::vector<SectorIndex> rooms = roomsWithoutFlatPortals();
    random_.shuffle(rooms);
    if (rooms.size() < 3) return;
    if (random_.chance(0.6)) {
      Sector& door = model_.sectors[rooms[0]];
      door.ceiling.z = door.floor.z;
    }
    if (random_.chance(0.7)) setOnNeighboursCeiling(rooms[1]);
  }

  void setOnNeighboursCeiling(SectorIndex s) {
    Sector& sector = model_.sectors[s];
    for (const FaceId face : sector.faces) {
      for (const FaceId next : neighbours_[face]) {
        for (const SectorIndex other : model_.owners[next]) {
          if (other == s || model_.sectors[other].storey != sector.storey) continue;
          sector.floor.z = model_.sectors[other].ceiling.z;
          sector.ceiling.z = sector.floor.z + heights_.room();
          return;
        }
      }
    }
  }

  void makeSkies() {
    for (Sector& sector : model_.sectors) {
      if (!sector.ceiling.flatPortal) sector.ceiling.isSky = random_.chance(style_.skyFraction);
      if (!sector.floor.flatPortal) sector.floor.isSky = random_.chance(style_.skyFloorFraction);
      for (Flat* flat : {&sector.floor, &sector.ceiling}) {
        if (flat->isSky) flat->isRelative = false;
      }
    }
  }

  Random& random_;
  Model& model_;
  const StoreyStyle& style_;
  std::map<FaceId, std::vector<FaceId>> neighbours_;
  HeightPalette heights_;
};

}  // namespace

Model makeStoreys(Random& random, Mesh mesh, const StoreyStyle& style) {
  Model model;
  model.mesh = std::move(mesh);
  StoreyBuilder(random, model, style).build();
  return model;
}

}  // namespace hearth::random_levels
