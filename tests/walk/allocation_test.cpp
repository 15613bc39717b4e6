#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "halls.h"
#include "support/in_tree.h"

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

TEST(Walker, TakesNoMemoryFromTheHeapBesideAMeshOfAThousandSides) {
  for (const double radius : {0.3, 0.5, 1.0, 1.2}) {
    const LoadedLevel hall =
        test::hallWith(fmt::format("{{'mesh':'gon.obj','x':6,'y':2,'scale':[{0},{0},1]}}", radius),
                       4, {{"gon.obj", test::gon(1000)}});
    Walker walker = test::standing(hall.scene(), "hall", {2, 2.05, 0});
    const long before = allocations;
    int ticksBeside = 0;
    for (int tick = 0; tick < 64 * 6; ++tick) {
      const Walker next = walked(hall.scene(), walker, test::kRun);
      (void)eyeBetween(hall.scene(), walker, next, 0.5);
      walker = next;
      ticksBeside += length(walker.feet.xy() - Vec2{6, 2}) < radius + 0.301;
    }
    EXPECT_EQ(allocations - before, 0) << radius;
    EXPECT_GT(ticksBeside, 20);
  }
}

}  // namespace
}  // namespace hearth
