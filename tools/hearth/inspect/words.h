#pragma once

#include <string>

#include "hearth/inspect/inspect.h"

/// What an inspection has found, in words.
namespace hearth {

/// `lower step of hall, wall 3`; in an inner loop `of hall/pier, wall 3`, of a stack `wall 3 part
/// 1`, counted from 0 as in the file. A sidewall is named by the sector whose wedge it belongs to.
std::string surfaceWords(const Level& level, const TruthHit& place);

/// The sector whose wedge a sidewall belongs to.
SectorId wedgeOf(const Level& level, const TruthHit& sidewall);

/// `1.25,3,0.4`: metres, to a millimetre.
std::string pointWords(Vec3 point);

/// Why a light gives a place nothing, or what share of a ball sees it; empty for all of a light.
std::string reasonWords(const Level& level, const LightFinding& finding);

}  // namespace hearth
