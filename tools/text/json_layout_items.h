#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string_view>

namespace hearth {

/// Columns of the house: longer lines are broken where they can be.
inline constexpr std::size_t kLineColumns = 100;

/// Columns of a text: characters of UTF-8. What does not fit into a line counts as just that.
std::size_t columnsOf(std::string_view text);

enum class ItemKind : std::uint8_t {
  Scalar,
  Array,
  Points,  ///< an array of scalars that come in pairs: corners
  Rows,    ///< an array of scalars that stand below one another: a plan of cells
  Object
};

/// A value of a JSON text, with its key where it is a member of an object: 24 bytes, as the text
/// may have millions (`[0,0,0,...`).
struct Item {
  std::uint32_t key = 0;       ///< bytes into the text: the opening quote
  std::uint32_t keyBytes = 0;  ///< with both quotes; 0 of what has no key
  std::uint32_t begin = 0;     ///< bytes into the text
  std::uint32_t bytes = 0;     ///< of a scalar
  std::uint32_t next = 0;      ///< item behind its last descendant
  std::uint8_t columns = 0;    ///< in one line, without its key; kNoLine where it must be broken
  ItemKind kind = ItemKind::Scalar;
  bool holdsObject = false;  ///< among its descendants
  bool followsBlankLine = false;

  static constexpr std::uint8_t kNoLine = kLineColumns + 1;
};

/// A JSON text as its values, in the order of the text: the first child of an array or object
/// stands directly behind it.
struct ItemizedText {
  std::string_view text;
  std::deque<Item> items;

  std::string_view keyOf(const Item& item) const { return text.substr(item.key, item.keyBytes); }
  /// In one line, with its key if it has one.
  std::size_t columnsOfMember(const Item& item) const;
};

/// Whether its brackets stand apart from its content in a line.
bool hasInnerBlanks(const Item& item);
/// Whether the child is the y of a point, which stands close to its x.
bool isSecondOfPair(const Item& parent, std::size_t ordinal);

/// Expects: JSON that parse() has taken, so that recursion is no deeper than that allows.
ItemizedText itemize(std::string_view json);

}  // namespace hearth
