#include "viewer/edit/shots_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "text/json_edit.h"
#include "text/json_text.h"

namespace hearth {

namespace {

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// As levels have it, on one line.
std::string shotText(const Bookmark& mark) {
  const std::string fov = mark.fov == Shot{}.fov ? "" : fmt::format(", \"fov\": {}", mark.fov);
  return fmt::format("{{ \"name\": {}, \"camera\": [{}, {}, {}, {}, {}]{}, \"sector\": {} }}",
                     quoted(mark.name), mark.eye.x, mark.eye.y, mark.eye.z, mark.angle, mark.pitch,
                     fov, quoted(mark.sector));
}

}  // namespace

tl::expected<void, std::string> writeShot(Storage& storage, const LoadedLevel& loaded,
                                          const Bookmark& bookmark) {
  const auto failure = [&loaded](const std::string& what) {
    return tl::make_unexpected(fmt::format("{}: {}", loaded.path.string(), what));
  };
  const std::vector<Shot>& shots = loaded.level.shots;
  if (std::ranges::find(shots, bookmark.name, &Shot::name) != shots.end())
    return failure(
        fmt::format("has a shot \"{}\" already; give the bookmark another name", bookmark.name));
  const auto bytes = storage.read(loaded.path, std::numeric_limits<std::uint64_t>::max());
  if (!bytes) return failure(bytes.error().what);
  std::string_view text = *bytes;
  const std::string_view mark =
      text.starts_with(kByteOrderMark) ? kByteOrderMark : std::string_view();
  text.remove_prefix(mark.size());
  if (std::hash<std::string_view>{}(text) != loaded.textHash)
    return failure("has changed since it was loaded; try again once it is shown as it is");
  const std::string edited = withElementIn(text, "shots", "sectors", shotText(bookmark));
  return storage.write(loaded.path, std::string(mark) + edited);
}

}  // namespace hearth
