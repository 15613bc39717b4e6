#pragma once

#include <filesystem>

namespace hearth::test {

/// The path of a file of the source tree, which is named from its root. Tests do not hold the
/// tree's place themselves: so ccache knows them in a tree that lies elsewhere.
std::filesystem::path inTree(const std::filesystem::path& file);

}  // namespace hearth::test
