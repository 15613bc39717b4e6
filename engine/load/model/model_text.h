#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hearth {

/// A statement of an OBJ or MTL file.
struct ModelLine {
  std::string_view keyword;
  std::string_view rest;  ///< without the blanks around it
  std::uint32_t number;   ///< from 1; of the first of several lines that "\" joins
};

/// The statements of a text, one after the other. Blank lines are left out, and comments: lines
/// that begin with "#". A "\" at the end of a line joins the next one to it, as if it were a blank.
class ModelLines {
 public:
  /// The text must outlive what is read from it.
  explicit ModelLines(std::string_view text);

  std::optional<ModelLine> next();

 private:
  std::string_view take();

  std::string_view left_;
  std::uint32_t taken_ = 0;  ///< lines
};

/// Takes the next word off a text: none at its end, or where a word begins with "#".
std::optional<std::string_view> takeWord(std::string_view& text);

/// Without the blanks at both ends.
std::string_view withoutBlanks(std::string_view text);

/// For a message: cut short where it is long.
std::string shortened(std::string_view word);

}  // namespace hearth
