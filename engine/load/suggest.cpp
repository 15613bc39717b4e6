#include "load/suggest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace hearth {

namespace {

constexpr std::size_t kMaxEdits = 2;
constexpr std::size_t kMaxListed = 16;
/// Comparing costs time for each known name: a level with more has its names from a program.
constexpr std::size_t kMaxCompared = 10'000;
constexpr std::size_t kMaxNameBytes = 64;

/// Whether two edits can be a slip: they are a whole word when the name has only two letters.
bool isSlip(std::size_t edits, std::string_view name) {
  return edits <= kMaxEdits && edits < std::max<std::size_t>(name.size(), 1);
}

/// What was cut short: the name that begins so, if there is but one.
std::optional<std::string_view> onlyOneBeginningWith(std::string_view name,
                                                     std::span<const std::string_view> known) {
  constexpr std::size_t kFewestLetters = 3;
  if (name.size() < kFewestLetters) return std::nullopt;
  const auto begins = [name](std::string_view candidate) { return candidate.starts_with(name); };
  const auto first = std::ranges::find_if(known, begins);
  if (first == known.end() || std::any_of(first + 1, known.end(), begins)) return std::nullopt;
  return *first;
}

}  // namespace

std::optional<std::string_view> nearestName(std::string_view name,
                                            std::span<const std::string_view> known) {
  if (name.size() > kMaxNameBytes || known.size() > kMaxCompared) return std::nullopt;
  if (const auto whole = onlyOneBeginningWith(name, known)) return whole;
  std::optional<std::string_view> best;
  std::size_t bestEdits = kMaxEdits + 1;
  for (const std::string_view candidate : known) {
    if (candidate.size() > name.size() + kMaxEdits || name.size() > candidate.size() + kMaxEdits)
      continue;
    const std::size_t edits = editDistance(name, candidate);
    if (edits < bestEdits && isSlip(edits, name)) best = candidate, bestEdits = edits;
  }
  return best;
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  // Rows of the table of distances between the first i letters of a and the first j of b.
  std::vector<std::size_t> beforeLast(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(beforeLast, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string suggest(std::string_view name, std::span<const std::string_view> known,
                    std::string_view fallback) {
  if (const std::optional<std::string_view> best = nearestName(name, known))
    return fmt::format("did you mean \"{}\"?", *best);
  if (!known.empty() && known.size() <= kMaxListed)
    return fmt::format("use one of: {}", fmt::join(known, ", "));
  return std::string(fallback);
}

}  // namespace hearth
