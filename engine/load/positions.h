#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "level/scene.h"
#include "math/box_tree.h"

namespace hearth {

/// What is looked for: a light may also stand above a sky ceiling or below a sky floor.
enum class PositionOf { Camera, Light };

/// Finds the sector that a position is in, by one rule for players, shots, lights and cameras of
/// the command line: the position lies inside the sector within kPositionSlack; where several
/// contain it, they must be open to each other there.
class Locator {
 public:
  struct Failure {
    std::string message;
    std::string advice;
  };

  /// The scene's level and geometry must outlive it.
  explicit Locator(const Scene& scene);

  tl::expected<SectorId, Failure> locate(Vec3 p, std::optional<SectorId> sector,
                                         PositionOf what) const;
  /// The sector on whose floor, or slope, a point of the map lies; without a name none whose floor
  /// is a flat portal. Where several contain it, they must be open to each other there, at one
  /// height.
  tl::expected<SectorId, Failure> locateOnFloor(Vec2 p, std::optional<SectorId> sector) const;

 private:
  tl::expected<SectorId, Failure> choose(Vec3 p, const std::vector<SectorId>& found) const;
  std::vector<SectorId> sectorsAt(Vec3 p) const;
  std::vector<SectorId> skySectorsAt(Vec3 p) const;
  Failure severalAt(Vec3 p, const std::vector<SectorId>& found) const;
  Failure outside(Vec3 p, std::optional<SectorId> sector) const;
  Failure outsideOnPlan(Vec2 p) const;

  Scene scene_;
  BoxTree sectors_;
};

/// None where no sector has the name.
std::optional<SectorId> findSector(const Level& level, std::string_view name);

/// The sector of a position that the user gave, with or without the name of its sector. The error
/// says what is wrong and what to do.
tl::expected<SectorId, std::string> locatePosition(const Scene& scene, Vec3 p,
                                                   std::optional<std::string_view> sectorName);

}  // namespace hearth
