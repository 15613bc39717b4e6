#pragma once

#include <algorithm>

/// Every tolerance of the engine, with its unit and where it comes from.
namespace hearth {

/// Metres. Differences that no author means: vertices, planes and heights closer than this coincide
/// (a thousandth of the shortest edge concerned where that is less).
inline constexpr double kAuthorNoise = 1e-3;
inline constexpr double kAuthorNoiseOfEdge = 1e-3;

/// Metres, of the shortest edge concerned.
constexpr double noiseOf(double shortestEdge) {
  return std::min(kAuthorNoise, kAuthorNoiseOfEdge * shortestEdge);
}

/// Metres. How far a position (player, camera, light) may miss the sector that it is in.
inline constexpr double kPositionSlack = 1e-6;

/// Metres. Shorter walls are refused, whatever the scale of a level: the slack of positions.
inline constexpr double kShortestWall = kPositionSlack;

/// Metres. A light no farther than this in front of a plane lies in it, and does not light it: the
/// slack that positions have.
inline constexpr double kInPlane = 1e-6;

/// Sine of an angle. A sun no higher above a plane lies in it, and does not light it: more than the
/// rounding of directions, and less than kInPlane at 1 km.
inline constexpr double kInPlaneSine = 1e-10;

/// Metres. An eye or a light on the very border of its sector is moved this far inside, so that
/// every wall is either clearly in front of it or clearly behind: 1000 times the rounding of
/// coordinates of 4 km, and a millionth of a pixel at 1 mm.
inline constexpr double kNudge = 1e-9;

/// Metres. Lengths and heights that two pieces of one level share differ by no more than this
/// through rounding: ten times that of coordinates of 10^6 m. Less of a sidewall, of a common edge
/// or of a slope's rise is none.
inline constexpr double kHeightNoise = 1e-9;

/// Metres before its target within which nothing stops a ray of light: the target lies on a
/// surface, and rounding may put the crossing on either side of it. A tenth of kEdgeInset, so that
/// a surface beside the edge of another still stops a ray to that edge.
inline constexpr double kArrival = 1e-7;

/// Metres. Rays of light arrive at least about this far off the edges of a surface: the slack that
/// positions have. A shadow moves by no more.
inline constexpr double kEdgeInset = 1e-6;

/// Of an angle at a light, as its sine: directions closer than this are one. Rounding turns none by
/// as much, and at 1 km it is less than kArrival.
inline constexpr double kNarrow = 1e-11;

/// Fraction of a distance from a light: walls of which one is this much nearer are equally far.
/// More than rounding, and less than two walls that meet are apart where kNarrow begins.
inline constexpr double kSameDistance = 1e-14;

/// Metres from the origin up to which all of these are more than rounding: doubles are 2 * 10^-9
/// apart there, a fiftieth of kArrival, of which following a ray to its end takes a part.
inline constexpr double kPreciseReach = 1e7;

/// Fraction of a distance from the eye or the light. Crossings that are nearer to each other are
/// put in order exactly; their rounding, a few 10^-16 of the distance, is far less unless the ray
/// is nearly in line with a wall.
inline constexpr double kNearTie = 1e-9;

/// Texels. Rounding may move a point at most so far outside its surface before bilinear filtering
/// reads it: thousands of times the rounding of coordinates of 2^20 texels.
inline constexpr double kFilterSlack = 1e-6;

/// Fraction of an area, of a sum of triangles: what rounding of its coordinates may change it by.
inline constexpr double kAreaNoise = 1e-12;

}  // namespace hearth
