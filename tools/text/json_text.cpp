#include "text/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "math/check.h"

namespace hearth {

namespace {

std::size_t skipBlanks(std::string_view json, std::size_t at) {
  return std::min(json.find_first_not_of(kJsonBlanks, at), json.size());
}

std::size_t stringEnd(std::string_view json, std::size_t begin) {
  std::size_t at = begin + 1;
  while (json[at] != '"') at += json[at] == '\\' ? 2 : 1;
  return at + 1;
}

/// Of an array or an object.
std::size_t bracketEnd(std::string_view json, std::size_t begin) {
  std::size_t depth = 0;
  std::size_t at = begin;
  do {
    const char c = json[at];
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    at = c == '"' ? stringEnd(json, at) : at + 1;
  } while (depth > 0);
  return at;
}

/// Where the next element or member begins behind one that ends at `end`.
std::size_t nextAfter(std::string_view json, std::size_t end) {
  const std::size_t at = skipBlanks(json, end);
  return json[at] == ',' ? skipBlanks(json, at + 1) : at;
}

Replacement replacing(std::string_view json, TextRange range, std::string after) {
  return {range.begin, std::string(range.of(json)), std::move(after)};
}

/// Takes the part at `index` out, of parts that commas separate.
Replacement without(std::string_view json, std::size_t bracket, const std::vector<TextRange>& parts,
                    std::size_t index) {
  TextRange out = parts[index];
  if (index + 1 < parts.size())
    out.end = parts[index + 1].begin;
  else if (index > 0)
    out.begin = parts[index - 1].end;
  else
    out = {bracket + 1, skipBlanks(json, out.end)};
  return replacing(json, out, "");
}

/// Each with its key.
std::vector<TextRange> partsOf(const std::vector<MemberRange>& members) {
  std::vector<TextRange> parts;
  for (const MemberRange& member : members) parts.push_back({member.key.begin, member.value.end});
  return parts;
}

/// The blanks within an object.
struct ObjectManner {
  std::string open = " ";
  std::string beforeKey = " ";  ///< behind a comma
  std::string colon = ": ";
  std::string close = " ";
};

/// Of a member and what is before it.
ObjectManner mannerOf(std::string_view json, std::size_t object,
                      const std::vector<MemberRange>& members, std::size_t index) {
  const MemberRange& member = members[index];
  ObjectManner manner;
  manner.open = json.substr(object + 1, members.front().key.begin - object - 1);
  if (index > 0) {
    const std::size_t comma = json.find(',', members[index - 1].value.end);
    manner.beforeKey = json.substr(comma + 1, member.key.begin - comma - 1);
  }
  manner.colon = json.substr(member.key.end, member.value.begin - member.key.end);
  const std::size_t last = members.back().value.end;
  manner.close = json.substr(last, skipBlanks(json, last) - last);
  return manner;
}

/// The last of those that are named, if there is one.
std::optional<std::size_t> lastOf(const std::vector<MemberRange>& members,
                                  const std::vector<std::string_view>& names) {
  const auto found = std::find_if(members.rbegin(), members.rend(), [&](const MemberRange& member) {
    return std::ranges::find(names, member.name) != names.end();
  });
  if (found == members.rend()) return std::nullopt;
  return static_cast<std::size_t>(members.rend() - found) - 1;
}

/// Puts a member before all that an object has.
Replacement withFirst(std::string_view json, std::size_t object,
                      const std::vector<MemberRange>& members, std::string_view key,
                      std::string_view value) {
  if (members.empty()) return {object + 1, "", fmt::format("\"{}\": {}", key, value)};
  const ObjectManner manner = mannerOf(json, object, members, members.size() > 1 ? 1 : 0);
  return {members.front().key.begin, "",
          fmt::format("\"{}\"{}{},{}", key, manner.colon, value, manner.beforeKey)};
}

bool hasBlanks(std::string_view json) {
  return json.find_first_of(kJsonBlanks) != std::string_view::npos;
}

std::string spelled(const std::vector<SpelledMember>& members, const ObjectManner& manner) {
  std::string text = "{" + manner.open;
  for (const SpelledMember& member : members) {
    if (&member != &members.front()) text += "," + manner.beforeKey;
    text += fmt::format("\"{}\"{}{}", member.key, manner.colon, member.value);
  }
  return text + manner.close + "}";
}

/// The line break before an object that stands alone in the array, and the one behind it: empty in
/// a text of one line.
struct Lines {
  std::string before;
  std::string behind;
};

Lines linesIn(std::string_view json, std::size_t array) {
  if (json.find('\n') == std::string_view::npos) return {};
  const std::string feed = json.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
  const std::size_t line = json.rfind('\n', array) + 1;  // npos + 1 is the text's begin
  const std::size_t text = std::min(json.find_first_not_of(" \t", line), array);
  const std::string indentation(json.substr(line, text - line));
  const std::string_view step = json.find("\n\t") == std::string_view::npos ? "  " : "\t";
  return {fmt::format("{}{}{}", feed, indentation, step), feed + indentation};
}

Replacement withFirstObject(std::string_view json, std::size_t array,
                            const std::vector<SpelledMember>& members) {
  const bool isCompact = !hasBlanks(json);
  const std::string object =
      spelled(members, isCompact ? ObjectManner{"", "", ":", ""} : ObjectManner{});
  const auto [before, behind] = linesIn(json, array);
  return replacing(json, {array + 1, skipBlanks(json, array + 1)}, before + object + behind);
}

}  // namespace

std::size_t rootOf(std::string_view json) { return skipBlanks(json, 0); }

TextRange valueAt(std::string_view json, std::size_t begin) {
  switch (json[begin]) {
    case '"':
      return {begin, stringEnd(json, begin)};
    case '[':
    case '{':
      return {begin, bracketEnd(json, begin)};
    default:
      return {begin, std::min(json.find_first_of(" \t\r\n,]}", begin), json.size())};
  }
}

std::string_view blanksBefore(std::string_view json, std::size_t end) {
  const std::string_view before = json.substr(0, end);
  return before.substr(before.find_last_not_of(kJsonBlanks) + 1);  // npos + 1 is the begin
}

std::string_view lastLineOf(std::string_view blanks) {
  const std::size_t feed = blanks.rfind('\n');
  if (feed == std::string_view::npos) return blanks;
  return blanks.substr(feed > 0 && blanks[feed - 1] == '\r' ? feed - 1 : feed);
}

std::vector<MemberRange> membersAt(std::string_view json, std::size_t object) {
  std::vector<MemberRange> members;
  for (std::size_t at = skipBlanks(json, object + 1); json[at] != '}';) {
    const TextRange key = valueAt(json, at);
    const std::size_t colon = skipBlanks(json, key.end);
    const TextRange value = valueAt(json, skipBlanks(json, colon + 1));
    members.push_back({nlohmann::json::parse(key.of(json)), key, value});
    at = nextAfter(json, value.end);
  }
  return members;
}

std::optional<std::size_t> commentIn(std::string_view json,
                                     const std::vector<MemberRange>& members) {
  const auto found = std::ranges::find_if(members, [json](const MemberRange& member) {
    return member.name.starts_with("//") && json[member.value.begin] == '"';
  });
  if (found == members.end()) return std::nullopt;
  return static_cast<std::size_t>(found - members.begin());
}

std::vector<TextRange> elementsAt(std::string_view json, std::size_t array) {
  std::vector<TextRange> elements;
  for (std::size_t at = skipBlanks(json, array + 1); json[at] != ']';) {
    elements.push_back(valueAt(json, at));
    at = nextAfter(json, elements.back().end);
  }
  return elements;
}

Replacement withMember(std::string_view json, std::size_t object, const SpelledMember& member,
                       const std::vector<std::string_view>& earlier) {
  const std::vector<MemberRange> members = membersAt(json, object);
  const auto found = std::ranges::find(members, member.key, &MemberRange::name);
  if (found != members.end()) return replacing(json, found->value, member.value);
  const std::optional<std::size_t> anchor = lastOf(members, earlier);
  if (!anchor) return withFirst(json, object, members, member.key, member.value);
  const ObjectManner manner = mannerOf(json, object, members, *anchor);
  const std::size_t at = members[*anchor].value.end;
  return {at, "",
          fmt::format(",{}\"{}\"{}{}", manner.beforeKey, member.key, manner.colon, member.value)};
}

Replacement withoutMember(std::string_view json, std::size_t object, std::string_view key) {
  const std::vector<MemberRange> members = membersAt(json, object);
  const auto found = std::ranges::find(members, key, &MemberRange::name);
  CHECK(found != members.end(), key);
  return without(json, object, partsOf(members), static_cast<std::size_t>(found - members.begin()));
}

Replacement withComment(std::string_view json, std::size_t object, std::string_view comment) {
  const std::vector<MemberRange> members = membersAt(json, object);
  if (const auto old = commentIn(json, members))
    return replacing(json, members[*old].value, std::string(comment));
  return withFirst(json, object, members, "//", comment);
}

Replacement withoutComment(std::string_view json, std::size_t object) {
  const std::vector<MemberRange> members = membersAt(json, object);
  const auto comment = commentIn(json, members);
  CHECK(comment, object);
  return without(json, object, partsOf(members), *comment);
}

Replacement withObject(std::string_view json, std::size_t array,
                       const std::vector<SpelledMember>& members) {
  const std::vector<TextRange> elements = elementsAt(json, array);
  if (elements.empty()) return withFirstObject(json, array, members);
  const TextRange last = elements.back();
  const std::vector<MemberRange> like = membersAt(json, last.begin);
  const ObjectManner manner =
      mannerOf(json, last.begin, like, *lastOf(like, {"x", "y", "z", "angle", "pitch"}));
  const std::size_t before =
      elements.size() > 1 ? json.find(',', elements[elements.size() - 2].end) : array;
  const std::string_view blanks = json.substr(before + 1, last.begin - before - 1);
  return {last.end, "", fmt::format(",{}{}", lastLineOf(blanks), spelled(members, manner))};
}

Replacement withoutElement(std::string_view json, std::size_t array, std::size_t index) {
  return without(json, array, elementsAt(json, array), index);
}

}  // namespace hearth
