#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hearth {

/// The texts over the pictures of a walk. Times are in seconds of a clock that may be set.
class Notices {
 public:
  /// `first`: the notes at the beginning, a line each.
  explicit Notices(std::vector<std::string> first) : first_(std::move(first)) {}

  /// Shows one message for some seconds, in place of the one before.
  void say(std::string message, double now);

  /// Replaces the notes, which stand until the next call.
  void setNotes(std::vector<std::string> notes) { notes_ = std::move(notes); }

  /// Drops messages that have shown long enough.
  void update(double now);

  const std::string& message() const { return message_; }
  /// The notes, a line each.
  std::vector<std::string> notes() const;

 private:
  std::string message_;
  double messageBegin_ = 0;
  std::optional<double> begin_;  ///< of the walk
  std::vector<std::string> first_;
  std::vector<std::string> notes_;
};

}  // namespace hearth
