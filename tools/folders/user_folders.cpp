#include "folders/user_folders.h"

#include <cstdlib>

namespace hearth {

namespace {

namespace fs = std::filesystem;

fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// The XDG specification says to ignore relative paths.
std::optional<fs::path> folder(const char* name, const char* belowHome) {
  fs::path base = variable(name);
  if (!base.is_absolute()) base = variable("HOME") / belowHome;
  if (!base.is_absolute()) return std::nullopt;
  return base / "hearth";
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
