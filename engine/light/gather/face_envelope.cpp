#include "light/gather/face_envelope.h"

#include <iterator>

namespace hearth {

void FaceEnvelope::add(const FaceCut& cut) {
  if (cut.slopes.isEmpty()) return;
  const auto index = static_cast<std::uint32_t>(cuts_.size());
  const auto first = std::ranges::upper_bound(parts_, cut.slopes.from, {},
                                              [](const Part& part) { return part.slopes.to; });
  const auto last = std::ranges::lower_bound(first, parts_.end(), cut.slopes.to, {},
                                             [](const Part& part) { return part.slopes.from; });
  changed_.clear();
  const auto put = [&](double from, double to, std::uint32_t of) {
    if (!(from < to)) return;
    if (!changed_.empty() && changed_.back().cut == of && changed_.back().slopes.to == from)
      changed_.back().slopes.to = to;
    else
      changed_.push_back({{from, to}, of});
  };
  bool isSeen = false;
  double from = cut.slopes.from;
  for (auto part = first; part != last; ++part) {
    const SlopeRange nearer = whereNearer(cut, *part);
    isSeen |= from < part->slopes.from || !nearer.isEmpty();
    put(from, part->slopes.from, index);
    if (nearer.isEmpty()) {
      put(part->slopes.from, part->slopes.to, part->cut);
    } else {
      put(part->slopes.from, nearer.from, part->cut);
      put(nearer.from, nearer.to, index);
      put(nearer.to, part->slopes.to, part->cut);
    }
    from = std::max(from, part->slopes.to);
  }
  isSeen |= from < cut.slopes.to;
  if (!isSeen) return;
  put(from, cut.slopes.to, index);
  cuts_.push_back(cut);
  const auto kept = std::min(std::distance(first, last), std::ssize(changed_));
  std::copy_n(changed_.begin(), kept, first);
  if (kept < std::ssize(changed_))
    parts_.insert(first + kept, changed_.begin() + kept, changed_.end());
  else
    parts_.erase(first + kept, last);
}

/// Of the slopes of a part.
SlopeRange FaceEnvelope::whereNearer(const FaceCut& cut, const Part& part) const {
  const SlopeRange both = common(cut.slopes, part.slopes);
  if (both.isEmpty()) return both;
  const FaceCut& other = cuts_[part.cut];
  const double atFrom = cut.nearAt(both.from) - other.nearAt(both.from);
  const double atTo = cut.nearAt(both.to) - other.nearAt(both.to);
  if (atFrom <= 0 && atTo <= 0) return {both.from, both.from};
  if (atFrom >= 0 && atTo >= 0) return both;
  const double crossing = std::lerp(both.from, both.to, atFrom / (atFrom - atTo));
  return atFrom > 0 ? SlopeRange{both.from, crossing} : SlopeRange{crossing, both.to};
}

bool FaceEnvelope::hide(SlopeRange slopes, double nearest) const {
  auto part = std::ranges::upper_bound(parts_, slopes.from, {},
                                       [](const Part& before) { return before.slopes.to; });
  for (; slopes.from < slopes.to; ++part) {
    if (part == parts_.end() || part->slopes.from > slopes.from) return false;
    const FaceCut& cut = cuts_[part->cut];
    const double to = std::min(slopes.to, part->slopes.to);
    if (cut.nearAt(slopes.from) < nearest || cut.nearAt(to) < nearest) return false;
    slopes.from = to;
  }
  return true;
}

}  // namespace hearth
