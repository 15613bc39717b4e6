#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <ostream>

namespace hearth {

/// An index into one vector of the Level. Each vector has its own type of index, so that a
/// segment's index cannot be used for a sector. "None" is an empty std::optional, never a special
/// value.
template <typename Tag>
struct Id {
  std::uint32_t value = 0;

  Id() = default;
  explicit constexpr Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr std::size_t index() const { return value; }
  friend constexpr auto operator<=>(Id, Id) = default;
  friend std::ostream& operator<<(std::ostream& out, Id id) { return out << '#' << id.value; }
};

using SectorId = Id<struct SectorTag>;
using SegmentId = Id<struct SegmentTag>;
using SurfaceId = Id<struct SurfaceTag>;
using TextureId = Id<struct TextureTag>;
using FlatPortalId = Id<struct FlatPortalTag>;
using LightId = Id<struct LightTag>;
using CellId = Id<struct CellTag>;  ///< over all wall grids

}  // namespace hearth
