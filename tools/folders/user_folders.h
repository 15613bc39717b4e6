#pragma once

#include <filesystem>
#include <optional>

/// Where the user's own files lie (XDG Base Directory Specification). None of these folders need
/// exist, and none is named where the environment says of no home.
namespace hearth {

/// `hearth` in $XDG_CACHE_HOME, else in ~/.cache: what can be made anew.
std::optional<std::filesystem::path> cacheFolder();

/// `hearth/config.json` in $XDG_CONFIG_HOME, else in ~/.config.
std::optional<std::filesystem::path> configFile();

/// `hearth` in $XDG_STATE_HOME, else in ~/.local/state: what the program remembers by itself.
std::optional<std::filesystem::path> stateFolder();

}  // namespace hearth
