#pragma once

#include <span>
#include <string>
#include <string_view>

/// Edits of a JSON text by the names of what is edited, that leave all of it but one place as it is
/// spelled. They expect JSON that parse() has taken, of which the root is an object, and values in
/// JSON.
namespace hearth {

/// Sets the member that `path`, keys from the root on, leads to. What is missing on the way is
/// made, at the end of its object; what is no object there gives way to one.
std::string withValueAt(std::string_view json, std::span<const std::string_view> path,
                        std::string_view value);

/// Appends to the array that is the member `key` of the root. Where there is none it is made, in
/// front of the member `before` if there is that.
/// Expects: the member is an array, or not there.
std::string withElementIn(std::string_view json, std::string_view key, std::string_view before,
                          std::string_view value);

}  // namespace hearth
