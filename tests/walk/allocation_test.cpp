#include <atomic>
#include <cstdlib>
#include <new>

#include "support/in_tree.h"
#include "walks.h"

namespace {

std::atomic<long> allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// All of this program's memory is counted.
void* operator new(std::size_t size) { return counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new(std::size_t size, std::align_val_t) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace hearth {
namespace {

TEST(Walker, TakesNoMemoryFromTheHeap) {
  const LoadResult result = loadLevel(test::inTree("levels/tutorial.json"));
  const Scene scene = result.loaded->scene();
  const Player& player = *scene.level().player;
  Walker walker = walkerAt(scene, player.sector, player.eye, player.angle, 0);
  const long before = allocations;
  for (int tick = 0; tick < 64 * 60; ++tick) {
    WalkInput input{.forward = 127, .turn = tick % 512 - 200, .run = true};
    input.toggleFlight = tick % 1000 == 500;
    const Walker next = walked(scene, walker, input);
    (void)eyeBetween(scene, walker, next, 0.5);
    walker = next;
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_NE(walker.feet.xy(), player.eye.xy());
}

}  // namespace
}  // namespace hearth
