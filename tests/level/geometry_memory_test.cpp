// That flats move without taking memory.

#include <gtest/gtest.h>

#include "rooms_with_door.h"
#include "support/allocations.h"

namespace hearth {
namespace {

TEST(MoveFlats, takesNoMemory) {
  LoadedLevel rooms = roomsWithDoor();
  const std::size_t before = test::allocationCount();
  for (const double z : {1.0, 0.0, 2.5, 2.0}) moveFlats(rooms.level, kDoor, {0, z}, rooms.geometry);
  EXPECT_EQ(test::allocationCount(), before);
}

}  // namespace
}  // namespace hearth
