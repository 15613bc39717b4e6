#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include "cli/command.h"
#include "files/replace_file.h"
#include "inputs/inputs.h"
#include "load/json/read_document.h"
#include "text/json_layout.h"

namespace hearth {

namespace {

/// The text of a JSON file without its byte order mark; what is wrong with it goes to stderr.
std::optional<std::string> readJson(const std::string& path, const LoadLimits& limits) {
  std::array<Document, 1> documents;
  Report report;
  const bool isRead = readDocument(DiskFiles(), path, {}, limits, documents[0], 0, report);
  for (const Diagnostic& diagnostic : report.resolve(documents))
    fmt::print(stderr, "{}\n", format(diagnostic));
  if (!isRead || report.hasErrors()) return std::nullopt;
  return std::move(documents[0].text);
}

ExitStatus write(const std::string& path, const std::string& text) {
  const auto written = replaceFile(path, [&](std::ostream& stream) {
    stream << text;
    return stream.good();
  });
  return written ? ExitStatus::Done : fail(written.error());
}

ExitStatus runFmt(const OptionValues& values) {
  const std::string output = values.text(Option::Output).value_or(values.level);
  if (values.has(Option::Check) && values.has(Option::Output))
    return fail("--check writes nothing; give it or -o, not both");
  const LoadLimits limits = limitsFrom(values);
  const std::optional<std::string> text = readJson(values.level, limits);
  if (!text) return ExitStatus::BadInput;
  const std::optional<std::string> laidOut = layOut(*text, limits.fileBytes);
  if (!laidOut)
    return fail(fmt::format("{}: laid out, it has more than {} bytes: raise the limit with {}",
                            values.level, limits.fileBytes, row(Option::MaxFileBytes).name));
  const bool isSame = *laidOut == *text;
  if (values.has(Option::Check)) {
    if (!isSame) fmt::print("{}: not as `hearth fmt` lays it out\n", values.level);
    return isSame ? ExitStatus::Done : ExitStatus::Differs;
  }
  if (output == "-") {
    fmt::print("{}", *laidOut);
    return ExitStatus::Done;
  }
  if (isSame && output == values.level) return ExitStatus::Done;
  return write(output, *laidOut);
}

}  // namespace

Command fmtCommand() {
  return {"fmt",
          "lays a level or lights file out anew, and changes nothing of what it says",
          {Option::Output, Option::Check, Option::MaxFileBytes},
          {},
          runFmt};
}

}  // namespace hearth
