#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hearth {

/// The first comment of the object of a JSON text that begins at `object`; empty without one.
std::string commentAt(std::string_view json, std::size_t object);

/// What a light is called: its number in its file and, if it has one, its comment.
std::string lightName(std::size_t light, const std::string& comment);

}  // namespace hearth
