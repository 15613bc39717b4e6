#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hearth {

/// A place in one of the files of a load: the first byte of a value, or the opening quote of a key.
/// Line, column and pointer are worked out only for the places that are reported.
struct Place {
  std::uint32_t document = 0;
  std::uint32_t offset = 0;  ///< bytes

  friend constexpr auto operator<=>(Place, Place) = default;
};

enum class JsonKind : std::uint8_t { Null, False, True, Number, String, Key, Array, Object };

/// A value or a key of a Document. 24 bytes, and up to 8 more for its content: the tree of a
/// hostile file (`[0,0,0,...`) takes at most 16 times the file's size.
struct JsonNode {
  std::uint32_t offset;   ///< bytes into the file
  std::uint32_t parent;   ///< node; its own index for the root
  std::uint32_t ordinal;  ///< index among the elements (members) of the parent
  std::uint32_t end;      ///< one past the last node of its subtree; 0 while it is being read
  std::uint32_t content;  ///< index into `numbers` or `textEnds`
  JsonKind kind;
};

/// A JSON file as a tree in which every node knows its place. Nodes stand in the order of the file:
/// a node's first child follows it at once, an object's children are key, value, key, value, ...
/// Values of keys that start with `$` or `//` are left out.
struct Document {
  std::string file;  ///< as messages name it
  std::string text;
  std::deque<JsonNode> nodes;  ///< empty when nothing could be read
  std::deque<double> numbers;
  std::string texts;  ///< all strings, one after the other
  std::deque<std::uint32_t> textEnds;

  std::string_view textOf(const JsonNode& node) const {
    const std::uint32_t begin = node.content == 0 ? 0 : textEnds[node.content - 1];
    return std::string_view(texts).substr(begin, textEnds[node.content] - begin);
  }
};

/// JSON pointer (RFC 6901) of the innermost node at `offset`.
std::string pointerAt(const Document& document, std::uint32_t offset);

/// One value of a document; cheap to copy.
class JsonValue {
 public:
  struct Member;

  JsonValue(const Document& document, std::uint32_t documentIndex, std::uint32_t node)
      : document_(&document), documentIndex_(documentIndex), node_(node) {}

  JsonKind kind() const { return node().kind; }
  bool isNumber() const { return kind() == JsonKind::Number; }
  bool isString() const { return kind() == JsonKind::String; }
  bool isArray() const { return kind() == JsonKind::Array; }
  bool isObject() const { return kind() == JsonKind::Object; }
  bool isNull() const { return kind() == JsonKind::Null; }
  bool isBoolean() const { return kind() == JsonKind::True || kind() == JsonKind::False; }

  double number() const { return document_->numbers[node().content]; }
  std::string_view text() const { return document_->textOf(node()); }  ///< of a string or key
  Place place() const { return {documentIndex_, node().offset}; }
  std::vector<std::string_view> characters() const;  ///< of a string or key: its code points
  std::size_t characterCount() const;
  std::vector<Place> characterPlaces() const;  ///< of a string: where they are in the file

  std::vector<JsonValue> elements() const;           ///< of an array
  JsonValue front() const { return at(node_ + 1); }  ///< of an array that is not empty
  std::vector<Member> members() const;               ///< of an object
  std::size_t size() const;                          ///< the number of elements; O(size)

 private:
  const JsonNode& node() const { return document_->nodes[node_]; }
  JsonValue at(std::uint32_t node) const { return {*document_, documentIndex_, node}; }

  const Document* document_;
  std::uint32_t documentIndex_;
  std::uint32_t node_;
};

struct JsonValue::Member {
  JsonValue key;
  JsonValue value;
};

}  // namespace hearth
