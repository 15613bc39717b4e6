#include "support/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocations = 0;
std::atomic<std::size_t> bytesAskedFor = 0;

void* counted(std::size_t bytes) {
  ++allocations;
  bytesAskedFor += bytes;
  void* memory = std::malloc(bytes == 0 ? 1 : bytes);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

// The other forms of new and delete call these, except those of over-aligned types.
void* operator new(std::size_t bytes) { return counted(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace hearth::test {

std::size_t allocationCount() { return allocations; }
std::size_t allocatedBytes() { return bytesAskedFor; }

}  // namespace hearth::test
