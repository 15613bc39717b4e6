#pragma once

#include <string>
#include <string_view>

#include "load/load.h"

namespace hearth {

/// Loads a level from the text of its file and of its lights file, if any. Single quotes stand for
/// double ones.
LoadResult loadText(std::string_view level, std::string_view lights = "",
                    const LoadLimits& limits = {});

/// As above, from the text between the braces of "sectors", in a level with `light` 0.5. Fails the
/// running test, and stops the program, when that has an error.
LoadedLevel loadSectors(std::string_view sectors, std::string_view lights = "");

/// `'name': {...}` for a sector of plain colours. `walls` is an array or one wall for all, `more`
/// are further members of the sector; a floor or ceiling there replaces the plain one.
std::string sectorText(std::string_view name, std::string_view vertices,
                       std::string_view walls = "{'texture': '#808080'}",
                       std::string_view more = "");

/// All messages, one per line.
std::string listed(const LoadResult& result);

/// The messages of one kind.
std::size_t countErrors(const LoadResult& result);
std::size_t countWarnings(const LoadResult& result);

const Sector& sectorNamed(const Level& level, std::string_view name);

/// Expects of every opening of a level that its twin has the same two end points, to the bit.
void expectTwins(const Scene& scene);

}  // namespace hearth
