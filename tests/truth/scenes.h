#pragma once

#include <cstdint>
#include <string>

#include "test_level.h"

namespace hearth {

/// Levels that nowhere overlap themselves in space, at most 100 m wide.
struct TestScene {
  std::string name;
  double size = 0;  ///< metres, of its longest side
  TestLevel level;
};

/// A yard and its neighbours: skies of two heights, steps, a closed door, pillars, a pool, slopes,
/// a wall of three pieces.
TestScene yardScene();

/// Two storeys cut differently, joined by flat portals all over.
TestScene storeysScene(std::uint64_t seed);

/// A grid of crooked cells with heights, slopes, skies and stacks at random.
TestScene gridScene(std::uint64_t seed);

}  // namespace hearth
