#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hearth {

/// The same JSON in the house's layout, which tools/README.md describes: keys, strings and numbers
/// in their order and as they are spelled, with other blanks between them. Nothing where it would
/// be longer than `maxBytes`: a deeply nested text can grow a hundredfold by its indentation.
/// Expects: JSON that parse() has taken.
std::optional<std::string> layOut(std::string_view json, std::uint64_t maxBytes);

}  // namespace hearth
