#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "measure/tradeoff/area_trials.h"
#include "measure/tradeoff/report.h"

namespace hearth {

/// Writes the report as one HTML page that needs no other file: two plots of cost against error,
/// with the fronts marked, and the table.
tl::expected<void, std::string> writeTradeoffPage(const std::filesystem::path& path,
                                                  const TradeoffReport& report);

/// The same of light of areas: one plot, of seconds to bake against the error of that light.
tl::expected<void, std::string> writeTradeoffPage(const std::filesystem::path& path,
                                                  const AreaReport& report);

}  // namespace hearth
