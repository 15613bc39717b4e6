#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "load/model/read_model.h"
#include "support/memory_files.h"

namespace hearth {

/// Reads the text of models/crate.obj, beside which lies models/crate.mtl.
inline ModelRead readObj(std::string_view obj, std::string_view mtl = "",
                         const LoadLimits& limits = {}) {
  test::MemoryFiles files;
  files.add("models/crate.obj", std::string(obj));
  files.add("models/crate.mtl", std::string(mtl));
  return readModel("models/crate.obj", limits, files);
}

/// All messages as `FILE:LINE: error: MESSAGE, ADVICE`, one a line.
inline std::string listed(const ModelRead& read) {
  std::string text;
  for (const ModelMistake& mistake : read.mistakes)
    text += fmt::format("{}:{}: {}: {}, {}\n", mistake.file.filename().string(), mistake.line,
                        mistake.isError ? "error" : "warning", mistake.message, mistake.advice);
  return text;
}

/// Of a text in which nothing is wrong. Fails the running test, and stops the program, when
/// something is.
inline Model modelOf(std::string_view obj, std::string_view mtl = "") {
  ModelRead read = readObj(obj, mtl);
  EXPECT_EQ(listed(read), "");
  if (!read.model) std::abort();
  return *std::move(read.model);
}

/// Four vertices: the corners of a square, counter-clockwise.
inline const std::string kSquareVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace hearth
