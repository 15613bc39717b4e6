#pragma once

#include <string>

namespace hearth {

/// One mistake (or doubt) in a file, with its place.
struct Diagnostic {
  std::string file;     ///< as the caller named it, or found from there
  int line = 1;         ///< from 1
  int column = 1;       ///< from 1, in bytes
  bool isError = true;  ///< else a warning: the level can be used
  std::string pointer;  ///< JSON pointer (RFC 6901) of the value; empty for the file as a whole
  std::string message;  ///< what is wrong
  std::string advice;   ///< what to do
  std::string kind{};   ///< of a warning: a name that stays, for programs

  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

/// `FILE:LINE:COLUMN: error: what is wrong, at /json/pointer, what to do`, one line. One of a kind
/// ends with ` [kind]`.
std::string format(const Diagnostic& diagnostic);

}  // namespace hearth
