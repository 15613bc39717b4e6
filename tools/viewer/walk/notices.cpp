#include "viewer/walk/notices.h"

#include <utility>

namespace hearth {

namespace {

constexpr double kMessageSeconds = 3;
constexpr double kFirstNotesSeconds = 15;

}  // namespace

void Notices::say(std::string message, double now) {
  message_ = std::move(message);
  messageBegin_ = now;
}

void Notices::update(double now) {
  if (now < messageBegin_ || now >= messageBegin_ + kMessageSeconds) message_.clear();
  if (!begin_) begin_ = now;
  if (now >= *begin_ + kFirstNotesSeconds) first_.clear();
}

std::vector<std::string> Notices::notes() const {
  std::vector<std::string> all = first_;
  all.insert(all.end(), notes_.begin(), notes_.end());
  return all;
}

}  // namespace hearth
