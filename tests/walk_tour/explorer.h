#pragma once

#include <vector>

#include "level/scene.h"
#include "walk/walker.h"

namespace hearth::test {

enum class Gait { OnFoot, Flying };

/// Inputs with which a walker that starts there has been in as many sectors as a search finds in
/// its time. It tries short stretches at random, from places that it has seldom tried (see
/// Ecoffet et al., "First return, then explore", 2021), until one leads to a new sector; from there
/// it begins again. Sectors from which no way leads back come last: `noReturn` are entered only
/// when no other is left. The same for the same scene and walker.
std::vector<WalkInput> exploration(const Scene& scene, const Walker& start, Gait gait,
                                   const std::vector<SectorId>& noReturn);

/// By sector: whether the walker's feet have been in it.
std::vector<bool> visitedSectors(const Scene& scene, Walker walker,
                                 const std::vector<WalkInput>& inputs);

}  // namespace hearth::test
