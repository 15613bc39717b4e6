#include "text/json_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "text/json_text.h"

namespace hearth {

namespace {

std::string replaced(std::string_view json, TextRange range, std::string_view text) {
  return fmt::format("{}{}{}", json.substr(0, range.begin), text, json.substr(range.end));
}

std::string inserted(std::string_view json, std::size_t at, std::string_view text) {
  return replaced(json, {at, at}, text);
}

std::optional<MemberRange> memberNamed(const std::vector<MemberRange>& members,
                                       std::string_view name) {
  const auto found = std::ranges::find(members, name, &MemberRange::name);
  return found == members.end() ? std::nullopt : std::optional(*found);
}

/// What parts a value or key from what stands in front of it: a line break and the blanks behind
/// it, or a blank.
std::string gapBefore(std::string_view json, std::size_t begin) {
  const std::string_view line = lastLineOf(blanksBefore(json, begin));
  return line.starts_with('\n') || line.starts_with("\r\n") ? std::string(line) : " ";
}

std::string withMemberAtEnd(std::string_view json, std::size_t object, std::string_view member) {
  const std::vector<MemberRange> members = membersAt(json, object);
  if (members.empty())
    return replaced(json, valueAt(json, object), fmt::format("{{ {} }}", member));
  const std::string gap = gapBefore(json, members.back().key.begin);
  return inserted(json, members.back().value.end, fmt::format(",{}{}", gap, member));
}

std::string withElementAtEnd(std::string_view json, std::size_t array, std::string_view element) {
  const std::vector<TextRange> elements = elementsAt(json, array);
  if (elements.empty()) return replaced(json, valueAt(json, array), fmt::format("[{}]", element));
  const std::string gap = gapBefore(json, elements.back().begin);
  return inserted(json, elements.back().end, fmt::format(",{}{}", gap, element));
}

/// `{ "a": { "b": value } }`; the value where the path is empty.
std::string nested(std::span<const std::string_view> path, std::string_view value) {
  std::string text(value);
  for (auto key = path.rbegin(); key != path.rend(); ++key)
    text = fmt::format("{{ \"{}\": {} }}", *key, text);
  return text;
}

}  // namespace

std::string withValueAt(std::string_view json, std::span<const std::string_view> path,
                        std::string_view value) {
  TextRange at = valueAt(json, rootOf(json));
  for (; !path.empty() && json[at.begin] == '{'; path = path.subspan(1)) {
    const auto member = memberNamed(membersAt(json, at.begin), path.front());
    if (!member)
      return withMemberAtEnd(
          json, at.begin, fmt::format("\"{}\": {}", path.front(), nested(path.subspan(1), value)));
    at = member->value;
  }
  return replaced(json, at, nested(path, value));
}

std::string withElementIn(std::string_view json, std::string_view key, std::string_view before,
                          std::string_view value) {
  const std::size_t root = rootOf(json);
  const std::vector<MemberRange> members = membersAt(json, root);
  if (const auto array = memberNamed(members, key))
    return withElementAtEnd(json, array->value.begin, value);
  const auto follower = memberNamed(members, before);
  if (!follower) return withMemberAtEnd(json, root, fmt::format("\"{}\": [{}]", key, value));
  const std::string gap = gapBefore(json, follower->key.begin);
  const std::string array =
      gap == " " ? fmt::format("[{}]", value) : fmt::format("[{}  {}{}]", gap, value, gap);
  return inserted(json, follower->key.begin, fmt::format("\"{}\": {},{}", key, array, gap));
}

}  // namespace hearth
