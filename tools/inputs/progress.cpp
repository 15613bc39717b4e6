#include "inputs/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <new>
#include <utility>

namespace hearth {

namespace {

constexpr double kPatienceSeconds = 1;             // so long nobody misses a word
constexpr double kSecondsBetweenLines = 1;         // in a file
constexpr std::chrono::milliseconds kRedraw{100};  // on a terminal

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void writeToStderr(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

ProgressStyle progressStyle(const OptionValues& values, ProgressStyle styleWithoutTerminal) {
  if (values.has(Option::Quiet)) return ProgressStyle::None;
  return isatty(STDERR_FILENO) == 1 ? ProgressStyle::Line : styleWithoutTerminal;
}

std::string ProgressWriter::update(const StageProgress& progress) {
  const bool isShown = shownWidth_ > 0 || tenths_ > 0;
  if (!isShown && progress.seconds < kPatienceSeconds) return "";
  switch (style_) {
    case ProgressStyle::None:
      return "";
    case ProgressStyle::Line:
      return redraw(progressText(progress));
    case ProgressStyle::Lines:
      return nextTenth(progress);
  }
  return "";
}

std::string ProgressWriter::finish() {
  if (shownWidth_ == 0) return "";
  return redraw("") + "\r";
}

/// With blanks over what is left of a longer text.
std::string ProgressWriter::redraw(const std::string& text) {
  const std::size_t before = std::exchange(shownWidth_, text.size());
  return fmt::format("\r{:<{}}", text, before);
}

std::string ProgressWriter::nextTenth(const StageProgress& progress) {
  if (progress.total <= 0) return "";
  const int tenths = percentOf(progress) / 10;
  if (tenths <= tenths_ || progress.seconds < told_ + kSecondsBetweenLines) return "";
  tenths_ = tenths;
  told_ = progress.seconds;
  return progressText(progress) + "\n";
}

ProgressDisplay::ProgressDisplay(ProgressStyle style, Stage stage)
    : ProgressDisplay(style, stage, nullptr, steadySeconds, writeToStderr) {}

ProgressDisplay::ProgressDisplay(ProgressStyle style, const BakeProgress& bake)
    : ProgressDisplay(style, Stage::Surfaces, &bake, steadySeconds, writeToStderr) {}

ProgressDisplay::ProgressDisplay(ProgressStyle style, Stage stage, const BakeProgress* bake,
                                 Clock clock, Output output)
    : writer_(style),
      stage_(stage),
      bake_(bake),
      clock_(std::move(clock)),
      output_(std::move(output)),
      start_(clock_()) {
  if (style != ProgressStyle::None)
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void ProgressDisplay::run(const std::stop_token& stop) {
  const auto write = [this](const std::string& text) {
    if (!text.empty()) output_(text);
  };
  try {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      write(writer_.update(look()));
      wakeUp_.wait_for(lock, stop, kRedraw, [] { return false; });
    }
    write(writer_.finish());
  } catch (const std::bad_alloc&) {
    // The work itself may still find the memory that it needs.
  }
}

StageProgress ProgressDisplay::look() {
  const std::int64_t total = bake_ ? bake_->texels() : 0;
  const double now = clock_();
  if (total > 0 && stage_ == Stage::Surfaces) {
    stage_ = Stage::Baking;
    start_ = now;
  }
  return {stage_, bake_ ? bake_->texelsDone() : 0, total, now - start_};
}

}  // namespace hearth
