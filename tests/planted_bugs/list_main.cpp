#include <cstdio>

#include "math/planted_bug.h"

int main() {
  for (const std::string_view name : hearth::kPlantedBugNames)
    std::printf("%.*s\n", static_cast<int>(name.size()), name.data());
}
