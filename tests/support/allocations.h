#pragma once

#include <cstddef>

namespace hearth::test {

/// How often this program has taken memory by `new`, in all of its threads. Only programs that link
/// hearth_test_allocations count.
std::size_t allocationCount();

/// How many bytes it has asked for in all of these, whether or not it has given them back.
std::size_t allocatedBytes();

}  // namespace hearth::test
