#pragma once

/// Every tolerance of the engine, with its unit and where it comes from.
namespace hearth {

/// Metres. What an author cannot mean: vertices, planes and heights closer than this coincide
/// (a thousandth of the shortest edge concerned where that is less).
inline constexpr double kAuthorNoise = 1e-3;
inline constexpr double kAuthorNoiseOfEdge = 1e-3;

/// Metres. How far a position (player, camera, light) may miss the sector that it is in.
inline constexpr double kPositionSlack = 1e-6;

/// Metres. A light no farther than this in front of a plane lies in it, and does not light it: the
/// slack that positions have.
inline constexpr double kInPlane = 1e-6;

/// Metres. An eye or a light on the very border of its sector is moved this far inside, so that
/// every wall is either clearly in front of it or clearly behind: 1000 times the rounding of
/// coordinates of 4 km, and a millionth of a pixel at 1 mm.
inline constexpr double kNudge = 1e-9;

/// Metres. Less of a sidewall than this is rounding between two slopes that continue each other.
inline constexpr double kHeightNoise = 1e-9;

}  // namespace hearth
