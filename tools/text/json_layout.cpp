#include "text/json_layout.h"

#include "text/json_layout_items.h"

namespace hearth {

namespace {

constexpr std::size_t kIndent = 2;
/// Lists go on below their first value, but not so far to the right that few fit.
constexpr std::size_t kRightmostList = kLineColumns / 2;

/// Where a value stands.
struct Spot {
  std::size_t indent;  ///< column of a line that begins with it, or with its key
  std::size_t tail;    ///< columns that must follow in its last line: commas and brackets
  bool isInArray;
};

/// How the children of an array or object stand that is not in one line.
struct Breaking {
  bool isFilled;   ///< as many to a line as fit; else a line for each
  bool isHanging;  ///< the first stands behind the opening bracket, the others below it
  std::size_t indent;
};

class Printer {
 public:
  Printer(const ItemizedText& source, std::uint64_t maxBytes)
      : source_(source), maxBytes_(maxBytes) {}

  std::optional<std::string> print() {
    printValue(0, {0, 0, false});
    out_ += '\n';
    if (isFull()) return std::nullopt;
    return std::move(out_);
  }

 private:
  /// One of the children of a broken array or object.
  struct Child {
    std::uint32_t index;
    std::uint32_t previous;  ///< child before it; the parent, of the first
    std::size_t ordinal;
    std::size_t tailOfLast;  ///< of the child that is the last one
    Spot spot;
  };

  const Item& item(std::uint32_t index) const { return source_.items[index]; }
  std::string_view keyOf(std::uint32_t index) const { return source_.keyOf(item(index)); }
  bool isComment(std::uint32_t index) const { return keyOf(index).starts_with("\"//"); }
  bool isFull() const { return out_.size() > maxBytes_; }
  bool fits(std::size_t columns) const { return column_ + columns <= kLineColumns; }

  void put(std::string_view text);
  void putLineBreak(std::size_t indent);
  void printValue(std::uint32_t index, const Spot& spot);
  void printInLine(std::uint32_t index);
  void printBroken(std::uint32_t index, const Spot& spot);
  void printKey(std::uint32_t index, std::string_view gap);
  Breaking breakingOf(std::uint32_t index, const Spot& spot) const;
  void separate(const Item& parent, const Breaking& breaking, const Child& child);
  bool goesOn(const Item& parent, const Child& child) const;
  std::string_view gapOf(const Item& parent, const Breaking& breaking, const Child& child) const;

  const ItemizedText& source_;
  std::uint64_t maxBytes_;
  std::string out_;
  std::size_t column_ = 0;
};

void Printer::put(std::string_view text) {
  out_ += text;
  column_ += columnsOf(text);
}

void Printer::putLineBreak(std::size_t indent) {
  out_ += '\n';
  out_.append(indent, ' ');
  column_ = indent;
}

void Printer::printValue(std::uint32_t index, const Spot& spot) {
  const bool isEmpty = item(index).next == index + 1;  // as scalars are
  if (isEmpty || fits(item(index).columns + spot.tail))
    printInLine(index);
  else
    printBroken(index, spot);
}

void Printer::printInLine(std::uint32_t index) {
  const Item& value = item(index);
  if (value.kind == ItemKind::Scalar) return put(source_.text.substr(value.begin, value.bytes));
  const bool isObject = value.kind == ItemKind::Object;
  const std::string_view inner = hasInnerBlanks(value) && value.next > index + 1 ? " " : "";
  put(isObject ? "{" : "[");
  put(inner);
  std::size_t ordinal = 0;
  for (std::uint32_t i = index + 1; i < value.next; i = item(i).next, ++ordinal) {
    if (ordinal > 0) put(isSecondOfPair(value, ordinal) ? "," : ", ");
    printKey(i, " ");
    printInLine(i);
  }
  put(inner);
  put(isObject ? "}" : "]");
}

void Printer::printKey(std::uint32_t index, std::string_view gap) {
  if (item(index).keyBytes == 0) return;
  put(keyOf(index));
  put(":");
  put(gap);
}

Breaking Printer::breakingOf(std::uint32_t index, const Spot& spot) const {
  const Item& value = item(index);
  const bool isFilled = !value.holdsObject && value.kind != ItemKind::Rows;
  if (value.kind == ItemKind::Object) return {isFilled, spot.isInArray, spot.indent + kIndent};
  const bool isAligned = isFilled && column_ < kRightmostList;
  return {isFilled, isFilled, isAligned ? column_ + 1 : spot.indent + kIndent};
}

void Printer::printBroken(std::uint32_t index, const Spot& spot) {
  const Item& parent = item(index);
  const bool isObject = parent.kind == ItemKind::Object;
  const Breaking breaking = breakingOf(index, spot);
  const std::string_view close = !isObject ? "]" : breaking.isHanging ? " }" : "}";
  put(!isObject ? "[" : breaking.isHanging ? "{ " : "{");
  const std::size_t tailOfLast = breaking.isHanging ? close.size() + spot.tail : 0;
  Child child{index + 1, index, 0, tailOfLast, {breaking.indent, 0, !isObject}};
  for (; child.index < parent.next && !isFull(); ++child.ordinal) {
    const bool isLast = item(child.index).next == parent.next;
    child.spot.tail = isLast ? tailOfLast : 1;
    separate(parent, breaking, child);
    printKey(child.index, gapOf(parent, breaking, child));
    printValue(child.index, child.spot);
    if (!isLast) put(",");
    child.previous = child.index;
    child.index = item(child.index).next;
  }
  if (!breaking.isHanging) putLineBreak(spot.indent);
  put(close);
}

/// From the child before, or from the opening bracket.
void Printer::separate(const Item& parent, const Breaking& breaking, const Child& child) {
  if (child.ordinal == 0 && breaking.isHanging) return;
  if (isSecondOfPair(parent, child.ordinal)) return;
  if (child.ordinal > 0 && breaking.isFilled && goesOn(parent, child)) return put(" ");
  if (!breaking.isFilled && item(child.index).followsBlankLine) out_ += '\n';
  putLineBreak(breaking.indent);
}

/// Whether a child follows the one before in the same line.
bool Printer::goesOn(const Item& parent, const Child& child) const {
  if (isComment(child.index) || isComment(child.previous)) return false;
  const std::size_t columns = 1 + source_.columnsOfMember(item(child.index));
  const std::uint32_t second = item(child.index).next;
  if (parent.kind != ItemKind::Points || second == parent.next)
    return fits(columns + child.spot.tail);
  const bool isLast = item(second).next == parent.next;
  return fits(columns + 1 + item(second).columns + (isLast ? child.tailOfLast : 1));
}

/// Between a key and its value: a sector's floor is set in line with its ceiling below.
std::string_view Printer::gapOf(const Item& parent, const Breaking& breaking,
                                const Child& child) const {
  constexpr std::string_view kWide = "   ";
  const std::uint32_t next = item(child.index).next;
  const bool isAboveCeiling = !breaking.isFilled && keyOf(child.index) == "\"floor\"" &&
                              next < parent.next && keyOf(next) == "\"ceiling\"";
  const std::size_t columns = source_.columnsOfMember(item(child.index)) + kWide.size() - 1;
  return isAboveCeiling && fits(columns + child.spot.tail) ? kWide : " ";
}

}  // namespace

std::optional<std::string> layOut(std::string_view json, std::uint64_t maxBytes) {
  const ItemizedText source = itemize(json);
  return Printer(source, maxBytes).print();
}

}  // namespace hearth
