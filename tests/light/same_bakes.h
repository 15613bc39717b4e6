#pragma once

#include "level/scene.h"
#include "light/bakery.h"

namespace hearth::test {

/// The same light to the byte, and found with as much work.
void expectSame(const Scene& scene, const BakedLight& rebaked, const BakedLight& baked);

}  // namespace hearth::test
