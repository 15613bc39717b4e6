#include "load/json/read_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "load/json/parse.h"
#include "load/read_advice.h"

namespace hearth {

namespace {

constexpr std::string_view kOtherwise = "name a JSON file";

/// Suggests the path with `.json` added if there is such a file.
std::string adviceOn(const ReadError& failure, const FileSource& files,
                     std::filesystem::path path) {
  path += ".json";
  if (failure.code == ReadErrorCode::Missing && files.kindOf(path) != FileKind::None)
    return fmt::format("did you mean {}?", path.string());
  return std::string(adviceOn(failure.code, kOtherwise));
}

}  // namespace

bool readDocument(const FileSource& files, const std::filesystem::path& path,
                  const std::optional<std::string>& unsaved, const LoadLimits& limits,
                  Document& document, std::uint32_t documentIndex, Report& report) {
  constexpr std::uint64_t kMaxPlaces = 0xFFFFFFFE;  // Place::offset has 32 bits
  document.file = path.string();
  if (unsaved) return readText(*unsaved, document, documentIndex, report);
  auto bytes = files.read(path, std::min(limits.fileBytes, kMaxPlaces));
  if (bytes) return readText(*std::move(bytes), document, documentIndex, report);
  report.error({documentIndex, 0}, bytes.error().what, adviceOn(bytes.error(), files, path));
  return false;
}

bool readDocument(const std::filesystem::path& path, tl::expected<std::string, ReadError> bytes,
                  Document& document, std::uint32_t documentIndex, Report& report) {
  document.file = path.string();
  if (bytes) return readText(*std::move(bytes), document, documentIndex, report);
  report.error({documentIndex, 0}, bytes.error().what,
               std::string(adviceOn(bytes.error().code, kOtherwise)));
  return false;
}

bool readText(std::string text, Document& document, std::uint32_t documentIndex, Report& report) {
  document.text = std::move(text);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (document.text.starts_with(kByteOrderMark)) document.text.erase(0, kByteOrderMark.size());
  if (document.text.starts_with(kByteOrderMark)) {  // the JSON library would accept it
    report.error({documentIndex, 0}, "not valid JSON: a second byte order mark", "remove it");
    return false;
  }
  return parse(document, documentIndex, report);
}

}  // namespace hearth
