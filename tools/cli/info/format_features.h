#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "level/scene.h"

namespace hearth {

/// The features of level and light files, by the rows of levels/README.md.
enum class FormatFeature : std::size_t {
  SolidWall,
  OneWallForLoop,
  PortalWithTexture,
  PortalWithSteps,
  PortalWithoutTexture,
  MiddleTexture,
  Stack,
  StackOfThree,
  StackWithTwoPortals,
  InnerLoop,
  InnerLoopAtBorder,
  StepUp,
  StepDown,
  ClosedDoor,
  OneWayPortal,
  PortalSplitDifferently,
  OverlappingSectors,
  SkyCeiling,
  SkyFloor,
  SkyCeilingStep,
  SkyFloorStep,
  FlatPortalString,
  FlatPortalObject,
  FlatPortalOfManySectors,
  SlopeFloor,
  SlopeCeiling,
  NullSlopeHeight,
  AbsoluteSidewall,
  RelativeSidewall,
  TextureScale,
  TextureOffset,
  TextureObject,
  TextureAlong,
  TextureZref,
  PlainColour,
  RelativeFlat,
  LevelLight,
  SectorLight,
  Player,
  Shot,
  PositionWithSector,
  PositionWithoutSector,
  Light,
  LightFalloff,
  LightCurve,
  LightColor,
  LightRadius,
  LightSpot,
  Sun,
  LightOfSky,
  Emitter,
  LightAboveSky,
  LightBelowSky,
  BakeSettings,
  CameraSprite,
  FixedSprite,
  FlatSprite,
  SolidSprite,
  BrightSprite,
  SpriteOfManySides,
  AnimatedSprite,
  Mesh,
  TwoSidedMesh,
  Grid,
  GridSides,
  GridNext,
  Mover,
  WallThatStarts,
  SwitchTexture,
};

struct FormatFeatureName {
  FormatFeature feature;
  std::string_view name;
};

/// All of them, in the order of the enumeration. The names are stable: scripts read them.
inline constexpr std::array kFormatFeatures{
    FormatFeatureName{FormatFeature::SolidWall, "solid wall"},
    FormatFeatureName{FormatFeature::OneWallForLoop, "one wall for a whole loop"},
    FormatFeatureName{FormatFeature::PortalWithTexture, "portal with texture"},
    FormatFeatureName{FormatFeature::PortalWithSteps, "portal with upper or lower"},
    FormatFeatureName{FormatFeature::PortalWithoutTexture, "portal without texture"},
    FormatFeatureName{FormatFeature::MiddleTexture, "middle texture"},
    FormatFeatureName{FormatFeature::Stack, "stack"},
    FormatFeatureName{FormatFeature::StackOfThree, "stack of three or more"},
    FormatFeatureName{FormatFeature::StackWithTwoPortals, "stack with two portals"},
    FormatFeatureName{FormatFeature::InnerLoop, "inner loop"},
    FormatFeatureName{FormatFeature::InnerLoopAtBorder, "inner loop touching the border"},
    FormatFeatureName{FormatFeature::StepUp, "step up"},
    FormatFeatureName{FormatFeature::StepDown, "step down"},
    FormatFeatureName{FormatFeature::ClosedDoor, "closed door"},
    FormatFeatureName{FormatFeature::OneWayPortal, "one-way portal"},
    FormatFeatureName{FormatFeature::PortalSplitDifferently,
                      "portal split differently on its sides"},
    FormatFeatureName{FormatFeature::OverlappingSectors, "overlapping sectors"},
    FormatFeatureName{FormatFeature::SkyCeiling, "sky ceiling"},
    FormatFeatureName{FormatFeature::SkyFloor, "sky floor"},
    FormatFeatureName{FormatFeature::SkyCeilingStep, "step between sky ceilings"},
    FormatFeatureName{FormatFeature::SkyFloorStep, "step between sky floors"},
    FormatFeatureName{FormatFeature::FlatPortalString, "flat portal as up-down"},
    FormatFeatureName{FormatFeature::FlatPortalObject, "flat portal as an object"},
    FormatFeatureName{FormatFeature::FlatPortalOfManySectors,
                      "interface with two sectors on a side"},
    FormatFeatureName{FormatFeature::SlopeFloor, "slope floor"},
    FormatFeatureName{FormatFeature::SlopeCeiling, "slope ceiling"},
    FormatFeatureName{FormatFeature::NullSlopeHeight, "null slope height"},
    FormatFeatureName{FormatFeature::AbsoluteSidewall, "absolute sidewall"},
    FormatFeatureName{FormatFeature::RelativeSidewall, "relative sidewall"},
    FormatFeatureName{FormatFeature::TextureScale, "texture scale"},
    FormatFeatureName{FormatFeature::TextureOffset, "texture offset"},
    FormatFeatureName{FormatFeature::TextureObject, "texture as an object"},
    FormatFeatureName{FormatFeature::TextureAlong, "texture along"},
    FormatFeatureName{FormatFeature::TextureZref, "texture zref"},
    FormatFeatureName{FormatFeature::PlainColour, "plain colour"},
    FormatFeatureName{FormatFeature::RelativeFlat, "relative flat"},
    FormatFeatureName{FormatFeature::LevelLight, "level light"},
    FormatFeatureName{FormatFeature::SectorLight, "sector light"},
    FormatFeatureName{FormatFeature::Player, "player"},
    FormatFeatureName{FormatFeature::Shot, "shot"},
    FormatFeatureName{FormatFeature::PositionWithSector, "position with its sector"},
    FormatFeatureName{FormatFeature::PositionWithoutSector, "position without sector"},
    FormatFeatureName{FormatFeature::Light, "light"},
    FormatFeatureName{FormatFeature::LightFalloff, "light with falloff"},
    FormatFeatureName{FormatFeature::LightCurve, "light with a curve"},
    FormatFeatureName{FormatFeature::LightColor, "light with a colour"},
    FormatFeatureName{FormatFeature::LightRadius, "light with a radius"},
    FormatFeatureName{FormatFeature::LightSpot, "light with a spot"},
    FormatFeatureName{FormatFeature::Sun, "sun"},
    FormatFeatureName{FormatFeature::LightOfSky, "light of the sky"},
    FormatFeatureName{FormatFeature::Emitter, "emitter"},
    FormatFeatureName{FormatFeature::LightAboveSky, "light above a sky ceiling"},
    FormatFeatureName{FormatFeature::LightBelowSky, "light below a sky floor"},
    FormatFeatureName{FormatFeature::BakeSettings, "bake settings"},
    FormatFeatureName{FormatFeature::CameraSprite, "sprite that faces the camera"},
    FormatFeatureName{FormatFeature::FixedSprite, "sprite that faces its angle"},
    FormatFeatureName{FormatFeature::FlatSprite, "sprite that lies flat"},
    FormatFeatureName{FormatFeature::SolidSprite, "solid sprite"},
    FormatFeatureName{FormatFeature::BrightSprite, "bright sprite"},
    FormatFeatureName{FormatFeature::SpriteOfManySides, "sprite with an image for each side"},
    FormatFeatureName{FormatFeature::AnimatedSprite, "animated sprite"},
    FormatFeatureName{FormatFeature::Mesh, "mesh"},
    FormatFeatureName{FormatFeature::TwoSidedMesh, "two-sided mesh"},
    FormatFeatureName{FormatFeature::Grid, "grid"},
    FormatFeatureName{FormatFeature::GridSides, "grid with textures by side"},
    FormatFeatureName{FormatFeature::GridNext, "grid that leads to another sector"},
    FormatFeatureName{FormatFeature::Mover, "mover"},
    FormatFeatureName{FormatFeature::WallThatStarts, "wall that starts a mover"},
    FormatFeatureName{FormatFeature::SwitchTexture, "wall whose texture a mover changes"},
};

/// How often a level uses each.
class FeatureCounts {
 public:
  std::int64_t operator[](FormatFeature feature) const {
    return counts_[static_cast<std::size_t>(feature)];
  }
  void add(FormatFeature feature, std::int64_t count = 1) {
    counts_[static_cast<std::size_t>(feature)] += count;
  }

 private:
  std::array<std::int64_t, kFormatFeatures.size()> counts_{};
};

/// Counts the features that the linked level still shows.
void countGeometry(const Scene& scene, FeatureCounts& counts);

/// Counts the spellings, which only the texts of the level's files show, and those of its lights,
/// if any. The files have been loaded without errors.
void countSpellings(std::span<const std::string_view> texts, FeatureCounts& counts);

}  // namespace hearth
