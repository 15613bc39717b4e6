#include "cli/recording_file.h"

#include <fmt/format.h>

#include "files/replace_file.h"
#include "inputs/read_within_limit.h"

namespace hearth {

tl::expected<Recording, std::string> readReplay(const OptionValues& values) {
  const std::string path = *values.text(Option::Replay);
  const auto text = readWithinLimit(path, values);
  if (!text) return tl::unexpected(text.error());
  return readRecording(*text).map_error([&](const RecordingError& error) {
    return fmt::format("{}:{}:1: {}", path, error.line, error.message);
  });
}

tl::expected<void, std::string> writeRecordingFile(const std::string& path,
                                                   const Recording& recording) {
  const std::string text = writeRecording(recording);
  return replaceFile(path, [&](std::ostream& stream) {
    stream.write(text.data(), std::ssize(text));
    return stream.good();
  });
}

}  // namespace hearth
