#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace hearth {

/// Where the lines of a JSON text are no longer indented as its brackets nest.
struct IndentationSlip {
  std::size_t line;  ///< offset of the first character of the line that stands wrong

  /// The bracket that explains it: one that is open though the line stands outside of it, or one
  /// that has closed what the line stands in.
  std::size_t bracket;
  bool isOpen;
};

/// The first one. Texts that are not indented, or by no rule, have none that can be relied on: ask
/// only about a text whose brackets do not match.
std::optional<IndentationSlip> findIndentationSlip(std::string_view text);

}  // namespace hearth
