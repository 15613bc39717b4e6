#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Where the parts of a JSON text stand, ignored keys among them, and the changes that leave all
/// others as they are spelled. Offsets are bytes. All of it expects JSON that parse() has taken.
namespace hearth {

/// What may stand between the parts of a JSON text (RFC 8259).
inline constexpr std::string_view kJsonBlanks = " \t\r\n";

/// U+FEFF in UTF-8, with which some editors begin files.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct TextRange {
  std::size_t begin;
  std::size_t end;  ///< one past the last byte

  std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// Where the text's one value begins.
std::size_t rootOf(std::string_view json);
/// The value that begins at `begin`.
TextRange valueAt(std::string_view json, std::size_t begin);
/// The blanks that end at `end`.
std::string_view blanksBefore(std::string_view json, std::size_t end);
/// Of blanks the last line break and what follows; all of them without one.
std::string_view lastLineOf(std::string_view blanks);

struct MemberRange {
  std::string name;
  TextRange key;  ///< with its quotes
  TextRange value;
};

/// Of the object that begins at `object`, in the order of the text.
std::vector<MemberRange> membersAt(std::string_view json, std::size_t object);
/// The first of them that is a comment, of one string.
std::optional<std::size_t> commentIn(std::string_view json,
                                     const std::vector<MemberRange>& members);
/// Of the array that begins at `array`.
std::vector<TextRange> elementsAt(std::string_view json, std::size_t array);

/// Bytes of a text in place of others.
struct Replacement {
  std::size_t offset;
  std::string before;
  std::string after;
};

/// A member that is to be written: its key and its value, spelled.
struct SpelledMember {
  std::string key;
  std::string value;
};

/// Gives the object's member a value. One that is not there yet comes behind the last of those
/// that `earlier` names, with blanks as before that; if there is none, before all that it has.
Replacement withMember(std::string_view json, std::size_t object, const SpelledMember& member,
                       const std::vector<std::string_view>& earlier);
/// Gives the object a comment, spelled, in place of the first one that it has, else before all that
/// it has.
Replacement withComment(std::string_view json, std::size_t object, std::string_view comment);
/// Takes the first comment out. Expects: the object has one.
Replacement withoutComment(std::string_view json, std::size_t object);
/// Takes a member out with one of its commas. Expects: the object has it.
Replacement withoutMember(std::string_view json, std::size_t object, std::string_view key);

/// Puts an object at the end of an array, in the manner of the last one there, which has the
/// members `x`, `y` and `z`, or `angle` and `pitch`; in an empty array in that of the whole text.
Replacement withObject(std::string_view json, std::size_t array,
                       const std::vector<SpelledMember>& members);
/// Takes an element out with one of its commas.
Replacement withoutElement(std::string_view json, std::size_t array, std::size_t index);

}  // namespace hearth
