#pragma once

#include "load/load.h"
#include "render/renderer.h"

namespace hearth::extremes {

/// Light for pictures without it.
BakedLight noLightOf(const Level& level);

/// Fails the running test where a picture of textures alone has a hole, or a pixel that the
/// reference renderer sees in another colour farther than 0.02 pixels from any edge. `stride`: of
/// the pixels each so manieth is compared.
void expectAsTruth(const LoadedLevel& loaded, const Camera& camera, int stride = 1);

/// Pixels that nothing covers.
int holesIn(const LoadedLevel& loaded, const Camera& camera);

}  // namespace hearth::extremes
