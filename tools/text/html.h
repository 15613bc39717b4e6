#pragma once

#include <string>
#include <string_view>

namespace hearth {

/// Text as HTML and SVG show it, also within quotation marks.
std::string escaped(std::string_view text);

/// How a page begins, up to its body's text; `style` is CSS of its own.
std::string pageBegin(std::string_view title, std::string_view style);
inline constexpr std::string_view kPageEnd = "</body>\n</html>\n";

}  // namespace hearth
