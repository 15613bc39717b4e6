#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "walk/walker.h"

namespace hearth {

/// A walker with the name of its sector: the number may be another sector's in another version of
/// the level.
struct RecordedState {
  std::string sector;
  Walker walker;  ///< `sector` above counts, not its own

  friend bool operator==(const RecordedState& a, const RecordedState& b);
};

RecordedState recordedState(const Scene& scene, const Walker& walker);

/// Where a recording begins: the arguments of `walkerAt`.
struct RecordedStart {
  std::string sector;
  Vec3 eye;
  double angle = 0;
  double pitch = 0;

  friend bool operator==(const RecordedStart&, const RecordedStart&) = default;
};

/// A walk: the input of every tick, and the exact state at its end.
struct Recording {
  RecordedStart start;
  std::vector<WalkInput> inputs;
  RecordedState end;

  friend bool operator==(const Recording&, const Recording&) = default;
};

/// Recordings hold eight hours at most: longer ones are refused before memory is taken.
inline constexpr std::size_t kMaxRecordedTicks = std::size_t{8} * 3600 * kTicksPerSecond;

/// As text, all numbers exact. engine/README.md says what a line means.
std::string writeRecording(const Recording& recording);

struct RecordingError {
  std::size_t line = 0;  ///< from 1
  std::string message;
};

tl::expected<Recording, RecordingError> readRecording(std::string_view text);

/// The walker at the start of a recording; the error names what the level lacks.
tl::expected<Walker, std::string> walkerAtStart(const Scene& scene, const RecordedStart& start);

}  // namespace hearth
