#pragma once

#include "cli/info/contents.h"

namespace hearth {

/// Prints the counts of what there is, in words.
void printInfo(const LoadedLevel& loaded, const Contents& contents);

}  // namespace hearth
