#include "cli/heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace hearth {

void useHugePages() {
  constexpr int kStep = 64 << 20;  // bytes; those that nothing touches take no memory
  constexpr int kLargeObject =
      32 << 20;  // from so many bytes on, memory is not taken from the heap
  constexpr std::uintptr_t kHugePage = 2 << 20;
  mallopt(M_TOP_PAD, kStep);
  mallopt(M_TRIM_THRESHOLD, 2 * kStep);
  mallopt(M_MMAP_THRESHOLD, kLargeObject);
  const auto end = [] { return static_cast<char*>(sbrk(0)); };
  char* const before = end();
  char* const begin = before + (kHugePage - reinterpret_cast<std::uintptr_t>(before) % kHugePage);
  // Grows the heap now, unless malloc is another one, as the sanitizers have. Without `volatile` a
  // compiler leaves both calls out.
  void* const volatile grown = std::malloc(kHugePage);
  std::free(grown);
  if (end() > begin) madvise(begin, static_cast<std::size_t>(end() - begin), MADV_HUGEPAGE);
}

}  // namespace hearth
