#pragma once

#include <cstddef>

namespace hearth::test {

/// How often this program has taken memory by `new`, in all of its threads. Only programs that link
/// hearth_test_allocations count.
std::size_t allocationCount();

}  // namespace hearth::test
