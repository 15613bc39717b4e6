#include "load/diagnostic.h"

#include <fmt/format.h>

namespace hearth {

namespace {

/// Names come from files: whatever could end the line or drive a terminal is shown as `\xNN`.
std::string printable(const std::string& text) {
  std::string shown;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f)
      shown += fmt::format("\\x{:02x}", byte);
    else
      shown += c;
  }
  return shown;
}

}  // namespace

std::string format(const Diagnostic& diagnostic) {
  std::string text =
      fmt::format("{}:{}:{}: {}: {}", diagnostic.file, diagnostic.line, diagnostic.column,
                  diagnostic.isError ? "error" : "warning", diagnostic.message);
  if (!diagnostic.pointer.empty()) text += ", at " + diagnostic.pointer;
  if (!diagnostic.advice.empty()) text += ", " + diagnostic.advice;
  if (!diagnostic.kind.empty()) text += " [" + diagnostic.kind + "]";
  return printable(text);
}

}  // namespace hearth
