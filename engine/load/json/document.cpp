#include "load/json/document.h"

#include <fmt/format.h>

#include <algorithm>

namespace hearth {

namespace {

bool isLeadOfUtf8(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

/// Of a character in a JSON string, which may be escaped: how many bytes it takes. `text` has been
/// parsed without an error.
std::size_t bytesOfCharacter(std::string_view text) {
  if (text[0] == '\\') {
    if (text[1] != 'u') return 2;
    const bool isHighSurrogate = (text[2] == 'd' || text[2] == 'D') &&
                                 std::string_view("89abAB").find(text[3]) != std::string_view::npos;
    return isHighSurrogate ? 12 : 6;
  }
  std::size_t bytes = 1;
  while (!isLeadOfUtf8(text[bytes])) ++bytes;
  return bytes;
}

/// Whether `offset` lies between the quotes of a string.
bool isInString(const Document& document, const JsonNode& string, std::uint32_t offset) {
  std::size_t at = string.offset + std::size_t{1};
  while (at < offset && document.text[at] != '"')
    at += bytesOfCharacter(std::string_view(document.text).substr(at));
  return document.text[at] != '"';
}

/// The node at `offset`, or the innermost one that was being read there when reading stopped.
std::uint32_t nodeAt(const Document& document, std::uint32_t offset) {
  const auto after = std::upper_bound(
      document.nodes.begin(), document.nodes.end(), offset,
      [](std::uint32_t value, const JsonNode& node) { return value < node.offset; });
  if (after == document.nodes.begin()) return 0;
  auto index = static_cast<std::uint32_t>(after - document.nodes.begin() - 1);
  const JsonNode& before = document.nodes[index];
  if (before.offset == offset || before.kind == JsonKind::Key) return index;
  if (before.kind == JsonKind::String && isInString(document, before, offset)) return index;
  while (index != 0 && document.nodes[index].end != 0) index = document.nodes[index].parent;
  return index;
}

/// `~` and `/` of a key, escaped as RFC 6901 asks.
std::string escaped(std::string_view key) {
  std::string result;
  for (const char c : key) {
    if (c == '~')
      result += "~0";
    else if (c == '/')
      result += "~1";
    else
      result += c;
  }
  return result;
}

}  // namespace

std::string pointerAt(const Document& document, std::uint32_t offset) {
  if (document.nodes.empty()) return "";
  std::string pointer;
  for (std::uint32_t index = nodeAt(document, offset); index != 0;) {
    const JsonNode& node = document.nodes[index];
    const bool inObject = document.nodes[node.parent].kind == JsonKind::Object;
    // The key of a member stands directly before its value.
    const JsonNode& key = node.kind == JsonKind::Key ? node : document.nodes[index - 1];
    pointer.insert(0, inObject ? fmt::format("/{}", escaped(document.textOf(key)))
                               : fmt::format("/{}", node.ordinal));
    index = node.parent;
  }
  return pointer;
}

std::vector<JsonValue> JsonValue::elements() const {
  std::vector<JsonValue> found;
  for (std::uint32_t i = node_ + 1; i < node().end; i = document_->nodes[i].end)
    found.push_back(at(i));
  return found;
}

std::vector<JsonValue::Member> JsonValue::members() const {
  std::vector<Member> found;
  for (std::uint32_t key = node_ + 1; key < node().end; key = document_->nodes[key + 1].end)
    found.push_back({at(key), at(key + 1)});
  return found;
}

std::vector<std::string_view> JsonValue::characters() const {
  std::vector<std::string_view> found;
  for (std::string_view rest = text(); !rest.empty(); rest.remove_prefix(found.back().size())) {
    const auto next = std::find_if(rest.begin() + 1, rest.end(), isLeadOfUtf8);
    found.push_back(rest.substr(0, static_cast<std::size_t>(next - rest.begin())));
  }
  return found;
}

std::size_t JsonValue::characterCount() const {
  return static_cast<std::size_t>(std::ranges::count_if(text(), isLeadOfUtf8));
}

std::vector<Place> JsonValue::characterPlaces() const {
  const std::string_view file = document_->text;
  std::vector<Place> places;
  for (std::size_t at = node().offset + std::size_t{1}; file[at] != '"';
       at += bytesOfCharacter(file.substr(at)))
    places.push_back({documentIndex_, static_cast<std::uint32_t>(at)});
  return places;
}

std::size_t JsonValue::size() const {
  std::size_t count = 0;
  for (std::uint32_t i = node_ + 1; i < node().end; i = document_->nodes[i].end) ++count;
  return count;
}

}  // namespace hearth
