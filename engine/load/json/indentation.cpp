#include "load/json/indentation.h"

#include <limits>
#include <vector>

namespace hearth {

namespace {

/// Reads brackets and where lines begin, and cares for nothing else that JSON asks for.
class IndentationReader {
 public:
  explicit IndentationReader(std::string_view text) : text_(text) {}

  std::optional<IndentationSlip> read() {
    std::size_t indent = 0;
    std::size_t lineStart = 0;
    bool isLineStart = true;
    char last = '\0';
    for (std::size_t at = 0; at < text_.size(); ++at) {
      const char c = text_[at];
      if (c == '\n') isLineStart = true, indent = 0, lineStart = at + 1;
      if (c == ' ' || c == '\t') indent += isLineStart ? 1 : 0;
      if (isBlank(c)) continue;
      if (isLineStart && last != ':')  // else a value that stands below its key
        if (const auto slip = lookAtLine(at, indent)) return slip;
      isLineStart = false;
      last = c;
      if (c == '"') at = endOfString(at);
      if (c == '{' || c == '[') open(at, indent, lineStart);
      if (c == '}' || c == ']') close(at);
    }
    return std::nullopt;
  }

 private:
  struct Bracket {
    std::size_t at;
    std::size_t indent;                       ///< of its line
    std::size_t furthest;                     ///< indent of a line that closes it
    std::optional<std::size_t> childsIndent;  ///< of the first line inside
  };

  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  /// Of the closing quote, or of the line, where that is missing.
  std::size_t endOfString(std::size_t at) const {
    for (++at; at + 1 < text_.size() && text_[at] != '"' && text_[at + 1] != '\n'; ++at)
      if (text_[at] == '\\') ++at;
    return at;
  }

  void open(std::size_t at, std::size_t indent, std::size_t lineStart) {
    const bool isAlone = open_.empty() || open_.back().at < lineStart;
    open_.push_back({at, indent, isAlone ? indent : at - lineStart, std::nullopt});
  }

  void close(std::size_t at) {
    if (!open_.empty()) open_.pop_back();
    lastClosed_ = at;
  }

  std::optional<IndentationSlip> lookAtLine(std::size_t at, std::size_t indent) {
    if (open_.empty()) return std::nullopt;
    Bracket& inner = open_.back();
    const auto [least, most] = indentsIn(inner, text_[at] == '}' || text_[at] == ']', indent);
    if (indent < least && inner.indent > 0)  // what is indented nowhere says nothing
      return IndentationSlip{at, inner.at, true};
    if (indent > most && lastClosed_) return IndentationSlip{at, *lastClosed_, false};
    return std::nullopt;
  }

  struct Range {
    std::size_t least;
    std::size_t most;
  };

  /// A bracket closes below the line in which it opens or, with others in there, below itself. What
  /// it holds stands further in, all lines alike.
  static Range indentsIn(Bracket& bracket, bool isClosing, std::size_t indent) {
    if (isClosing) return {bracket.indent, bracket.furthest};
    if (!bracket.childsIndent) {
      bracket.childsIndent = indent;
      return {bracket.indent + 1, std::numeric_limits<std::size_t>::max()};
    }
    return {*bracket.childsIndent, *bracket.childsIndent};
  }

  std::string_view text_;
  std::vector<Bracket> open_;
  std::optional<std::size_t> lastClosed_;
};

}  // namespace

std::optional<IndentationSlip> findIndentationSlip(std::string_view text) {
  return IndentationReader(text).read();
}

}  // namespace hearth
