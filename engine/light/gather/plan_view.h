#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/rays/id_set.h"
#include "math/box.h"

namespace hearth {

/// Compass directions from a point between two, less than half of all.
struct Wedge {
  Vec2 right;  ///< clockwise end, of any length
  Vec2 left;

  bool contains(Vec2 direction) const {
    return cross(right, direction) >= 0 && cross(direction, left) >= 0;
  }
  friend bool operator==(const Wedge&, const Wedge&) = default;
};

/// Which sectors a point may see on the map, and in which compass directions: through the openings
/// of walls, whatever their heights, and through flat portals. (Visible cells are found so since
/// D. Luebke and C. Georges, "Portals and Mirrors", 1995.) Walls and meshes within a sector hide
/// nothing here, so the point may see less.
class PlanView {
 public:
  /// Keeps references to the scene's parts.
  explicit PlanView(const Scene& scene);

  /// Sets the point, in the air of a sector or on its border. What it sees in less than `narrowest`
  /// radians, less than 1, counts as unseen. Adds the sectors that it may see to `met`, if any.
  void lookFrom(Vec2 point, SectorId sector, double narrowest, SectorSet* met);

  /// Whether it may see something of what lies in a sector and in a box.
  bool maySee(SectorId sector, const Box& box) const;
  /// Each is where it may see from a sector without a sky into one with a sky.
  const std::vector<Wedge>& windows() const { return windows_; }

 private:
  /// What a slice could leave a sector through.
  struct Gap {
    Vec2 p0;
    Vec2 p1;
    SectorId next;
  };
  /// All that light passes on the map, close together: a point asks for most of it.
  struct Plan {
    struct Room {
      std::uint32_t firstGap;
      bool hasSky;
      bool hasFlatPortals;
    };
    std::vector<Room> rooms;  ///< by SectorId, and one more where the gaps end
    std::vector<Gap> gaps;    ///< of all walls, room by room
  };
  /// All that a point sees of a sector is in one wedge; all directions if it has none.
  struct View {
    std::optional<Wedge> wedge;
    int timesWidened = 0;
    std::uint32_t look = 0;  ///< number of the call of lookFrom that set this
  };

  static Plan planOf(const Scene& scene);
  std::span<const Gap> gapsOf(SectorId sector) const;
  bool hasSky(SectorId sector) const { return plan_->rooms[sector.value].hasSky; }
  void see(SectorId sector, const std::optional<Wedge>& wedge);
  void passWalls(SectorId sector, const std::optional<Wedge>& wedge);
  void passFlats(SectorId sector, const std::optional<Wedge>& wedge);
  void addWindow(SectorId from, SectorId to, const Wedge& wedge);

  Scene scene_;
  std::shared_ptr<const Plan> plan_;  ///< copies share it
  Vec2 point_{};
  double narrowest_ = 0;
  std::uint32_t look_ = 0;      ///< number of the last call of lookFrom
  std::vector<View> views_;     ///< by SectorId, none before the first look
  std::vector<SectorId> left_;  ///< that have been seen in more directions than handed on
  std::vector<Wedge> windows_;
};

}  // namespace hearth
