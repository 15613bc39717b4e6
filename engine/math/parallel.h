#pragma once

#include <cstddef>
#include <functional>

namespace hearth {

/// All cores of the machine.
int availableThreads();

/// Calls work(i) for every i in [0, count), on `threads` threads in no fixed order. `work` must
/// write only to what belongs to i. What it throws is thrown on, once all threads have stopped; of
/// several exceptions the first. Indices that were not begun are then left out.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace hearth
