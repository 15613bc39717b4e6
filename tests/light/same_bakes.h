#pragma once

#include "level/level.h"
#include "light/bakery.h"

namespace hearth::test {

/// The same light to the byte, and found with as much work.
void expectSame(const Level& level, const BakedLight& rebaked, const BakedLight& baked);

}  // namespace hearth::test
