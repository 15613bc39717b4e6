#include "viewer/edit/level_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>

#include "text/json_text.h"

namespace hearth {

tl::unexpected<std::string> levelFileError(const LoadedLevel& loaded, std::string_view what) {
  return tl::make_unexpected(fmt::format("{}: {}", loaded.path.string(), what));
}

tl::expected<void, std::string> editLevelFile(
    Storage& storage, const LoadedLevel& loaded,
    const std::function<std::string(std::string_view)>& edited) {
  const auto bytes = storage.read(loaded.path, std::numeric_limits<std::uint64_t>::max());
  if (!bytes) return levelFileError(loaded, bytes.error().what);
  std::string_view text = *bytes;
  const std::string_view mark =
      text.starts_with(kByteOrderMark) ? kByteOrderMark : std::string_view();
  text.remove_prefix(mark.size());
  if (std::hash<std::string_view>{}(text) != loaded.textHash)
    return levelFileError(loaded,
                          "has changed since it was loaded; try again once it is shown as it is");
  return storage.write(loaded.path, std::string(mark) + edited(text));
}

}  // namespace hearth
