#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "level/ids.h"
#include "level/texture_mapping.h"

namespace hearth {

/// All kinds of surface that can show. The order is that of reports.
enum class SurfaceKind : std::uint8_t {
  Solid,
  LowerStep,
  UpperStep,
  StackSolid,
  StackLowerStep,
  StackUpperStep,
  FloorSidewall,
  CeilingSidewall,
  MaskedMiddle,
  Floor,
  Ceiling,
  SlopeFloor,
  SlopeCeiling,
  SkyCeiling,
  SkyFloor,
  SkyUpperStep,
  SkyLowerStep,
};
inline constexpr std::size_t kSurfaceKinds = 17;

std::string_view name(SurfaceKind kind);

constexpr bool isSky(SurfaceKind kind) { return kind >= SurfaceKind::SkyCeiling; }
constexpr bool isSidewall(SurfaceKind kind) {
  return kind == SurfaceKind::FloorSidewall || kind == SurfaceKind::CeilingSidewall;
}
constexpr bool isFlat(SurfaceKind kind) {
  return kind == SurfaceKind::Floor || kind == SurfaceKind::Ceiling;
}
constexpr bool isSlope(SurfaceKind kind) {
  return kind == SurfaceKind::SlopeFloor || kind == SurfaceKind::SlopeCeiling;
}
/// Stands upright on a segment (and is not sky).
constexpr bool isUpright(SurfaceKind kind) { return kind <= SurfaceKind::MaskedMiddle; }
/// Faces downwards.
constexpr bool isOverhead(SurfaceKind kind) {
  return kind == SurfaceKind::Ceiling || kind == SurfaceKind::SlopeCeiling ||
         kind == SurfaceKind::SkyCeiling;
}

/// One thing that can show: what is drawn with one texture and lit by one lightmap. Whether it
/// shows, and between which heights, `SurfaceGeometry` tells.
struct Surface {
  SurfaceKind kind;
  SectorId sector;                   ///< whose air it bounds, and whose `light` it takes
  std::optional<SegmentId> segment;  ///< of `sector`; upright surfaces and sky steps only
  TextureMapping mapping;            ///< as authored
};

}  // namespace hearth
