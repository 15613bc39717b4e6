#include "folders/user_folders.h"

#include <cstdlib>

namespace hearth {

namespace {

namespace fs = std::filesystem;

fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// The specification has paths that are not absolute ignored.
std::optional<fs::path> folder(const char* name, const char* belowHome) {
  fs::path home = variable(name);
  if (!home.is_absolute()) home = variable("HOME") / belowHome;
  if (!home.is_absolute()) return std::nullopt;
  return home / "hearth";
}

}  // namespace

std::optional<fs::path> cacheFolder() { return folder("XDG_CACHE_HOME", ".cache"); }

std::optional<fs::path> configFile() {
  auto path = folder("XDG_CONFIG_HOME", ".config");
  if (path) *path /= "config.json";
  return path;
}

std::optional<fs::path> stateFolder() { return folder("XDG_STATE_HOME", ".local/state"); }

}  // namespace hearth
