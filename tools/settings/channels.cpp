#include "settings/channels.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "math/check.h"
#include "render/views.h"

namespace hearth {

namespace {

struct FourSpaces {};

struct Row {
  std::string_view name;
  std::variant<Marks, Channel, View, FourSpaces> draws;
  std::string_view shows;
};

constexpr std::array kRows = {
    Row{"grid", Marks::Texels, "lines between the lightmaps' texels, stronger ones at every 8th"},
    Row{"outlines", Marks::Outlines,
        "edges: walls white, ways on orange, flat portals and borders in stacks green"},
    Row{"holes", Marks::Coverage, "magenta: drawn by nothing; red: drawn more than once"},
    Row{"vertices", Marks::Vertices, "yellow: corners of meshes' faces that show"},
    Row{"sector", Channel::Sector, "a colour for each sector"},
    Row{"surface", Channel::Surface, "a colour for each surface"},
    Row{"faces", Channel::Faces, "a colour for each face of a mesh; the rest dark"},
    Row{"depth", Channel::Depth, "the nearer the brighter; half bright at 1 m"},
    Row{"uv", Channel::Uv, "red: u, green: v, within an image"},
    Row{"normal", Channel::Normal, "where surfaces face: x red, y green, z blue"},
    Row{"backs", Channel::Backs, "red: meshes' faces seen from their backs; else grey"},
    Row{"light", Channel::Light, "the lightmaps alone, without the light of sectors"},
    Row{"overdraw", Channel::Overdraw, "green: drawn once, red: more often"},
    Row{"wireframe", View::Wireframe,
        "edges of all walls and meshes, hidden or not, dimmer when far"},
    Row{"world", View::World, "world space: the plan, with the eye and what it looks at"},
    Row{"camera", View::Camera, "camera space: the plan as the eye turns it, looking up"},
    Row{"depthspace", View::DepthSpace, "depth space: columns to the right, 1/depth downwards"},
    Row{"screen", View::Screen, "screen space: edges of walls in view, dim where hidden"},
    Row{"spaces", FourSpaces{}, "world, camera, depth and screen space side by side"},
};
constexpr std::array kSpaces = {View::World, View::Camera, View::DepthSpace, View::Screen};

ChannelKind kindOf(const Row& row) {
  if (std::holds_alternative<Marks>(row.draws)) return ChannelKind::Marks;
  return std::holds_alternative<Channel>(row.draws) ? ChannelKind::Numbers : ChannelKind::Geometry;
}

const Row* find(std::string_view name) {
  const auto* const found = std::ranges::find(kRows, name, &Row::name);
  return found == kRows.end() ? nullptr : found;
}

/// The four spaces in the quarters of a picture, row by row.
void drawAllSpaces(const Scene& scene, const Camera& camera, const PixelRows& picture) {
  const std::array<int, 3> xs = {0, camera.width / 2, camera.width};
  const std::array<int, 3> ys = {0, camera.height / 2, camera.height};
  for (std::size_t i = 0; i < kSpaces.size(); ++i) {
    const std::size_t column = i % 2;
    const std::size_t row = i / 2;
    Camera quarter = camera;
    quarter.width = xs.at(column + 1) - xs.at(column);
    quarter.height = ys.at(row + 1) - ys.at(row);
    if (quarter.width > 0 && quarter.height > 0)
      drawView(scene, quarter, kSpaces.at(i),
               picture.part(xs.at(column), ys.at(row), quarter.width, quarter.height));
  }
}

void drawGeometry(const Row& row, const Scene& scene, const Camera& camera,
                  const PixelRows& picture) {
  if (const View* view = std::get_if<View>(&row.draws))
    drawView(scene, camera, *view, picture);
  else
    drawAllSpaces(scene, camera, picture);
}

}  // namespace

std::vector<ChannelText> channelTexts() {
  std::vector<ChannelText> texts;
  for (const Row& row : kRows) texts.push_back({row.name, kindOf(row), row.shows});
  return texts;
}

bool isGeometry(std::string_view channel) {
  const Row* row = find(channel);
  return row && kindOf(*row) == ChannelKind::Geometry;
}

bool isOfCamera(std::string_view channel) {
  if (!isGeometry(channel)) return true;
  const View* view = std::get_if<View>(&find(channel)->draws);
  return view && (*view == View::Screen || *view == View::Wireframe);
}

std::optional<Image> drawGeometry(const Scene& scene, const Camera& camera,
                                  std::string_view channel) {
  if (!isGeometry(channel)) return std::nullopt;
  PixelBuffer memory;
  const PixelRows picture = memory.rows(camera.width, camera.height);
  drawGeometry(*find(channel), scene, camera, picture);
  return imageOf(picture);
}

void drawChannel(const Scene& scene, const Renderer& renderer, const Camera& camera,
                 std::string_view channel, FrameScratch& scratch, const PixelRows& picture,
                 Workers* workers) {
  const Row* row = find(channel);
  CHECK(row, channel);  // the option takes no other
  if (const Marks* marks = std::get_if<Marks>(&row->draws))
    renderer.draw(camera, *marks, scratch, picture, workers);
  else if (const Channel* numbers = std::get_if<Channel>(&row->draws))
    renderer.draw(camera, *numbers, scratch, picture, workers);
  else
    drawGeometry(*row, scene, camera, picture);
}

}  // namespace hearth
