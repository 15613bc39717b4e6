#include "settings/shell_text.h"

namespace hearth {

std::string shellWord(std::string_view text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./,:=+@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos)
    return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string typedOptions(const OptionValues& values, const std::vector<Option>& options) {
  std::string text;
  for (const Option option : options) {
    if (!values.has(option)) continue;
    text += ' ';
    text += row(option).name;
    if (row(option).kind == ValueKind::Flag) continue;
    for (const std::string& value : values.texts(option)) text += ' ' + shellWord(value);
  }
  return text;
}

}  // namespace hearth
