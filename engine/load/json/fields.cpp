#include "load/json/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "load/suggest.h"

namespace hearth {

namespace {

std::string_view describe(JsonValue value) {
  switch (value.kind()) {
    case JsonKind::Null:
      return "null";
    case JsonKind::False:
      return "false";
    case JsonKind::True:
      return "true";
    case JsonKind::Number:
      return "a number";
    case JsonKind::String:
    case JsonKind::Key:
      return "a string";
    case JsonKind::Array:
      return "an array";
    case JsonKind::Object:
      return "an object";
  }
  return "";
}

}  // namespace

void reportWrongType(Report& report, JsonValue value, std::string_view wanted) {
  report.error(value.place(), fmt::format("{} instead of {}", describe(value), wanted),
               fmt::format("give {}", wanted));
}

std::optional<double> readNumber(Report& report, JsonValue value, NumberRange range) {
  if (!value.isNumber()) {
    reportWrongType(report, value, "a number");
    return std::nullopt;
  }
  const double number = value.number();
  if (number >= range.min && number <= range.max) return number;
  report.error(value.place(), fmt::format("{} is out of range", number),
               fmt::format("give a number from {} to {}", range.min, range.max));
  return std::nullopt;
}

std::optional<int> readInteger(Report& report, JsonValue value, NumberRange range) {
  const std::optional<double> number = readNumber(report, value, range);
  if (!number) return std::nullopt;
  if (*number == std::floor(*number)) return static_cast<int>(*number);
  report.error(value.place(), fmt::format("{} is not a whole number", *number),
               "give a whole number");
  return std::nullopt;
}

std::optional<bool> readBoolean(Report& report, JsonValue value) {
  if (value.isBoolean()) return value.kind() == JsonKind::True;
  reportWrongType(report, value, "true or false");
  return std::nullopt;
}

std::optional<std::string> readName(Report& report, JsonValue value) {
  if (!value.isString()) {
    reportWrongType(report, value, "a string");
    return std::nullopt;
  }
  if (!value.text().empty()) return std::string(value.text());
  report.error(value.place(), "an empty name", "give a name");
  return std::nullopt;
}

std::optional<std::vector<double>> readNumbers(Report& report, JsonValue value, std::size_t count,
                                               NumberRange range) {
  if (!value.isArray() || value.size() != count) {
    report.error(value.place(),
                 value.isArray() ? fmt::format("{} values instead of {}", value.size(), count)
                                 : fmt::format("{} instead of an array", describe(value)),
                 fmt::format("give an array of {} numbers", count));
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const JsonValue element : value.elements())
    if (const std::optional<double> number = readNumber(report, element, range))
      numbers.push_back(*number);
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

namespace {

/// The `name` of an element; the reader of the element reads the other keys.
std::optional<JsonValue> nameOf(Report& report, JsonValue element) {
  if (!element.isObject()) {
    reportWrongType(report, element, "an object");
    return std::nullopt;
  }
  for (const JsonValue::Member& member : element.members())
    if (member.key.text() == "name")
      return readName(report, member.value) ? std::optional(member.value) : std::nullopt;
  report.error(element.place(), "\"name\" is missing", "give every element of an array a name");
  return std::nullopt;
}

void reportEqualNames(Report& report, const std::vector<JsonValue::Member>& children,
                      std::string_view what) {
  std::vector<JsonValue> names;
  for (const JsonValue::Member& child : children) names.push_back(child.key);
  std::stable_sort(names.begin(), names.end(),
                   [](JsonValue a, JsonValue b) { return a.text() < b.text(); });
  for (std::size_t i = 1; i < names.size(); ++i)
    if (names[i - 1].text() == names[i].text())
      report.error(names[i].place(), fmt::format("two {} are named \"{}\"", what, names[i].text()),
                   "rename one of them");
}

}  // namespace

std::vector<JsonValue::Member> namedChildren(Report& report, JsonValue value,
                                             std::string_view what) {
  if (value.isObject()) return value.members();  // the parser has reported duplicate keys
  std::vector<JsonValue::Member> children;
  if (!value.isArray()) {
    reportWrongType(report, value, fmt::format("an object or an array of {}", what));
    return children;
  }
  for (const JsonValue element : value.elements())
    if (const std::optional<JsonValue> name = nameOf(report, element))
      children.push_back({*name, element});
  reportEqualNames(report, children, what);
  return children;
}

Fields::Fields(Report& report, JsonValue value, std::span<const std::string_view> known,
               const MisplacedKeys& misplaced)
    : report_(report), value_(value) {
  if (!value.isObject()) {
    reportWrongType(report, value, "an object");
    return;
  }
  members_ = value.members();
  for (const JsonValue::Member& member : members_) {
    const std::string_view key = member.key.text();
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const bool isMisplaced = std::ranges::find(misplaced.keys, key) != misplaced.keys.end();
    report.error(member.key.place(), fmt::format("unknown key \"{}\"", key),
                 isMisplaced ? fmt::format(fmt::runtime(misplaced.advice), key)
                             : suggest(key, known, "remove it"));
    if (isMisplaced) continue;
    if (const auto slip = nearestName(key, known)) slips_.push_back(*slip);
  }
}

bool Fields::isMisspelled(std::string_view key) const {
  return !find(key) && std::find(slips_.begin(), slips_.end(), key) != slips_.end();
}

std::optional<JsonValue> Fields::find(std::string_view key) const {
  for (const JsonValue::Member& member : members_)
    if (member.key.text() == key) return member.value;
  return std::nullopt;
}

std::optional<JsonValue> Fields::require(std::string_view key, std::string_view advice) const {
  const std::optional<JsonValue> found = find(key);
  if (!found && isObject() && !isMisspelled(key))
    report_.error(value_.place(), fmt::format("\"{}\" is missing", key), std::string(advice));
  return found;
}

bool Fields::read(std::string_view key, NumberRange range, double& target) const {
  const std::optional<JsonValue> value = find(key);
  if (!value) return true;
  const std::optional<double> number = readNumber(report_, *value, range);
  target = number.value_or(target);
  return number.has_value();
}

bool Fields::read(std::string_view key, NumberRange range, std::optional<double>& target) const {
  double number = 0;
  if (!find(key)) return true;
  const bool isGood = read(key, range, number);
  if (isGood) target = number;
  return isGood;
}

bool Fields::read(std::string_view key, NumberRange range, Vec2& target) const {
  const std::optional<JsonValue> value = find(key);
  if (!value) return true;
  const auto pair = readNumbers(report_, *value, 2, range);
  if (pair) target = {(*pair)[0], (*pair)[1]};
  return pair.has_value();
}

bool Fields::read(std::string_view key, bool& target) const {
  const std::optional<JsonValue> value = find(key);
  if (!value) return true;
  const std::optional<bool> flag = readBoolean(report_, *value);
  target = flag.value_or(target);
  return flag.has_value();
}

void checkVersion(Report& report, const Fields& fields) {
  constexpr int kVersion = 1;
  const std::optional<JsonValue> value = fields.find("version");
  const auto version = value ? readInteger(report, *value, {1, 1e9}) : std::nullopt;
  if (version && *version > kVersion)
    report.error(value->place(), fmt::format("version {} is newer than this program", *version),
                 fmt::format("use a newer program, or write version {}", kVersion));
}

std::optional<Rgb> parseColor(std::string_view text) {
  if (text.size() != 7 || text[0] != '#' || text[1] == '-') return std::nullopt;
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, value, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  return Rgb{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8 & 255),
             static_cast<std::uint8_t>(value & 255)};
}

}  // namespace hearth
