#pragma once

#include "load/load.h"

namespace hearth::fuzz {

/// Stops the program unless a load says what it should: a level or errors, and every message in
/// full.
void expectSaid(const LoadResult& result);

/// Draws a level from places all over it and bakes it with coarse texels. Stops the program where a
/// picture has a hole.
void expectUsable(const LoadedLevel& loaded);

}  // namespace hearth::fuzz
