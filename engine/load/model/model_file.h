#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "files/file_source.h"

namespace hearth {

/// Why a file of a model cannot be read.
struct ModelFileMistake {
  std::string message;
  std::string advice;
};

/// The text of an OBJ or MTL file. `otherwise` is the advice on a file that is missing, if none
/// beside it has nearly its name.
tl::expected<std::string, ModelFileMistake> readModelText(const FileSource& files,
                                                          const std::filesystem::path& path,
                                                          std::uint64_t maxBytes,
                                                          std::string_view otherwise);

/// A file that another one names: seen from the other's folder, with "/" or "\" between folders.
/// Refuses names that no system takes.
tl::expected<std::filesystem::path, ModelFileMistake> pathOfNamed(std::string_view name,
                                                                  const std::filesystem::path& by);

}  // namespace hearth
