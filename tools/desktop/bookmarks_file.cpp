#include "desktop/bookmarks_file.h"

#include <fmt/format.h>

#include <system_error>

#include "folders/user_folders.h"
#include "math/hash.h"

namespace hearth {

namespace fs = std::filesystem;

std::optional<fs::path> bookmarksFile(const fs::path& level) {
  const auto folder = stateFolder();
  if (!folder) return std::nullopt;
  std::error_code error;
  const fs::path place = fs::weakly_canonical(level, error);
  Hash hash;
  hash.addText((error ? level : place).string());
  return *folder / "bookmarks" /
         fmt::format("{}-{:016x}.json", level.stem().string(), hash.value());
}

}  // namespace hearth
