#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "load/json/document.h"
#include "load/json/report.h"
#include "math/vec.h"

namespace hearth {

/// Metres. Coordinates, heights and lengths beyond this are refused: products of four of them stay
/// far from overflow, and a double still tells points 1e-7 m apart there.
inline constexpr double kWorldLimit = 1e9;

/// Bounds of a number, both included.
struct NumberRange {
  double min;
  double max;
};
inline constexpr NumberRange kCoordinate{-kWorldLimit, kWorldLimit};
inline constexpr NumberRange kLength{0, kWorldLimit};

/// Readers of single values. Each reports a wrong type or a value out of range, and then returns
/// none.
std::optional<double> readNumber(Report& report, JsonValue value, NumberRange range);
std::optional<int> readInteger(Report& report, JsonValue value, NumberRange range);
std::optional<bool> readBoolean(Report& report, JsonValue value);
/// Not empty.
std::optional<std::string> readName(Report& report, JsonValue value);
/// Exactly `count` numbers.
std::optional<std::vector<double>> readNumbers(Report& report, JsonValue value, std::size_t count,
                                               NumberRange range);
/// The children of an object keyed by name, or of an array of objects with a `name`, as pairs of
/// name and child. Reports children without a name, and equal names. `what` they are: "sectors".
std::vector<JsonValue::Member> namedChildren(Report& report, JsonValue value,
                                             std::string_view what);
void reportWrongType(Report& report, JsonValue value, std::string_view wanted);

/// Unknown keys of an object that belong elsewhere.
struct MisplacedKeys {
  std::span<const std::string_view> keys;
  std::string_view advice;  ///< as a format, of the key
};

/// The members of an object, by key.
class Fields {
 public:
  /// Reports keys that are not in `known`, and a value that is no object (then it has no members).
  Fields(Report& report, JsonValue value, std::span<const std::string_view> known,
         const MisplacedKeys& misplaced = {});

  bool isObject() const { return value_.isObject(); }
  JsonValue value() const { return value_; }
  std::optional<JsonValue> find(std::string_view key) const;
  /// Whether an unknown key, which has been reported, is a slip of `key`.
  bool isMisspelled(std::string_view key) const;
  /// Reports a missing key, unless it is misspelled.
  std::optional<JsonValue> require(std::string_view key, std::string_view advice) const;

  /// Read a member into `target`, which stays as it is without one. False after a mistake.
  bool read(std::string_view key, NumberRange range, double& target) const;
  bool read(std::string_view key, NumberRange range, std::optional<double>& target) const;
  bool read(std::string_view key, bool& target) const;
  /// Both numbers in the range.
  bool read(std::string_view key, NumberRange range, Vec2& target) const;

 private:
  Report& report_;
  JsonValue value_;
  std::vector<JsonValue::Member> members_;
  std::vector<std::string_view> slips_;  ///< known keys that unknown ones are slips of
};

/// Reports a `version` that this program does not know.
void checkVersion(Report& report, const Fields& fields);

/// A colour from `#rrggbb`.
std::optional<Rgb> parseColor(std::string_view text);

}  // namespace hearth
