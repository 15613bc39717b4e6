#include "lint/findings.h"

#include <algorithm>

namespace hearth {

namespace {

constexpr bool areInOrder() {
  for (std::size_t i = 0; i < kFindingKinds.size(); ++i)
    if (kFindingKinds[i].kind != static_cast<FindingKind>(i)) return false;
  return true;
}
static_assert(areInOrder(), "the table has the order of the enumeration");

}  // namespace

void Findings::add(FindingKind kind, Place place, std::string message, std::string_view advice) {
  if (!said_.insert({place, message}).second) return;
  report_.warning(place, std::move(message), std::string(advice),
                  kFindingKinds[static_cast<std::size_t>(kind)].name);
}

}  // namespace hearth
