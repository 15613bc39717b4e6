#pragma once

#include <filesystem>
#include <optional>

/// Where the user's own files lie (XDG Base Directory Specification). These folders need not
/// exist. There is none if the environment names no home.
namespace hearth {

/// `hearth` in $XDG_CACHE_HOME, else in ~/.cache: files that can be made anew.
std::optional<std::filesystem::path> cacheFolder();

/// `hearth/config.json` in $XDG_CONFIG_HOME, else in ~/.config.
std::optional<std::filesystem::path> configFile();

/// `hearth` in $XDG_STATE_HOME, else in ~/.local/state: what the program remembers by itself.
std::optional<std::filesystem::path> stateFolder();

}  // namespace hearth
