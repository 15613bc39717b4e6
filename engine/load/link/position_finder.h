#pragma once

#include <optional>

#include "load/link/link.h"
#include "load/positions.h"

namespace hearth {

/// Finds the sectors of positions that the files describe. Reports those that lie in none, but not
/// those that may lie in a sector about which a mistake has been reported.
class PositionFinder {
 public:
  /// The linking, whose geometry is derived, must outlive it.
  explicit PositionFinder(const Linking& linking);

  /// In the sector that the author names, or in any; `place` is that of the position.
  std::optional<SectorId> find(Place place, Vec3 p, const std::optional<NameReference>& name,
                               PositionOf what) const;

  struct Standing {
    SectorId sector;
    Vec3 position;
  };
  /// Where a thing stands: at its height, or else on the bottom of the air.
  std::optional<Standing> find(const ThingDescription& thing) const;

 private:
  template <typename Locate>
  std::optional<SectorId> find(Place place, const std::optional<NameReference>& name,
                               Locate&& locate) const;

  const Linking& linking_;
  Locator locator_;
  bool anyDoubtful_ = false;
};

}  // namespace hearth
