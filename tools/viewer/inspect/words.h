#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "viewer/inspect/inspect.h"
#include "viewer/inspect/mesh_at.h"

/// The results of an inspection in words.
namespace hearth {

/// `wall 3 of hall`, `lower step at wall 3 of hall`; in an inner loop `of hall/pier`, of a stack
/// `wall 3 part 1`, counted from 0 as in the file. A sidewall is named by the sector whose slope it
/// belongs to, too; a mesh as by `meshWords`.
std::string surfaceWords(const Level& level, const TruthHit& place);

/// The mesh that a ray has met, as index into Level::meshes.
std::size_t indexOfMesh(const Level& level, const TruthHit& onMesh);

/// The sector whose slope a sidewall belongs to.
SectorId slopedSectorOf(const Level& level, const TruthHit& sidewall);

/// `1.25,3,0.4`, as files have it: metres, to a millimetre.
std::string pointWords(Vec3 point, std::string_view separator = ",");

/// Of 255: to whole levels, or to a tenth where they are fewer than ten.
std::string levelWords(double level);
/// The largest of three channels.
double brightest(Vec3 levels);

/// How bright the place is, and how much of that comes from lights.
std::string brightnessWords(const Level& level, const Inspection& found);

/// `camera sprite "lamp"`; without a name its image stands for it.
std::string spriteWords(const Level& level, std::size_t sprite);
/// How bright it is, of which lights give what its lightmap holds, if it has one.
std::string spriteBrightnessWords(const Level& level, std::size_t sprite, const BakedLight& light);

/// `mesh "crate"`; without a name `mesh 3`, counted from 0.
std::string meshWords(const Level& level, std::size_t mesh);
/// How bright it is at a place of one of its faces, of which lights give what its lightmap holds,
/// if it has one.
std::string meshBrightnessWords(const Level& level, const MeshHit& found, const BakedLight& light);

/// Why a light gives the place nothing, or hardly anything, and what to do about it; or the
/// fraction of a ball that the place sees. Empty if it sees all of the light.
std::string reasonWords(const Level& level, const SurfacePoint& place, const LightFinding& finding);

}  // namespace hearth
