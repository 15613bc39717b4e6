#include "load/json/document.h"

#include <fmt/format.h>

#include <algorithm>

namespace hearth {

namespace {

/// The node at `offset`, or the innermost one that was being read there when reading stopped.
std::uint32_t nodeAt(const Document& document, std::uint32_t offset) {
  const auto after = std::upper_bound(
      document.nodes.begin(), document.nodes.end(), offset,
      [](std::uint32_t value, const JsonNode& node) { return value < node.offset; });
  if (after == document.nodes.begin()) return 0;
  auto index = static_cast<std::uint32_t>(after - document.nodes.begin() - 1);
  if (document.nodes[index].offset == offset || document.nodes[index].kind == JsonKind::Key)
    return index;
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

std::size_t JsonValue::size() const {
  std::size_t count = 0;
  for (std::uint32_t i = node_ + 1; i < node().end; i = document_->nodes[i].end) ++count;
  return count;
}

}  // namespace hearth
