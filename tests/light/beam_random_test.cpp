// Whether bakes with beams are those of rays, in hundreds of random levels.

#include <gtest/gtest.h>

#include "both_bakes.h"

namespace hearth {
namespace {

TEST(Beams, giveTheBytesOfRaysInManyRandomLevels) { test::expectSameRandomBakes(1000, 1400); }

}  // namespace
}  // namespace hearth
