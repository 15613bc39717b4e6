#include "viewer/edit/shots_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "text/json_edit.h"
#include "viewer/edit/level_file.h"

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
  const std::vector<Shot>& shots = loaded.level.shots;
  if (std::ranges::find(shots, bookmark.name, &Shot::name) != shots.end())
    return levelFileError(
        loaded,
        fmt::format("has a shot \"{}\" already; give the bookmark another name", bookmark.name));
  return editLevelFile(storage, loaded, [&](std::string_view text) {
    return withElementIn(text, "shots", "sectors", shotText(bookmark));
  });
}

}  // namespace hearth
