#include "cli/start_instead.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace hearth {

std::string startInstead(std::string_view program, char* const* arguments) {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& place : {folder / program, folder.parent_path() / "libexec/hearth" / program}) {
    execv(place.c_str(), arguments);
    if (errno != ENOENT) return fmt::format("{}: {}", place.string(), std::strerror(errno));
  }
  return fmt::format("{} is not beside this program; build it, too", program);
}

}  // namespace hearth
