#include "load/model/model_text.h"

#include <algorithm>

namespace hearth {

namespace {

/// The end of a line is one, too: it stands within a statement where "\" joins two lines.
constexpr bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

std::size_t blanksBefore(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, isBlank) - text.begin());
}

bool isCommentLine(std::string_view text) {
  const auto begin = std::ranges::find_if(text, [](char c) { return c == '\n' || !isBlank(c); });
  return begin != text.end() && *begin == '#';
}

/// Of a text up to the end of a line, and with it.
bool isJoinedToNext(std::string_view text) {
  if (!text.ends_with('\n')) return false;
  text.remove_suffix(1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text.ends_with('\\');
}

/// Whether a line ends there.
bool endsLine(std::string_view text) { return text.starts_with('\n') || text.starts_with("\r\n"); }

}  // namespace

ModelLines::ModelLines(std::string_view text) : left_(text) {
  constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
  if (left_.starts_with(kUtf8Mark)) left_.remove_prefix(kUtf8Mark.size());
}

/// Takes a line off the text, with those that are joined to it.
std::string_view ModelLines::take() {
  const bool isComment = isCommentLine(left_);
  std::size_t size = 0;
  do {
    const std::size_t end = left_.find('\n', size);
    size = end == std::string_view::npos ? left_.size() : end + 1;
    ++taken_;
  } while (!isComment && size < left_.size() && isJoinedToNext(left_.substr(0, size)));
  std::string_view line = left_.substr(0, size);
  left_.remove_prefix(size);
  if (!isComment && isJoinedToNext(line)) line = line.substr(0, line.rfind('\\'));  // to nothing
  return line;
}

std::optional<ModelLine> ModelLines::next() {
  while (!left_.empty()) {
    const std::uint32_t number = taken_ + 1;
    std::string_view rest = take();
    if (const auto keyword = takeWord(rest))
      return ModelLine{*keyword, withoutBlanks(rest), number};
  }
  return std::nullopt;
}

std::optional<std::string_view> takeWord(std::string_view& text) {
  while (true) {
    text.remove_prefix(blanksBefore(text));
    if (text.empty() || text.starts_with('#')) return std::nullopt;
    const auto size = static_cast<std::size_t>(std::ranges::find_if(text, isBlank) - text.begin());
    std::string_view word = text.substr(0, size);
    text.remove_prefix(size);
    if (word.ends_with('\\') && endsLine(text)) word.remove_suffix(1);
    if (!word.empty()) return word;
  }
}

std::string_view withoutBlanks(std::string_view text) {
  text.remove_prefix(blanksBefore(text));
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

std::string shortened(std::string_view word) {
  constexpr std::size_t kMaxShown = 64;  // bytes
  if (word.size() <= kMaxShown) return std::string(word);
  std::size_t size = kMaxShown;
  while (size > 0 && (word[size] & 0xC0) == 0x80) --size;  // not within a letter of UTF-8
  return std::string(word.substr(0, size)) + "...";
}

}  // namespace hearth
