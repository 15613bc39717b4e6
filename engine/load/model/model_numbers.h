#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "load/json/fields.h"
#include "load/model/model_report.h"
#include "load/model/model_text.h"

namespace hearth {

/// The double that is nearest to a decimal number: infinite past the largest one, and 0 past the
/// smallest. None of what is no number.
std::optional<double> nearestDouble(std::string_view word);

/// What numbers a line needs.
struct WantedNumbers {
  NumberRange range;
  std::string_view names;  ///< for messages
};

/// Takes as many numbers as there is room for off the rest of a line. Reports the first one that
/// is missing, unreadable or out of range, and is false then.
bool takeNumbers(const ModelLine& line, std::string_view& rest, const WantedNumbers& wanted,
                 std::span<double> numbers, ModelReport& report);

/// Tells once for each file that words which follow these numbers are left out, if any do.
void leaveOutRest(const ModelLine& line, std::string_view rest, ModelReport& report);

}  // namespace hearth
