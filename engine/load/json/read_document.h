#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "files/file_source.h"
#include "load/json/document.h"
#include "load/json/report.h"
#include "load/limits.h"

namespace hearth {

/// Reads a JSON file into a tree. What is wrong with the file as a whole, and what parse() finds,
/// goes to the report; the result is false where the tree must not be used.
/// With `unsaved` the file is taken to hold this text.
bool readDocument(const FileSource& files, const std::filesystem::path& path,
                  const std::optional<std::string>& unsaved, const LoadLimits& limits,
                  Document& document, std::uint32_t documentIndex, Report& report);
/// The same of what has been read of the file.
bool readDocument(const std::filesystem::path& path, tl::expected<std::string, ReadError> bytes,
                  Document& document, std::uint32_t documentIndex, Report& report);

/// The same of a text that is at hand; a byte order mark at its begin is left out. The document
/// knows already what messages call it.
bool readText(std::string text, Document& document, std::uint32_t documentIndex, Report& report);

}  // namespace hearth
