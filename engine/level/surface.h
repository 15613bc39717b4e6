#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "level/ids.h"
#include "level/texture_mapping.h"

namespace hearth {

/// All kinds of surface that can show. Reports use this order, and isSky(), isSprite(), isThing()
/// and isUpright() rely on it.
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
  CameraSprite,
  FixedSprite,
  FlatSprite,
  Mesh,
  SkyCeiling,
  SkyFloor,
  SkyUpperStep,
  SkyLowerStep,
};
inline constexpr std::size_t kSurfaceKindCount =
    static_cast<std::size_t>(SurfaceKind::SkyLowerStep) + 1;

std::string_view name(SurfaceKind kind);

constexpr bool isSky(SurfaceKind kind) { return kind >= SurfaceKind::SkyCeiling; }
constexpr bool isSidewall(SurfaceKind kind) {
  return kind == SurfaceKind::FloorSidewall || kind == SurfaceKind::CeilingSidewall;
}
/// Whether it is level, and no sky.
constexpr bool isLevelFlat(SurfaceKind kind) {
  return kind == SurfaceKind::Floor || kind == SurfaceKind::Ceiling;
}
constexpr bool isSlope(SurfaceKind kind) {
  return kind == SurfaceKind::SlopeFloor || kind == SurfaceKind::SlopeCeiling;
}
/// Whether it is a sprite: it stands or lies in the air of its sector, and bounds none.
constexpr bool isSprite(SurfaceKind kind) {
  return kind >= SurfaceKind::CameraSprite && kind <= SurfaceKind::FlatSprite;
}
/// Whether it is a sprite or a mesh.
constexpr bool isThing(SurfaceKind kind) { return isSprite(kind) || kind == SurfaceKind::Mesh; }
/// Whether texels of its image may be holes, through which what is behind it shows.
constexpr bool mayHaveHoles(SurfaceKind kind) {
  return kind == SurfaceKind::MaskedMiddle || isSprite(kind);
}
/// Whether it shines where it wears the texture of an emitter.
constexpr bool canShine(SurfaceKind kind) { return !isSky(kind) && !mayHaveHoles(kind); }
/// Whether it stands upright on a segment.
constexpr bool isUpright(SurfaceKind kind) {
  return kind <= SurfaceKind::MaskedMiddle || kind >= SurfaceKind::SkyUpperStep;
}
/// Whether it faces downwards.
constexpr bool facesDown(SurfaceKind kind) {
  return kind == SurfaceKind::Ceiling || kind == SurfaceKind::SlopeCeiling ||
         kind == SurfaceKind::SkyCeiling;
}

/// A part of a sector's boundary that can show, or a thing in its air. A part of the boundary is
/// drawn with one texture and lit by one lightmap. `SurfaceGeometry` says whether it shows, and
/// between which heights.
struct Surface {
  SurfaceKind kind;
  SectorId sector;                   ///< whose air it bounds, and whose `light` it takes
  std::optional<SegmentId> segment;  ///< of `sector`; upright surfaces only
  TextureMapping mapping;            ///< as authored; of a sprite its first image, of a mesh
                                     ///< its first face's
};

}  // namespace hearth
