#include "load/json/parse.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "load/json/indentation.h"

namespace hearth {

namespace {

using nlohmann::json;

/// Feeds bytes to the JSON library and counts them: that count is all the library lets us know
/// about where a value stands.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* consumed) : at_(at), consumed_(consumed) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*consumed_;
    return *this;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  std::size_t* consumed_;
};

bool isIgnored(std::string_view key) { return key.starts_with('$') || key.starts_with("//"); }

/// Receives the values of a text in order and builds the tree.
///
/// Where a value starts: the library reports it directly after its last byte (after a number, one
/// byte later). From the end of the previous value only blanks, one comma or one colon lie before
/// it, so its first byte is found by stepping over these.
class TreeBuilder {
 public:
  TreeBuilder(Document& document, std::uint32_t documentIndex, Report& report,
              const std::size_t& consumed)
      : document_(document), documentIndex_(documentIndex), report_(report), consumed_(consumed) {}

  // The interface that the JSON library calls; `false` stops it.
  bool null() { return addLiteral(JsonKind::Null); }
  bool boolean(bool value) { return addLiteral(value ? JsonKind::True : JsonKind::False); }
  bool number_integer(json::number_integer_t value) {
    return addNumber(static_cast<double>(value));
  }
  bool number_unsigned(json::number_unsigned_t value) {
    return addNumber(static_cast<double>(value));
  }
  bool number_float(json::number_float_t value, const json::string_t&) { return addNumber(value); }
  bool string(json::string_t& value) { return addString(value); }
  bool binary(json::binary_t&) { return false; }  // not a part of JSON text
  bool key(json::string_t& value) { return addKey(value); }
  bool start_object(std::size_t) { return open(JsonKind::Object); }
  bool start_array(std::size_t) { return open(JsonKind::Array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, const std::string& token, const json::exception& error);

 private:
  /// An array or object that is being read.
  struct Open {
    std::uint32_t node;
    std::uint32_t children;  ///< elements or members so far
    std::size_t firstKey;    ///< index of `keys_`
  };

  std::size_t startOfToken() const;
  bool addLiteral(JsonKind kind);
  bool addNumber(double value);
  bool addString(const std::string& value);
  bool addKey(const std::string& value);
  bool open(JsonKind kind);
  bool close();
  bool isSkipping() const { return skipNext_ || skippedDepth_ > 0; }
  std::uint32_t addNode(JsonKind kind, std::uint32_t content);
  std::uint32_t addText(const std::string& value);
  void reportDuplicates(const Open& object);
  std::string adviceAt(std::size_t start, std::string_view message) const;
  bool reportSlip(std::size_t start, std::string_view message);
  void finishValue() {
    skipNext_ = false;
    cursor_ = consumed_;
  }

  Document& document_;
  std::uint32_t documentIndex_;
  Report& report_;
  const std::size_t& consumed_;
  std::size_t cursor_ = 0;  ///< end of what has been understood
  std::vector<Open> stack_;
  std::vector<std::uint32_t> keys_;  ///< of all that is open: nodes
  std::size_t depth_ = 0;
  bool skipNext_ = false;         ///< an ignored key was read, its value comes next
  std::size_t skippedDepth_ = 0;  ///< arrays and objects open inside an ignored value
};

std::size_t TreeBuilder::startOfToken() const {
  const std::string_view text = document_.text;
  const auto afterBlanks = [text](std::size_t at) {
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (at < text.size() && isBlank(text[at])) ++at;
    return at;
  };
  const std::size_t start = afterBlanks(cursor_);
  const bool isBetween = start < text.size() && (text[start] == ',' || text[start] == ':');
  return isBetween ? afterBlanks(start + 1) : start;
}

std::uint32_t TreeBuilder::addNode(JsonKind kind, std::uint32_t content) {
  const auto index = static_cast<std::uint32_t>(document_.nodes.size());
  const std::uint32_t parent = stack_.empty() ? index : stack_.back().node;
  const std::uint32_t ordinal = stack_.empty() ? 0 : stack_.back().children;
  const bool isOpen = kind == JsonKind::Array || kind == JsonKind::Object;
  document_.nodes.push_back({static_cast<std::uint32_t>(startOfToken()), parent, ordinal,
                             isOpen ? 0 : index + 1, content, kind});
  if (!stack_.empty() && kind != JsonKind::Key) ++stack_.back().children;
  return index;
}

std::uint32_t TreeBuilder::addText(const std::string& value) {
  document_.texts += value;
  document_.textEnds.push_back(static_cast<std::uint32_t>(document_.texts.size()));
  return static_cast<std::uint32_t>(document_.textEnds.size() - 1);
}

bool TreeBuilder::addLiteral(JsonKind kind) {
  if (!isSkipping()) addNode(kind, 0);
  finishValue();
  return true;
}

bool TreeBuilder::addNumber(double value) {
  const std::size_t start = startOfToken();
  if (!isSkipping()) {
    document_.numbers.push_back(value + 0.0);  // -0 becomes 0: heights and points compare by bits
    addNode(JsonKind::Number, static_cast<std::uint32_t>(document_.numbers.size() - 1));
  }
  finishValue();
  // The library has looked at the byte after the number, which may be the comma.
  cursor_ =
      std::min(document_.text.find_first_not_of("+-.0123456789eE", start), document_.text.size());
  return true;
}

bool TreeBuilder::addString(const std::string& value) {
  if (!isSkipping()) addNode(JsonKind::String, addText(value));
  finishValue();
  return true;
}

bool TreeBuilder::addKey(const std::string& value) {
  if (!isSkipping()) {
    skipNext_ = isIgnored(value);
    if (!skipNext_) keys_.push_back(addNode(JsonKind::Key, addText(value)));
  }
  cursor_ = consumed_;
  return true;
}

bool TreeBuilder::open(JsonKind kind) {
  if (++depth_ > kMaxJsonDepth) {
    report_.error({documentIndex_, static_cast<std::uint32_t>(startOfToken())},
                  fmt::format("more than {} arrays and objects inside one another", kMaxJsonDepth),
                  "nest less deeply");
    return false;
  }
  if (isSkipping())
    ++skippedDepth_;
  else
    stack_.push_back({addNode(kind, 0), 0, keys_.size()});
  finishValue();
  return true;
}

bool TreeBuilder::close() {
  --depth_;
  cursor_ = consumed_;
  if (skippedDepth_ > 0) {
    --skippedDepth_;
    return true;
  }
  document_.nodes[stack_.back().node].end = static_cast<std::uint32_t>(document_.nodes.size());
  reportDuplicates(stack_.back());
  keys_.resize(stack_.back().firstKey);
  stack_.pop_back();
  return true;
}

void TreeBuilder::reportDuplicates(const Open& object) {
  const std::span keys = std::span(keys_).subspan(object.firstKey);
  const auto text = [&](std::uint32_t key) { return document_.textOf(document_.nodes[key]); };
  std::ranges::sort(keys, {}, [&](std::uint32_t key) { return std::pair(text(key), key); });
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (text(keys[i - 1]) != text(keys[i])) continue;
    report_.error({documentIndex_, document_.nodes[keys[i]].offset},
                  fmt::format("the key \"{}\" is given twice", text(keys[i])),
                  "remove or rename one of them");
  }
}

/// The part of the library's message that an author can use: what it expected and found.
std::string grammarMessage(std::string_view text) {
  const std::size_t dash = text.find(" - ");
  if (dash != std::string_view::npos) text.remove_prefix(dash + 3);
  const std::size_t last = text.find("; last read: ");
  std::string message(text.substr(0, last));
  const std::size_t expected = last == std::string_view::npos ? last : text.rfind("; expected ");
  if (expected != std::string_view::npos && expected > last) message += text.substr(expected);
  return "not valid JSON: " + message;
}

bool isComment(std::string_view text) { return text.starts_with("//") || text.starts_with("/*"); }

struct WordSlip {
  const char* what;
  const char* advice;
};

/// What the library tells of words and strings in words of its own.
std::optional<WordSlip> slipInWord(std::string_view text) {
  if (text.find("control character U+000A") != std::string_view::npos)
    return WordSlip{"a string without an end in its line", "end it with a quote"};
  if (text.find("invalid literal") != std::string_view::npos)
    return WordSlip{"a word or a number that is none of JSON",
                    "put words between double quotes, begin numbers with a digit or -"};
  return std::nullopt;
}

/// Counted from 1.
std::ptrdiff_t lineOf(const std::string& text, std::size_t offset) {
  return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
}

bool isOneOf(char c, std::string_view chars) { return chars.find(c) != std::string_view::npos; }

/// The slip that most likely left something unexpected at `start`, by what stands before it.
std::string TreeBuilder::adviceAt(std::size_t start, std::string_view message) const {
  constexpr const char* kUnclear = "correct the JSON here or just before";
  const std::string& text = document_.text;
  const std::string_view rest = std::string_view(text).substr(start);
  const std::size_t last =
      start == 0 ? std::string::npos : text.find_last_not_of(" \t\r\n", start - 1);
  if (isComment(rest)) return "write comments as keys that begin with \"//\", JSON has no others";
  if (last != std::string::npos && message.ends_with("expected end of input"))
    return fmt::format(
        "what begins in line {} is closed in line {}: remove this, or a bracket before",
        lineOf(text, document_.nodes.front().offset), lineOf(text, last));
  if (last == std::string::npos || stack_.empty() || isSkipping()) return kUnclear;
  const char next = rest.empty() ? '\0' : rest[0];
  const char end = message.ends_with("expected string literal") ? '}' : ']';
  if (text[last] == ',' && (next == ',' || next == end))
    return "remove the comma before it, or this";
  if (message.ends_with("expected ':'")) return "end the key with a quote and a colon";
  const auto closeFirst = [&](std::string_view otherwise) {
    return fmt::format("close what begins in line {} first{}",
                       lineOf(text, document_.nodes[stack_.back().node].offset), otherwise);
  };
  if (next == '{' && end == '}')
    return closeFirst(", write a key before this, or '[' where a list begins");
  if (std::isdigit(static_cast<unsigned char>(next)) && end == '}')
    return "write a key before it, or a point if this is a decimal";
  if (isOneOf(text[last], ",:[{")) return kUnclear;
  const bool isKey = next == ':' && document_.nodes[stack_.back().node].kind == JsonKind::Array;
  if (rest.empty() || isKey) return closeFirst("");
  if (isOneOf(next, "]}")) return closeFirst(", or remove this");
  return isOneOf(next, ",:") ? kUnclear : "put a comma before it if one is missing";
}

/// Brackets that do not match are often noticed far behind the slip, but authors indent.
bool TreeBuilder::reportSlip(std::size_t start, std::string_view message) {
  const std::string_view text = document_.text;
  const bool isOfBrackets = start == text.size() || isOneOf(text[start], "]}") ||
                            message.ends_with("expected end of input") ||
                            message.ends_with("expected '}'") || message.ends_with("expected ']'");
  if (!isOfBrackets) return false;
  const auto slip = findIndentationSlip(text.substr(0, start + 1));
  if (!slip) return false;
  const std::ptrdiff_t line = lineOf(document_.text, slip->bracket);
  const char bracket = text[slip->bracket];
  const Place place{documentIndex_, static_cast<std::uint32_t>(slip->line)};
  if (slip->isOpen)
    report_.error(place,
                  fmt::format("not valid JSON: by its indentation this line is outside of what "
                              "begins with '{}' in line {}, and that is still open",
                              bracket, line),
                  "close that before this line");
  else
    report_.error(place,
                  fmt::format("not valid JSON: by its indentation this line is inside of what the "
                              "'{}' of line {} has closed",
                              bracket, line),
                  fmt::format("remove that '{}'", bracket));
  return true;
}

bool TreeBuilder::parse_error(std::size_t, const std::string& token, const json::exception& error) {
  // An unexpected comma or colon may itself be what startOfToken() steps over.
  const std::size_t lastRead = consumed_ == 0 ? 0 : consumed_ - 1;
  const bool atEnd = startOfToken() >= document_.text.size() && consumed_ == document_.text.size();
  const std::size_t start = atEnd ? document_.text.size() : std::min(startOfToken(), lastRead);
  const Place place{documentIndex_, static_cast<std::uint32_t>(start)};
  constexpr int kOutOfRange = 406;
  if (error.id == kOutOfRange) {
    report_.error(place, fmt::format("the number {} is too large", token), "give a smaller one");
    return false;
  }
  const std::string_view rest = std::string_view(document_.text).substr(start);
  if (const auto slip = slipInWord(error.what()); slip && !isComment(rest)) {
    report_.error(place, std::string("not valid JSON: ") + slip->what, slip->advice);
    return false;
  }
  const std::string message = grammarMessage(error.what());
  if (!reportSlip(start, message)) report_.error(place, message, adviceAt(start, message));
  return false;
}

}  // namespace

bool parse(Document& document, std::uint32_t documentIndex, Report& report) {
  std::size_t consumed = 0;
  TreeBuilder builder(document, documentIndex, report, consumed);
  const char* begin = document.text.data();
  const char* end = begin + document.text.size();
  if (!json::sax_parse(CountingIterator(begin, &consumed), CountingIterator(end, &consumed),
                       &builder))
    return false;
  // The library takes a zero byte for the end of the text.
  if (consumed < document.text.size() || document.text.ends_with('\0')) {
    report.error({documentIndex, static_cast<std::uint32_t>(consumed - 1)},
                 "a zero byte in the text", "remove it");
    return false;
  }
  return true;
}

}  // namespace hearth
