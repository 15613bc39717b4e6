#include "hearth/json_edit.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>

#include "hearth/layout_items.h"

namespace hearth {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// A JSON text and a way to where its values end.
class Text {
 public:
  explicit Text(std::string_view json) : source_(itemize(json)) {}

  const Item& item(std::uint32_t index) const { return source_.items[index]; }
  std::optional<std::uint32_t> lastChild(std::uint32_t parent) const;
  std::optional<std::uint32_t> member(std::uint32_t object, std::string_view key) const;
  /// Behind its last byte.
  std::size_t endOf(std::uint32_t index) const;
  /// What parts a child from what stands in front of it: a line break and the blanks behind it, or
  /// a blank.
  std::string gapBefore(std::uint32_t child) const;
  /// Puts a child at the end of an array or object.
  std::string append(std::uint32_t parent, std::string_view child) const;
  std::string insert(std::size_t at, std::string_view text) const { return replace(at, at, text); }
  std::string replace(std::size_t begin, std::size_t end, std::string_view text) const;

 private:
  std::size_t beginOf(std::uint32_t index) const {
    return item(index).keyBytes > 0 ? item(index).key : item(index).begin;
  }

  ItemizedText source_;
};

std::optional<std::uint32_t> Text::lastChild(std::uint32_t parent) const {
  std::optional<std::uint32_t> last;
  for (std::uint32_t i = parent + 1; i < item(parent).next; i = item(i).next) last = i;
  return last;
}

std::optional<std::uint32_t> Text::member(std::uint32_t object, std::string_view key) const {
  for (std::uint32_t i = object + 1; i < item(object).next; i = item(i).next)
    if (source_.keyOf(item(i)) == fmt::format("\"{}\"", key)) return i;
  return std::nullopt;
}

std::size_t Text::endOf(std::uint32_t index) const {
  if (item(index).kind == ItemKind::Scalar) return item(index).begin + item(index).bytes;
  const auto last = lastChild(index);
  return source_.text.find_first_of("]}", last ? endOf(*last) : item(index).begin) + 1;
}

std::string Text::gapBefore(std::uint32_t child) const {
  const std::size_t end = beginOf(child);
  const std::string_view blanks =
      source_.text.substr(0, end).substr(source_.text.find_last_not_of(kBlanks, end - 1) + 1);
  const std::size_t lineBreak = blanks.rfind('\n');
  if (lineBreak == std::string_view::npos) return " ";
  const bool isOfWindows = lineBreak > 0 && blanks[lineBreak - 1] == '\r';
  return std::string(blanks.substr(lineBreak - (isOfWindows ? 1 : 0)));
}

std::string Text::append(std::uint32_t parent, std::string_view child) const {
  if (const auto last = lastChild(parent))
    return insert(endOf(*last), "," + gapBefore(*last) + std::string(child));
  const bool isInArray = item(parent).kind == ItemKind::Array;
  return replace(item(parent).begin + 1, endOf(parent) - 1,
                 fmt::format(fmt::runtime(isInArray ? "{}" : " {} "), child));
}

std::string Text::replace(std::size_t begin, std::size_t end, std::string_view text) const {
  return fmt::format("{}{}{}", source_.text.substr(0, begin), text, source_.text.substr(end));
}

}  // namespace

std::string withMember(std::string_view json, std::span<const std::string_view> path,
                       std::string_view value) {
  const Text text(json);
  std::uint32_t at = 0;
  for (std::size_t depth = 0; depth < path.size(); ++depth) {
    std::string rest(value);
    for (std::size_t i = path.size() - 1; i > depth; --i)
      rest = fmt::format("{{ \"{}\": {} }}", path[i], rest);
    if (text.item(at).kind != ItemKind::Object)
      return text.replace(text.item(at).begin, text.endOf(at),
                          fmt::format("{{ \"{}\": {} }}", path[depth], rest));
    const auto child = text.member(at, path[depth]);
    if (!child) return text.append(at, fmt::format("\"{}\": {}", path[depth], rest));
    at = *child;
  }
  return text.replace(text.item(at).begin, text.endOf(at), value);
}

std::string withElement(std::string_view json, std::string_view key, std::string_view before,
                        std::string_view value) {
  const Text text(json);
  if (const auto array = text.member(0, key)) return text.append(*array, value);
  const auto follower = text.member(0, before);
  if (!follower) return text.append(0, fmt::format("\"{}\": [{}]", key, value));
  const std::string gap = text.gapBefore(*follower);
  const std::string array =
      gap == " " ? fmt::format("[{}]", value) : fmt::format("[{}  {}{}]", gap, value, gap);
  return text.insert(text.item(*follower).key, fmt::format("\"{}\": {},{}", key, array, gap));
}

}  // namespace hearth
