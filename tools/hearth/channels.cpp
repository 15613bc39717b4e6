#include "hearth/channels.h"

#include <algorithm>
#include <array>
#include <utility>

#include "hearth/options.h"
#include "math/check.h"
#include "render/views.h"

namespace hearth {

namespace {

constexpr std::array kChannels = {
    std::pair{std::string_view("sector"), Channel::Sector},
    std::pair{std::string_view("surface"), Channel::Surface},
    std::pair{std::string_view("depth"), Channel::Depth},
    std::pair{std::string_view("uv"), Channel::Uv},
    std::pair{std::string_view("normal"), Channel::Normal},
    std::pair{std::string_view("light"), Channel::Light},
    std::pair{std::string_view("overdraw"), Channel::Overdraw},
};
constexpr std::array kMarks = {
    std::pair{std::string_view("grid"), Marks::Texels},
    std::pair{std::string_view("outlines"), Marks::Outlines},
    std::pair{std::string_view("holes"), Marks::Coverage},
};
constexpr std::array kSpaces = {
    std::pair{std::string_view("world"), View::World},
    std::pair{std::string_view("camera"), View::Camera},
    std::pair{std::string_view("depthspace"), View::DepthSpace},
    std::pair{std::string_view("screen"), View::Screen},
};
constexpr std::string_view kAllSpaces = "spaces";
constexpr std::string_view kWireframe = "wireframe";

template <typename Table>
auto find(const Table& table, std::string_view name) -> std::optional<decltype(table[0].second)> {
  for (const auto& [key, value] : table)
    if (key == name) return value;
  return std::nullopt;
}

void copy(const Image& tile, int left, int top, Image& picture) {
  for (int y = 0; y < tile.height(); ++y)
    for (int x = 0; x < tile.width(); ++x) picture.at(left + x, top + y) = tile.at(x, y);
}

/// The four views in the quarters of a picture, row by row.
Image drawAllSpaces(const Level& level, const Camera& camera) {
  Image picture(camera.width, camera.height);
  const std::array<int, 3> xs = {0, camera.width / 2, camera.width};
  const std::array<int, 3> ys = {0, camera.height / 2, camera.height};
  for (std::size_t i = 0; i < kSpaces.size(); ++i) {
    const std::size_t column = i % 2;
    const std::size_t row = i / 2;
    Camera quarter = camera;
    quarter.width = xs.at(column + 1) - xs.at(column);
    quarter.height = ys.at(row + 1) - ys.at(row);
    if (quarter.width > 0 && quarter.height > 0)
      copy(drawView(level, quarter, kSpaces.at(i).second), xs.at(column), ys.at(row), picture);
  }
  return picture;
}

}  // namespace

std::vector<std::string_view> channelNames() { return split(row(Option::Channel).value, '|'); }

std::optional<Image> drawGeometry(const Level& level, const Camera& camera,
                                  std::string_view channel) {
  if (channel == kAllSpaces) return drawAllSpaces(level, camera);
  if (channel == kWireframe) return drawView(level, camera, View::Wireframe);
  if (const auto view = find(kSpaces, channel)) return drawView(level, camera, *view);
  return std::nullopt;
}

Image drawChannel(const Level& level, const Renderer& renderer, const Camera& camera,
                  std::string_view channel) {
  if (auto geometry = drawGeometry(level, camera, channel)) return *std::move(geometry);
  if (const auto marks = find(kMarks, channel)) return renderer.draw(camera, *marks);
  const auto found = find(kChannels, channel);
  CHECK(found, channel);  // the option takes no other
  return renderer.draw(camera, *found);
}

}  // namespace hearth
