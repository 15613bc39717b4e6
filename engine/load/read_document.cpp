#include "load/read_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "load/parse.h"

namespace hearth {

namespace {

std::string adviceOn(ReadFault fault, std::filesystem::path path) {
  switch (fault) {
    case ReadFault::Missing: {
      path += ".json";
      std::error_code ignored;
      if (std::filesystem::exists(path, ignored))
        return fmt::format("did you mean {}?", path.string());
      return "name a JSON file";
    }
    case ReadFault::NotRegular:
      return "name a JSON file";
    case ReadFault::TooLong:
      return "raise the limit with --max-file-bytes";
    case ReadFault::Changed:
      return "try again";
    case ReadFault::Failed:
      return "make it readable";
  }
  return "";
}

}  // namespace

bool readDocument(const std::filesystem::path& path, const LoadLimits& limits, Document& document,
                  std::uint32_t documentIndex, Report& report) {
  constexpr std::uint64_t kMostPlaces = 0xFFFFFFFE;  // places are offsets of 32 bits
  return readDocument(path, readFile(path, std::min(limits.fileBytes, kMostPlaces)), document,
                      documentIndex, report);
}

bool readDocument(const std::filesystem::path& path, tl::expected<std::string, ReadFailure> bytes,
                  Document& document, std::uint32_t documentIndex, Report& report) {
  document.file = path.string();
  if (!bytes) {
    report.error({documentIndex, 0}, bytes.error().what, adviceOn(bytes.error().fault, path));
    return false;
  }
  return readText(*std::move(bytes), document, documentIndex, report);
}

bool readDocument(const std::filesystem::path& path, const std::optional<std::string>& unsaved,
                  const LoadLimits& limits, Document& document, std::uint32_t documentIndex,
                  Report& report) {
  if (!unsaved) return readDocument(path, limits, document, documentIndex, report);
  document.file = path.string();
  return readText(*unsaved, document, documentIndex, report);
}

bool readText(std::string text, Document& document, std::uint32_t documentIndex, Report& report) {
  document.text = std::move(text);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (document.text.starts_with(kByteOrderMark)) document.text.erase(0, kByteOrderMark.size());
  if (document.text.starts_with(kByteOrderMark)) {  // which the JSON library would pass over
    report.error({documentIndex, 0}, "not valid JSON: a second byte order mark", "remove it");
    return false;
  }
  return parse(document, documentIndex, report);
}

}  // namespace hearth
