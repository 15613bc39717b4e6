#pragma once

#include <string_view>

#include "files/read_file.h"

namespace hearth {

/// What to do about a file that could not be read; `otherwise` if the name itself is wrong.
constexpr std::string_view adviceOn(ReadErrorCode code, std::string_view otherwise) {
  switch (code) {
    case ReadErrorCode::Missing:
    case ReadErrorCode::NotRegular:
      return otherwise;
    case ReadErrorCode::TooLong:
      return "raise the limit with --max-file-bytes";
    case ReadErrorCode::Changed:
      return "try again";
    case ReadErrorCode::Failed:
      return "make it readable";
  }
  return "";
}

}  // namespace hearth
