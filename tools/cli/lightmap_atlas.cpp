#include "cli/lightmap_atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "level/thing_name.h"
#include "settings/options.h"
#include "text/drawn_text.h"

namespace hearth {

namespace {

constexpr std::int64_t kGap = 8;          // pixels between lightmaps
constexpr int kLineHeight = 11;           // pixels of one line of a label and the air below it
constexpr std::int64_t kGoodSide = 1500;  // pixels; as much as a screen shows
constexpr int kMaxPixelsPerTexel = 16;
constexpr std::size_t kMaxLetters = 24;    // of a name in a label
constexpr Rgb kBackground = {24, 24, 64};  // no greys, so that no white light has them
constexpr Rgb kLabel = {255, 208, 112};

/// A lightmap with its label.
struct Entry {
  const Lightmap& map;
  bool flipsRows;  ///< its rows rise
  std::vector<std::string> label;

  std::int64_t labelHeight() const { return kLineHeight * std::ssize(label); }
  AtlasSize size(int pixelsPerTexel) const {
    std::int64_t width = std::int64_t{pixelsPerTexel} * map.rect.width;
    for (const std::string& line : label) width = std::max<std::int64_t>(width, textWidth(line));
    return {width, labelHeight() + std::int64_t{pixelsPerTexel} * map.rect.height};
  }
};

std::vector<Entry> entriesOf(const Level& level, const BakedLight& light) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < light.lightmaps.size(); ++i) {
    if (!light.lightmaps[i]) continue;
    const std::optional<LitSurface>& surface = light.surfaces[i];  // none of a thing
    const bool flipsRows = surface && surface->grid.axisT.z > 0;
    entries.push_back({*light.lightmaps[i], flipsRows, labelOf(level, SurfaceId(i))});
  }
  return entries;
}

Shelves place(const std::vector<Entry>& entries, int pixelsPerTexel) {
  std::vector<AtlasSize> sizes;
  for (const Entry& entry : entries) sizes.push_back(entry.size(pixelsPerTexel));
  return placeOnShelves(sizes);
}

bool fits(const Shelves& shelves, std::int64_t side) {
  return shelves.size.width <= side && shelves.size.height <= side;
}

/// The texels of a lightmap, each as a square of so many pixels.
void drawMap(const PixelRows& picture, int x, int y, const Entry& entry, int pixelsPerTexel) {
  const auto& [map, flipsRows, label] = entry;
  for (int row = 0; row < map.rect.height * pixelsPerTexel; ++row)
    for (int column = 0; column < map.rect.width * pixelsPerTexel; ++column) {
      const int fromTop = row / pixelsPerTexel;
      const int i = map.rect.i0 + column / pixelsPerTexel;
      const int j = map.rect.j0 + (flipsRows ? map.rect.height - 1 - fromTop : fromTop);
      *picture.at(x + column, y + row) =
          toXrgb({map.at(i, j, 0), map.at(i, j, 1), map.at(i, j, 2)});
    }
}

void draw(const PixelRows& picture, const AtlasPlace& place, const Entry& entry,
          int pixelsPerTexel) {
  const int x = static_cast<int>(place.x);
  int y = static_cast<int>(place.y);
  for (const std::string& line : entry.label) {
    drawText(picture, x, y, line, kLabel);
    y += kLineHeight;
  }
  drawMap(picture, x, y, entry, pixelsPerTexel);
}

std::string shortened(std::string text) {
  if (text.size() > kMaxLetters) text.replace(kMaxLetters - 2, std::string::npos, "..");
  return text;
}

}  // namespace

Shelves placeOnShelves(std::span<const AtlasSize> rectangles) {
  std::vector<std::size_t> order(rectangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](auto i) { return rectangles[i].height; });
  double area = 0;
  std::int64_t width = 1;
  for (const AtlasSize& size : rectangles) {
    area += static_cast<double>(size.width + kGap) * static_cast<double>(size.height + kGap);
    width = std::max(width, size.width);
  }
  width = std::max(width, static_cast<std::int64_t>(std::sqrt(area)));

  Shelves shelves{std::vector<AtlasPlace>(rectangles.size()), {kGap, kGap}};
  AtlasPlace next{kGap, kGap};
  for (const std::size_t i : order) {
    if (next.x > kGap && next.x + rectangles[i].width > width) next = {kGap, shelves.size.height};
    shelves.places[i] = next;
    shelves.size.width = std::max(shelves.size.width, next.x + rectangles[i].width + kGap);
    shelves.size.height = std::max(shelves.size.height, next.y + rectangles[i].height + kGap);
    next.x += rectangles[i].width + kGap;
  }
  return shelves;
}

std::vector<std::string> labelOf(const Level& level, SurfaceId id) {
  const Surface& surface = level[id];
  const Sector& sector = level[surface.sector];
  const std::string kind(name(surface.kind));
  if (isSprite(surface.kind)) return {kind, shortened(nameOf(level, level.spriteOf(id)))};
  if (surface.kind == SurfaceKind::Mesh) return {kind, shortened(nameOf(level, level.meshOf(id)))};
  if (!surface.segment) return {kind, shortened(sector.name)};
  const Segment& segment = level[*surface.segment];
  std::string where = sector.name;
  if (segment.loop > 0) where += "/" + sector.loops[segment.loop].name;
  return {kind, fmt::format("{} {}", shortened(where), segment.wallIndex)};
}

tl::expected<Image, std::string> lightmapAtlas(const Level& level, const BakedLight& light) {
  const std::vector<Entry> entries = entriesOf(level, light);
  int pixelsPerTexel = kMaxPixelsPerTexel;
  Shelves shelves = place(entries, pixelsPerTexel);
  while (!fits(shelves, kGoodSide) && pixelsPerTexel > 1)
    shelves = place(entries, --pixelsPerTexel);
  if (!fits(shelves, kMaxPictureSide))
    return tl::unexpected(
        fmt::format("-o: the lightmaps fill a picture of {}x{}, more than {} pixels a side: larger "
                    "--texel makes it smaller",
                    shelves.size.width, shelves.size.height, kMaxPictureSide));
  PixelBuffer memory;
  const PixelRows picture =
      memory.rows(static_cast<int>(shelves.size.width), static_cast<int>(shelves.size.height));
  picture.fill(kBackground);
  for (std::size_t i = 0; i < entries.size(); ++i)
    draw(picture, shelves.places[i], entries[i], pixelsPerTexel);
  return imageOf(picture);
}

}  // namespace hearth
