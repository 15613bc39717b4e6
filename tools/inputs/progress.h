#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "light/bake_progress.h"
#include "settings/options.h"
#include "text/progress_text.h"

/// Shows how far a command is.
namespace hearth {

enum class ProgressStyle {
  None,
  Line,   ///< for a terminal: one line, redrawn, and erased at the end
  Lines,  ///< for a file: a line for every tenth of a counted stage, at most one a second
};

/// The style for the command line and stderr; `styleWithoutTerminal` if stderr is no terminal.
ProgressStyle progressStyle(const OptionValues& values,
                            ProgressStyle styleWithoutTerminal = ProgressStyle::None);

/// Turns progress into text to write. Stages shorter than a second are not shown.
class ProgressWriter {
 public:
  explicit ProgressWriter(ProgressStyle style) : style_(style) {}

  /// Empty if nothing has changed. `progress` never goes back.
  std::string update(const StageProgress& progress);
  /// Leaves the terminal's line as if nothing had been there.
  std::string finish();

 private:
  std::string redraw(const std::string& text);
  std::string nextTenth(const StageProgress& progress);

  ProgressStyle style_;
  std::size_t shownWidth_ = 0;  ///< of the text on the terminal's line
  int tenths_ = 0;              ///< that have been written
  double told_ = 0;             ///< at this time, in seconds
};

/// Shows a stage while it lasts, from a thread of its own.
class ProgressDisplay {
 public:
  using Clock = std::function<double()>;                 ///< seconds since any moment
  using Output = std::function<void(std::string_view)>;  ///< called from the display's thread

  ProgressDisplay(ProgressStyle style, Stage stage);
  /// Of a bake: its surfaces, and then its light. Keeps a reference to `bake`.
  ProgressDisplay(ProgressStyle style, const BakeProgress& bake);
  ProgressDisplay(ProgressStyle style, Stage stage, const BakeProgress* bake, Clock clock,
                  Output output);

 private:
  void run(const std::stop_token& stop);
  StageProgress look();

  ProgressWriter writer_;
  Stage stage_;
  const BakeProgress* bake_;
  Clock clock_;
  Output output_;
  double start_;  ///< of the stage, by the clock
  std::mutex mutex_;
  std::condition_variable_any wakeUp_;
  std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace hearth
