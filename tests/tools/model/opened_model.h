#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "model/open_level.h"
#include "support/memory_files.h"

namespace hearth::test {

/// Of a model in memory, beside which lies crate.mtl.
inline OpenedLevel opened(std::string_view obj, std::string_view mtl = "",
                          const std::filesystem::path& file = "models/crate.obj",
                          const LoadLimits& limits = {}) {
  MemoryFiles files;
  files.add(file, std::string(obj));
  files.add("models/crate.mtl", std::string(mtl));
  return openLevel(file, limits, {}, files);
}

/// All messages, a line each.
inline std::string listed(const OpenedLevel& level) {
  std::string text;
  for (const Diagnostic& diagnostic : level.result.diagnostics) text += format(diagnostic) + "\n";
  return text;
}

/// The box's model, each length of it times `scale`, moved along its x.
inline std::string boxModel(double scale, double moved = 0) {
  std::string obj;
  for (const double y : {0.0, 1.0})
    for (const auto& [x, z] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      obj += fmt::format("v {} {} {}\n", moved + scale * x, scale * y, scale * z);
  return obj + "f 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 8 7 6 5\nf 1 2 3 4\n";
}

}  // namespace hearth::test
