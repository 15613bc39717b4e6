#include "load/read/description.h"

#include <fmt/format.h>

namespace hearth {

std::string LoopDescription::ends(std::size_t wall) const {
  const Vec2 from = vertices[wall];
  const Vec2 to = vertices[(wall + 1) % vertices.size()];
  return fmt::format("from ({}, {}) to ({}, {})", from.x, from.y, to.x, to.y);
}

}  // namespace hearth
