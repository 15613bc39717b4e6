#include "desktop/window_place.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "files/replace_file.h"

namespace hearth {

namespace {

/// Points of the part of a window that lies on a screen.
std::int64_t overlap(const WindowPlace& place, const Screen& screen) {
  const auto shared = [](int begin, int length, int screenBegin, int screenLength) {
    const std::int64_t end =
        std::min(std::int64_t{begin} + length, std::int64_t{screenBegin} + screenLength);
    return std::max<std::int64_t>(0, end - std::max(begin, screenBegin));
  };
  return shared(place.x, place.size.width, screen.x, screen.width) *
         shared(place.y, place.size.height, screen.y, screen.height);
}

}  // namespace

WindowPlace onScreen(WindowPlace place, std::span<const Screen> screens) {
  if (screens.empty()) return place;
  const auto most = std::ranges::max_element(
      screens, {}, [&place](const Screen& screen) { return overlap(place, screen); });
  place.size.width = std::min(place.size.width, most->width);
  place.size.height = std::min(place.size.height, most->height);
  place.x = std::clamp(place.x, most->x, most->x + most->width - place.size.width);
  place.y = std::clamp(place.y, most->y, most->y + most->height - place.size.height);
  return place;
}

std::optional<WindowPlace> readWindowPlace(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
  const auto number = [&json](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
  };
  if (!json.is_object()) return std::nullopt;
  constexpr std::int64_t kFarthest = 1 << 20;  // no desktop is larger
  for (const char* key : {"x", "y"})
    if (std::abs(number(key)) > kFarthest) return std::nullopt;
  for (const char* key : {"width", "height"})
    if (number(key) < 1 || number(key) > kMaxPictureSide) return std::nullopt;
  return WindowPlace{static_cast<int>(number("x")),
                     static_cast<int>(number("y")),
                     {static_cast<int>(number("width")), static_cast<int>(number("height"))},
                     json.value("fullScreen", nlohmann::json()) == true};
}

void keepWindowPlace(const std::filesystem::path& file, const WindowPlace& place) {
  const nlohmann::json json = {{"x", place.x},
                               {"y", place.y},
                               {"width", place.size.width},
                               {"height", place.size.height},
                               {"fullScreen", place.isFullScreen}};
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  const auto written = replaceFile(file, [&json](std::ostream& stream) {
    stream << json << '\n';
    return stream.good();
  });
  static_cast<void>(written);
}

}  // namespace hearth
