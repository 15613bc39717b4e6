#include "load/json/report.h"

#include <fmt/format.h>

#include <algorithm>

namespace hearth {

namespace {

/// Walks through a text and counts lines; places must come in rising order.
class LineCounter {
 public:
  explicit LineCounter(const std::string& text) : text_(text) {}

  void moveTo(std::size_t offset) {
    for (; at_ < std::min(offset, text_.size()); ++at_) {
      if (text_[at_] != '\n') continue;
      ++line_;
      lineStart_ = at_ + 1;
    }
  }
  int line() const { return line_; }
  int column() const { return static_cast<int>(at_ - lineStart_) + 1; }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
  std::size_t lineStart_ = 0;
  int line_ = 1;
};

}  // namespace

FileLocation locationOf(Place place, std::span<const Document> documents) {
  const Document& document = documents[place.document];
  LineCounter lines(document.text);
  lines.moveTo(place.offset);
  return {document.file, lines.line(), lines.column(), pointerAt(document, place.offset)};
}

void Report::error(Place place, std::string message, std::string advice) {
  if (errors_++ < kMaxMessages)
    entries_.push_back({place, true, std::move(message), std::move(advice), {}});
}

void Report::warning(Place place, std::string message, std::string advice, std::string_view kind) {
  if (warnings_++ < kMaxMessages)
    entries_.push_back({place, false, std::move(message), std::move(advice), std::string(kind)});
}

void Report::addErrors(const Report& other, std::string_view where) {
  for (const Entry& entry : other.entries_)
    if (entry.isError) error(entry.place, fmt::format("{}{}", where, entry.message), entry.advice);
}

std::vector<Diagnostic> Report::resolve(std::span<const Document> documents) const {
  std::vector<const Entry*> ordered;
  for (const Entry& entry : entries_) ordered.push_back(&entry);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Entry* a, const Entry* b) { return a->place < b->place; });

  std::vector<LineCounter> lines;
  for (const Document& document : documents) lines.emplace_back(document.text);
  std::vector<Diagnostic> diagnostics;
  for (const Entry* entry : ordered) {
    const Document& document = documents[entry->place.document];
    LineCounter& counter = lines[entry->place.document];
    counter.moveTo(entry->place.offset);
    diagnostics.push_back({document.file, counter.line(), counter.column(), entry->isError,
                           pointerAt(document, entry->place.offset), entry->message, entry->advice,
                           entry->kind});
  }
  const std::string& first = documents.front().file;
  if (errors_ > kMaxMessages)
    diagnostics.push_back({first, 1, 1, true, "",
                           fmt::format("{} more errors are left out", errors_ - kMaxMessages),
                           "correct the ones above first"});
  if (warnings_ > kMaxMessages)
    diagnostics.push_back({first, 1, 1, false, "",
                           fmt::format("{} more warnings are left out", warnings_ - kMaxMessages),
                           "see to the ones above first"});
  return diagnostics;
}

}  // namespace hearth
