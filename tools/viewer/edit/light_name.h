#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hearth {

/// The first comment of the object of a JSON text that begins at `object`; empty without one.
std::string commentAt(std::string_view json, std::size_t object);

/// What a light is called: `3 lamp posts`, its number in its file and its comment, or `light 3`.
std::string lightName(std::size_t light, const std::string& comment);

}  // namespace hearth
