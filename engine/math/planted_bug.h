#pragma once

#include <array>
#include <string_view>

namespace hearth {

/// Mistakes that engines of this kind are known to make, each a switch of the test build
/// (HEARTH_PLANTED_BUGS): the environment variable HEARTH_PLANTED_BUG names the one to make. The
/// tests must fail with any of them; tests/planted_bugs shows that they do. In all other builds
/// `planted` is false when compiled, and nothing is left of them.
enum class PlantedBug {
  SidewallsUnlit,
  LowerStepsUnlit,
  BorderTexelsBlack,
  LightmapHalfTexelOff,
  FlatsUnfiltered,
  UpperStepPeggedAtTop,
  LowerStepPeggedAtBottom,
  SidewallRelativeIgnored,
  SidewallMirrored,
  FlatPortalByName,
  SkyStepAsWall,
  StackPieceLitOverWholeWall,
  NearPlaneAtOneCentimetre,
  EightBitSums,
  LightThroughSteps,
  LightStoppedBySky,
  LightThroughSlopes,
  LightInPlaneShines,
  GridAnchoredToPiece,
  RowsRoundedDown,
  TruncatingRepeat,
  PitchIgnored,
  RelativeFlatIgnored,
  AlongIgnored,
  SkyByScreenColumn,
  SectorLightForgottenOnSteps,
  NonConvexByFirstWall,
  RoundingTruncates,
  ChannelLost,
  MultiplyAddFused,
  RadiusIgnored,
  SamplesOutsideTexel,
  CurveExtrapolated,
  CosineOfWrongNormal,
  StaleSavedBakeAccepted,
  BeamThroughPillars,
  BeamThroughSteps,
  BeamThroughStacks,
  BeamThroughWedges,
  BeamThroughHangingWedges,
  BeamPastFlatPortals,
  BeamThroughMiddles,
  ConeThroughPillars,
  ConeThroughSteps,
  ConeThroughWedges,
  ConePastFlatPortals,
  ConeThroughMiddles,
};

inline constexpr std::array<std::string_view, 47> kPlantedBugNames = {
    "sidewalls-unlit",
    "lower-steps-unlit",
    "border-texels-black",
    "lightmap-half-texel-off",
    "flats-unfiltered",
    "upper-step-pegged-at-top",
    "lower-step-pegged-at-bottom",
    "sidewall-relative-ignored",
    "sidewall-mirrored",
    "flat-portal-by-name",
    "sky-step-as-wall",
    "stack-piece-lit-over-whole-wall",
    "near-plane-at-one-centimetre",
    "eight-bit-sums",
    "light-through-steps",
    "light-stopped-by-sky",
    "light-through-slopes",
    "light-in-plane-shines",
    "grid-anchored-to-piece",
    "rows-rounded-down",
    "truncating-repeat",
    "pitch-ignored",
    "relative-flat-ignored",
    "along-ignored",
    "sky-by-screen-column",
    "sector-light-forgotten-on-steps",
    "non-convex-by-first-wall",
    "rounding-truncates",
    "channel-lost",
    "multiply-add-fused",
    "radius-ignored",
    "samples-outside-texel",
    "curve-extrapolated",
    "cosine-of-wrong-normal",
    "stale-saved-bake-accepted",
    "beam-through-pillars",
    "beam-through-steps",
    "beam-through-stacks",
    "beam-through-wedges",
    "beam-through-hanging-wedges",
    "beam-past-flat-portals",
    "beam-through-middles",
    "cone-through-pillars",
    "cone-through-steps",
    "cone-through-wedges",
    "cone-past-flat-portals",
    "cone-through-middles",
};

#ifdef HEARTH_PLANTED_BUGS
bool planted(PlantedBug bug);
#else
constexpr bool planted(PlantedBug) { return false; }
#endif

}  // namespace hearth
