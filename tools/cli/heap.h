#pragma once

namespace hearth {

/// Lets the heap grow in large steps, and asks the system for huge pages there. A program that
/// begins touches all its memory for the first time, and on a virtual machine each page of 4 KB
/// takes microseconds then: the castle's first picture touches 8,000 of them.
void useHugePages();

}  // namespace hearth
