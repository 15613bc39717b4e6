#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "measure/tradeoff/report.h"

namespace hearth {

/// Writes the report as one HTML page that needs no other file: two plots of cost against error,
/// with the fronts marked, and the table.
tl::expected<void, std::string> writeTradeoffPage(const std::filesystem::path& path,
                                                  const TradeoffReport& report);

}  // namespace hearth
