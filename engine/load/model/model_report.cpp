#include "load/model/model_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "load/model/model_text.h"

namespace hearth {

namespace {

constexpr std::size_t kMaxKeywords = 16;  ///< that are told

}  // namespace

void ModelReport::add(std::uint32_t line, bool isError, std::string message, std::string advice) {
  constexpr std::uint32_t kMaxLine = std::numeric_limits<int>::max();
  mistakes_.push_back({file_, static_cast<int>(std::min(line, kMaxLine)), isError,
                       std::move(message), std::move(advice)});
}

void ModelReport::error(std::uint32_t line, std::string message, std::string advice) {
  if (isFull()) return;
  if (++errors_ <= kMaxErrors) return add(line, true, std::move(message), std::move(advice));
  add(line, true, "more errors; the file is not read to its end", "correct the ones above first");
}

void ModelReport::warning(std::uint32_t line, std::string message, std::string advice) {
  add(line, false, std::move(message), std::move(advice));
}

void ModelReport::leaveOut(std::string_view keyword, std::uint32_t line) {
  std::string shown = shortened(keyword);
  if (std::ranges::find(leftOut_, shown, &LeftOut::keyword) != leftOut_.end()) return;
  hasMoreLeftOut_ = leftOut_.size() == kMaxKeywords;
  if (!hasMoreLeftOut_) leftOut_.push_back({std::move(shown), line});
}

std::vector<ModelMistake> ModelReport::mistakes(std::string_view read) const {
  ModelReport all = *this;
  if (!leftOut_.empty()) {
    std::ranges::stable_sort(all.leftOut_, {}, &LeftOut::line);
    std::string keywords;
    for (const LeftOut& each : all.leftOut_)
      keywords +=
          fmt::format("{}{} (line {})", keywords.empty() ? "" : ", ", each.keyword, each.line);
    all.warning(all.leftOut_.front().line,
                fmt::format("left out: {}{}", keywords, hasMoreLeftOut_ ? " and more" : ""),
                fmt::format("only {} are read", read));
  }
  std::ranges::stable_sort(all.mistakes_, {}, &ModelMistake::line);
  return std::move(all.mistakes_);
}

}  // namespace hearth
