#pragma once

#include <filesystem>
#include <optional>

namespace hearth {

/// Where the bookmarks of a level file lie, by its place on the disk; none without a home.
std::optional<std::filesystem::path> bookmarksFile(const std::filesystem::path& level);

}  // namespace hearth
