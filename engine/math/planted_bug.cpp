#include "math/planted_bug.h"

#ifdef HEARTH_PLANTED_BUGS

#include <cstdlib>

namespace hearth {

bool planted(PlantedBug bug) {
  static const std::string_view chosen = [] {
    const char* name = std::getenv("HEARTH_PLANTED_BUG");
    return name ? std::string_view(name) : std::string_view();
  }();
  return chosen == kPlantedBugNames[static_cast<std::size_t>(bug)];
}

}  // namespace hearth

#endif
