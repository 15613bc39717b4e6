#pragma once

#include <string>

#include "load/json/document.h"
#include "load/json/report.h"

namespace hearth {

/// Deeper nesting than this is refused: no level needs more than nine.
inline constexpr std::size_t kMaxJsonDepth = 64;

/// Reads JSON text into a tree. Mistakes go to the report: the first one against JSON's grammar
/// ends the reading, duplicate keys do not. None of the tree may be used after errors of grammar
/// except for resolving places; then the result is false.
/// Expects: fewer than 2^32 bytes of text in `document`.
bool parse(Document& document, std::uint32_t documentIndex, Report& report);

}  // namespace hearth
