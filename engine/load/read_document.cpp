#include "load/read_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "load/parse.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

bool readText(const fs::path& path, const LoadLimits& limits, Document& document, Place place,
              Report& report) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    report.error(place, fs::exists(path, error) ? "not a regular file" : "no such file",
                 "name a JSON file");
    return false;
  }
  const std::uintmax_t size = fs::file_size(path, error);
  // Places are offsets of 32 bits.
  const std::uint64_t limit = std::min<std::uint64_t>(limits.fileBytes, 0xFFFFFFFE);
  if (error || size > limit) {
    report.error(place,
                 error ? error.message() : fmt::format("{} bytes are more than {}", size, limit),
                 error ? "make it readable" : "raise the limit with --max-file-bytes");
    return false;
  }
  document.text.resize(size);
  std::ifstream in(path, std::ios::binary);
  if (!in.read(document.text.data(), static_cast<std::streamsize>(size))) {
    document.text.clear();
    report.error(place, "cannot be read", "check its permissions");
    return false;
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (document.text.starts_with(kByteOrderMark)) document.text.erase(0, kByteOrderMark.size());
  return true;
}

}  // namespace

bool readDocument(const fs::path& path, const LoadLimits& limits, Document& document,
                  std::uint32_t documentIndex, Report& report) {
  document.file = path.string();
  return readText(path, limits, document, {documentIndex, 0}, report) &&
         parse(document, documentIndex, report);
}

}  // namespace hearth
