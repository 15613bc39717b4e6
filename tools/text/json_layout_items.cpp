#include "text/json_layout_items.h"

#include <algorithm>

#include "text/json_text.h"

namespace hearth {

namespace {

/// Arrays of more objects than this have a line for each: walls, shots, lights.
constexpr std::size_t kMaxObjectsInALine = 2;

/// Reads values one after the other.
class Itemizer {
 public:
  explicit Itemizer(ItemizedText& result)
      : text_(result.text), items_(result.items), result_(result) {}

  void readText() {
    skipBlanks();
    readValue({}, false);
  }

 private:
  /// Steps over blanks; whether there was a blank line among them.
  bool skipBlanks();
  std::uint32_t skipString();
  /// `isDivided`: the children of the array or object around it have lines of their own.
  void readValue(Item item, bool isDivided);
  void readScalar(Item item);
  void readContainer(Item item, bool isDivided);
  bool isListOfScalars(std::uint32_t index) const;
  void readChildren(std::uint32_t parent, bool dividesChildren);
  std::uint8_t columnsInLine(std::uint32_t parent) const;
  bool isDividing(const Item& item) const;

  std::string_view text_;
  std::deque<Item>& items_;
  const ItemizedText& result_;
  std::size_t at_ = 0;
};

bool Itemizer::skipBlanks() {
  const std::size_t end = std::min(text_.find_first_not_of(kJsonBlanks, at_), text_.size());
  const std::string_view blanks = text_.substr(at_, end - at_);
  at_ = end;
  return std::ranges::count(blanks, '\n') > 1;
}

std::uint32_t Itemizer::skipString() {
  const std::size_t begin = at_++;
  for (; text_[at_] != '"'; ++at_)
    if (text_[at_] == '\\') ++at_;
  return static_cast<std::uint32_t>(++at_ - begin);
}

/// Of what the format has most of: each sector and each loop is easier to find by lines of its own.
bool Itemizer::isDividing(const Item& item) const {
  const std::string_view key = result_.keyOf(item);
  return key == "\"sectors\"" || key == "\"loops\"";
}

void Itemizer::readValue(Item item, bool isDivided) {
  item.begin = static_cast<std::uint32_t>(at_);
  if (text_[at_] == '{' || text_[at_] == '[')
    readContainer(item, isDivided);
  else
    readScalar(item);
}

void Itemizer::readScalar(Item item) {
  if (text_[at_] == '"') {
    item.bytes = skipString();
  } else {
    const std::size_t end = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
    item.bytes = static_cast<std::uint32_t>(end - at_);
    at_ = end;
  }
  item.next = static_cast<std::uint32_t>(items_.size() + 1);
  item.columns = static_cast<std::uint8_t>(columnsOf(text_.substr(item.begin, item.bytes)));
  items_.push_back(item);
}

void Itemizer::readContainer(Item item, bool isDivided) {
  const auto index = static_cast<std::uint32_t>(items_.size());
  item.kind = text_[at_] == '{' ? ItemKind::Object : ItemKind::Array;
  items_.push_back(item);
  const bool dividesChildren = isDividing(item);
  readChildren(index, dividesChildren);
  Item& read = items_[index];
  read.next = static_cast<std::uint32_t>(items_.size());
  if (isListOfScalars(index)) {
    if (result_.keyOf(read) == "\"v\"") read.kind = ItemKind::Points;
    if (result_.keyOf(read) == "\"rows\"") read.kind = ItemKind::Rows;
  }
  const bool isBroken = read.holdsObject && (isDivided || dividesChildren || index == 0);
  read.columns = isBroken ? Item::kNoLine : columnsInLine(index);
}

bool Itemizer::isListOfScalars(std::uint32_t index) const {
  const Item& item = items_[index];
  if (item.kind != ItemKind::Array) return false;
  for (std::uint32_t i = index + 1; i < item.next; ++i)
    if (items_[i].kind != ItemKind::Scalar) return false;
  return true;
}

void Itemizer::readChildren(std::uint32_t parent, bool dividesChildren) {
  const bool isObject = items_[parent].kind == ItemKind::Object;
  ++at_;  // the bracket
  for (;;) {
    Item child;
    child.followsBlankLine = skipBlanks();
    if (text_[at_] == ']' || text_[at_] == '}') break;
    if (isObject) {
      child.key = static_cast<std::uint32_t>(at_);
      child.keyBytes = skipString();
      skipBlanks();
      ++at_;  // the colon
      skipBlanks();
    }
    const std::size_t index = items_.size();
    readValue(child, dividesChildren);
    const Item& read = items_[index];
    items_[parent].holdsObject |= read.holdsObject || read.kind == ItemKind::Object;
    skipBlanks();
    if (text_[at_] == ',') ++at_;
  }
  ++at_;  // the bracket
}

std::uint8_t Itemizer::columnsInLine(std::uint32_t parent) const {
  const Item& item = items_[parent];
  std::size_t columns = 0;
  std::size_t children = 0;
  std::size_t objects = 0;
  for (std::uint32_t i = parent + 1; i < item.next; i = items_[i].next) {
    columns += result_.columnsOfMember(items_[i]);
    if (items_[i].kind == ItemKind::Object) ++objects;
    ++children;
    if (columns > kLineColumns) return Item::kNoLine;
  }
  if (item.kind == ItemKind::Array && objects > kMaxObjectsInALine) return Item::kNoLine;
  if (item.kind == ItemKind::Rows && children > 1) return Item::kNoLine;
  if (children == 0) return 2;
  columns += (hasInnerBlanks(item) ? 4 : 2) + 2 * (children - 1);
  if (item.kind == ItemKind::Points) columns -= children / 2;
  return static_cast<std::uint8_t>(std::min(columns, kLineColumns + 1));
}

}  // namespace

std::size_t columnsOf(std::string_view text) {
  std::size_t columns = 0;
  for (const char c : text) {
    // All bytes of a character but the first are 10xxxxxx.
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) ++columns;
    if (columns > kLineColumns) break;
  }
  return columns;
}

std::size_t ItemizedText::columnsOfMember(const Item& item) const {
  constexpr std::size_t kColonAndBlank = 2;
  return item.columns + (item.keyBytes > 0 ? columnsOf(keyOf(item)) + kColonAndBlank : 0);
}

bool hasInnerBlanks(const Item& item) { return item.kind == ItemKind::Object || item.holdsObject; }

bool isSecondOfPair(const Item& parent, std::size_t ordinal) {
  return parent.kind == ItemKind::Points && ordinal % 2 == 1;
}

ItemizedText itemize(std::string_view json) {
  ItemizedText result{json, {}};
  Itemizer(result).readText();
  return result;
}

}  // namespace hearth
