#pragma once

#include <cstdint>
#include <string>

/// How far a command is, in words.
namespace hearth {

enum class Stage { Loading, Surfaces, Baking, Writing };

/// How far a stage is.
struct StageProgress {
  Stage stage;
  std::int64_t done = 0;   ///< texels
  std::int64_t total = 0;  ///< 0 in stages that count nothing
  double seconds = 0;      ///< since the stage began
};

/// Whole percents; 100 only when all is done.
int percentOf(const StageProgress& progress);

/// `baking    42 %  1.24 M texels/s  31 s left`, without what cannot be known yet. Never longer
/// than a narrow terminal.
std::string progressText(const StageProgress& progress);

}  // namespace hearth
