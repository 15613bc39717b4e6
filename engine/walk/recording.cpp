#include "walk/recording.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "level/locate.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr std::string_view kHeader = "hearth-walk 1";

// ---- writing ----

/// The rest of a line can hold any name: what would end the line, and the sign itself, as %XX.
std::string escaped(std::string_view name) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && c != '%') {
      text += c;
      continue;
    }
    text += '%';
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

std::string exact(double value) {
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::hex);
  return {digits.data(), end.ptr};
}

std::string join(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += ' ' + exact(value);
  return text;
}

std::string keysOf(const WalkInput& input) {
  std::string keys;
  if (input.run) keys += 'r';
  if (input.jump) keys += 'j';
  if (input.crouch) keys += 'c';
  if (input.toggleFlight) keys += 'f';
  if (input.use) keys += 'u';
  return keys.empty() ? "-" : keys;
}

std::string inputLine(const WalkInput& input, std::size_t count) {
  std::string line = std::to_string(count);
  for (const int value : {input.forward, input.right, input.up, input.turn, input.pitch})
    line += ' ' + std::to_string(value);
  return line + ' ' + keysOf(input) + '\n';
}

std::string flagsOf(const Walker& walker) {
  std::string flags;
  if (walker.isFlying) flags += 'f';
  if (walker.isOnGround) flags += 'g';
  return flags.empty() ? "-" : flags;
}

// ---- reading ----

/// Takes the words of one line from left to right; what is missing or wrong makes it bad.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  bool isGood() const { return isGood_; }
  void fail() { isGood_ = false; }

  std::string_view word() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (found.empty()) fail();
    return found;
  }

  template <typename Number, typename... Format>
  Number number(Format... format) {
    const std::string_view text = word();
    Number value{};
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, format...);
    if (error != std::errc() || end != text.data() + text.size()) fail();
    return value;
  }

  double real() {
    const double value = number<double>(std::chars_format::hex);
    if (!std::isfinite(value)) fail();
    return value;
  }
  Vec3 point() {
    const double x = real();
    const double y = real();
    return {x, y, real()};
  }

  /// For each of `letters` whether the word has it; "-" is a word without any.
  std::vector<bool> flags(std::string_view letters) {
    const std::string_view found = word();
    std::vector<bool> isSet(letters.size(), false);
    for (const char c : found == "-" ? std::string_view{} : found) {
      const std::size_t at = letters.find(c);
      if (at == letters.npos)
        fail();
      else
        isSet[at] = true;
    }
    return isSet;
  }

  /// All that is left, %XX being the byte of that number.
  std::string name() {
    std::string text;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (rest_[i] != '%') {
        text += rest_[i];
        continue;
      }
      unsigned byte = 0;
      const std::string_view digits = rest_.substr(i + 1, 2);
      const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16).ptr;
      if (digits.size() != 2 || end != digits.data() + 2) fail();
      text += static_cast<char>(byte);
      i += 2;
    }
    rest_ = {};
    return text;
  }

  bool atEnd() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  bool isGood_ = true;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  tl::expected<Recording, RecordingError> read() {
    if (nextLine() != kHeader) return error("the first line must be \"hearth-walk 1\"");
    Words start(nextLine());
    if (start.word() != "start" || !readStart(start))
      return error("expected \"start X Y Z ANGLE PITCH SECTOR\", numbers in hexadecimal");
    for (;;) {
      Words line(nextLine());
      if (Words probe = line; probe.word() == "end") {
        line.word();
        if (!readEnd(line)) return error("the end's state is incomplete or no state");
        if (!rest_.empty()) return error("nothing may follow the end");
        return recording_;
      }
      if (const auto problem = readInput(line)) return error(*problem);
    }
  }

 private:
  std::string_view nextLine() {
    ++line_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return line;
  }

  tl::unexpected<RecordingError> error(std::string message) const {
    return tl::unexpected(RecordingError{line_, std::move(message)});
  }

  bool readStart(Words& words) {
    RecordedStart& start = recording_.start;
    start.eye = words.point();
    start.angle = words.real();
    start.pitch = words.real();
    start.sector = words.name();
    return words.isGood();
  }

  std::optional<std::string> readInput(Words& words) {
    const auto count = words.number<std::size_t>();
    WalkInput input;
    for (int* value : {&input.forward, &input.right, &input.up, &input.turn, &input.pitch})
      *value = words.number<int>();
    const std::vector<bool> keys = words.flags("rjcfu");
    if (!words.isGood() || !words.atEnd() || count == 0)
      return "expected \"TICKS FORWARD RIGHT UP TURN PITCH KEYS\" or \"end ...\"";
    if (count > kMaxRecordedTicks - recording_.inputs.size())
      return "a recording of more than eight hours";
    input.run = keys[0];
    input.jump = keys[1];
    input.crouch = keys[2];
    input.toggleFlight = keys[3];
    input.use = keys[4];
    recording_.inputs.insert(recording_.inputs.end(), count, input);
    return std::nullopt;
  }

  bool readEnd(Words& words) {
    Walker& walker = recording_.end.walker;
    walker.feet = words.point();
    walker.velocity = words.point();
    walker.angle = words.real();
    walker.pitch = words.real();
    walker.crouch = words.real();
    const std::vector<bool> flags = words.flags("fg");
    walker.isFlying = flags[0];
    walker.isOnGround = flags[1];
    recording_.end.sector = words.name();
    return words.isGood();
  }

  std::string_view rest_;
  std::size_t line_ = 0;
  Recording recording_;
};

}  // namespace

bool operator==(const RecordedState& a, const RecordedState& b) {
  Walker here = a.walker;
  here.sector = b.walker.sector;
  return a.sector == b.sector && here == b.walker;
}

RecordedState recordedState(const Scene& scene, const Walker& walker) {
  return {scene[walker.sector].name, walker};
}

std::string writeRecording(const Recording& recording) {
  const RecordedStart& start = recording.start;
  std::string text(kHeader);
  text += "\nstart";
  text += join({start.eye.x, start.eye.y, start.eye.z, start.angle, start.pitch});
  text += ' ' + escaped(start.sector) + '\n';
  const std::vector<WalkInput>& inputs = recording.inputs;
  for (std::size_t i = 0; i < inputs.size();) {
    const std::size_t first = i;
    while (i < inputs.size() && inputs[i] == inputs[first]) ++i;
    text += inputLine(inputs[first], i - first);
  }
  const Walker& end = recording.end.walker;
  text += "end" + join({end.feet.x, end.feet.y, end.feet.z});
  text += join({end.velocity.x, end.velocity.y, end.velocity.z});
  text += join({end.angle, end.pitch, end.crouch}) + ' ' + flagsOf(end);
  return text + ' ' + escaped(recording.end.sector) + '\n';
}

tl::expected<Recording, RecordingError> readRecording(std::string_view text) {
  return Reader(text).read();
}

tl::expected<Walker, std::string> walkerAtStart(const Scene& scene, const RecordedStart& start) {
  for (std::size_t i = 0; i < scene.level().sectors.size(); ++i) {
    if (scene.level().sectors[i].name != start.sector) continue;
    if (contains(scene, scene.level().sectors[i], start.eye, kPositionSlack))
      return walkerAt(scene, SectorId(i), start.eye, start.angle, start.pitch);
    return tl::unexpected("the recording starts outside of its sector \"" + start.sector +
                          "\": it is of another level");
  }
  return tl::unexpected("the recording starts in a sector \"" + start.sector +
                        "\" that the level does not have");
}

}  // namespace hearth
