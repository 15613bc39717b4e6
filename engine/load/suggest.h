#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hearth {

/// How many letters must be put in, taken out, replaced or swapped with their neighbour to turn one
/// name into the other (Damerau-Levenshtein, restricted).
std::size_t editDistance(std::string_view a, std::string_view b);

/// The known name that `name` is a slip of: at most two edits away.
std::optional<std::string_view> nearestName(std::string_view name,
                                            std::span<const std::string_view> known);

/// `did you mean "floor"?` for the nearest known name; else `one of: ...`
/// when the names are few enough to list; else `fallback`.
std::string suggest(std::string_view name, std::span<const std::string_view> known,
                    std::string_view fallback);

}  // namespace hearth
