#include "viewer/overlay/triangle_painter.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "math/check.h"

namespace hearth {

namespace {

// Products of two differences of places are below 2^42, and below 2^63 times a place on the atlas.
constexpr std::int64_t kPerPixel = 16;
constexpr std::int64_t kPerTexel = 256;

struct Rgba {
  std::uint8_t r;
  std::uint8_t g;
  std::uint8_t b;
  std::uint8_t a;

  friend bool operator==(Rgba, Rgba) = default;
};

Rgba rgbaOf(ImU32 color) {
  const auto channel = [color](int shift) { return static_cast<std::uint8_t>(color >> shift); };
  return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT),
          channel(IM_COL32_A_SHIFT)};
}

/// A vertex in whole numbers.
struct Corner {
  std::int64_t x;  ///< 1/16 pixel
  std::int64_t y;
  std::int64_t u;  ///< 1/256 texel
  std::int64_t v;
  Rgba color;
};

/// Pixels, right and bottom excluded.
struct Area {
  int left;
  int top;
  int right;
  int bottom;
};

// --- Rounding ------------------------------------------------------------------------------------

std::int64_t floorDiv(std::int64_t dividend, std::int64_t divisor) {  // divisor > 0
  const std::int64_t quotient = dividend / divisor;
  return quotient - (dividend % divisor < 0 ? 1 : 0);
}

std::int64_t ceilDiv(std::int64_t dividend, std::int64_t divisor) {
  return -floorDiv(-dividend, divisor);
}

/// The nearest whole number to product / 255, for products up to 255 * 255.
unsigned per255(unsigned product) {
  const unsigned sum = product + 128;
  return (sum + (sum >> 8)) >> 8;
}

/// The first pixel whose centre is not before `edge`, within [0, size].
int firstPixelFrom(float edge, int size) {
  if (!(edge > 0)) return 0;
  if (edge >= static_cast<float>(size)) return size;
  return static_cast<int>(std::ceil(edge - 0.5F));
}

std::optional<std::int64_t> placeOf(float pixels) {
  if (!(std::abs(pixels) <= static_cast<float>(TrianglePainter::kFarthest))) return std::nullopt;
  return std::llround(static_cast<double>(pixels) * kPerPixel);
}

std::optional<std::int64_t> texelPlaceOf(float fraction, int texels) {
  if (!std::isfinite(fraction)) return std::nullopt;
  const auto end = static_cast<double>(texels * kPerTexel);
  return std::llround(std::clamp(static_cast<double>(fraction) * end, 0.0, end - 1));
}

std::optional<Corner> cornerOf(const ImDrawVert& vertex, const GlyphAtlas& atlas) {
  const auto x = placeOf(vertex.pos.x);
  const auto y = placeOf(vertex.pos.y);
  const auto u = texelPlaceOf(vertex.uv.x, atlas.width);
  const auto v = texelPlaceOf(vertex.uv.y, atlas.height);
  if (!x || !y || !u || !v) return std::nullopt;
  return Corner{*x, *y, *u, *v, rgbaOf(vertex.col)};
}

Area areaOf(const ImVec4& clip, const PixelRows& picture) {
  if (!(clip.x < clip.z && clip.y < clip.w)) return {};
  return {firstPixelFrom(clip.x, picture.width), firstPixelFrom(clip.y, picture.height),
          firstPixelFrom(clip.z, picture.width), firstPixelFrom(clip.w, picture.height)};
}

/// Of the pixel's centre, in 1/16 pixel.
std::int64_t centreOf(int pixel) { return kPerPixel * pixel + kPerPixel / 2; }

// --- Pixels --------------------------------------------------------------------------------------

unsigned coverAt(const GlyphAtlas& atlas, int column, int row) {
  return atlas.cover[static_cast<std::size_t>(row) * static_cast<std::size_t>(atlas.width) +
                     static_cast<std::size_t>(column)];
}

void blend(std::uint32_t& pixel, Rgba color, unsigned alpha) {
  const auto mixed = [alpha](unsigned below, unsigned above) {
    return static_cast<std::uint8_t>(per255(above * alpha + below * (255 - alpha)));
  };
  const Rgb below = fromXrgb(pixel);
  pixel = toXrgb({mixed(below.r, color.r), mixed(below.g, color.g), mixed(below.b, color.b)});
}

/// As `blend` does, two channels at once: a product of 16 bits has room for one of them, so red and
/// blue share a word. The highest byte of a pixel means nothing.
void blendRow(std::span<std::uint32_t> pixels, Rgba color, unsigned alpha) {
  if (alpha == 0) return;
  constexpr std::uint32_t kRedBlue = 0xFF00FF;
  const std::uint32_t half = 0x800080;
  const std::uint32_t aboveRedBlue = (std::uint32_t{color.r} << 16 | color.b) * alpha + half;
  const std::uint32_t aboveGreen = color.g * alpha + (half & 0xFF);
  const std::uint32_t rest = 255 - alpha;
  for (std::uint32_t& pixel : pixels) {
    const std::uint32_t redBlue = aboveRedBlue + (pixel & kRedBlue) * rest;
    const std::uint32_t green = aboveGreen + (pixel >> 8 & 0xFF) * rest;
    pixel = (redBlue + (redBlue >> 8 & kRedBlue)) >> 8 & kRedBlue;
    pixel |= (green + (green >> 8)) & 0xFF00;
  }
}

// --- Rectangles ----------------------------------------------------------------------------------

/// An upright rectangle of one colour, whose places on the atlas are upright, too.
struct Rectangle {
  Corner from;  ///< left and top
  Corner to;
};

/// The rectangle whose corners, in turn, these are; if they are those of one.
std::optional<Rectangle> rectangleOf(const std::array<Corner, 4>& c) {
  const bool isUpright = c[0].x == c[3].x && c[1].x == c[2].x && c[0].y == c[1].y &&
                         c[2].y == c[3].y && c[0].u == c[3].u && c[1].u == c[2].u &&
                         c[0].v == c[1].v && c[2].v == c[3].v;
  const bool isPlain =
      c[0].color == c[1].color && c[0].color == c[2].color && c[0].color == c[3].color;
  if (!isUpright || !isPlain || c[0].x >= c[2].x || c[0].y >= c[2].y) return std::nullopt;
  return Rectangle{c[0], c[2]};
}

/// The texel at a pixel's centre, on the way between two places.
int texelAt(int pixel, std::int64_t from, std::int64_t to, std::int64_t texelFrom,
            std::int64_t texelTo) {
  const std::int64_t at = centreOf(pixel);
  const std::int64_t sum = texelFrom * (to - at) + texelTo * (at - from);
  return static_cast<int>(sum / (to - from) / kPerTexel);
}

int firstCentreFrom(std::int64_t edge) {
  return static_cast<int>(ceilDiv(edge - kPerPixel / 2, kPerPixel));
}

void paintRectangle(const Rectangle& rectangle, const Area& clip, const GlyphAtlas& atlas,
                    std::vector<int>& texelColumns, const PixelRows& picture) {
  const Corner& from = rectangle.from;
  const Corner& to = rectangle.to;
  const int left = std::max(clip.left, firstCentreFrom(from.x));
  const int right = std::min(clip.right, firstCentreFrom(to.x));
  const int top = std::max(clip.top, firstCentreFrom(from.y));
  const int bottom = std::min(clip.bottom, firstCentreFrom(to.y));
  if (left >= right) return;
  const bool isPlain = from.u == to.u;
  texelColumns.clear();
  for (int x = left; x < (isPlain ? left + 1 : right); ++x)
    texelColumns.push_back(texelAt(x, from.x, to.x, from.u, to.u));
  for (int y = top; y < bottom; ++y) {
    const std::span row(picture.at(left, y), static_cast<std::size_t>(right - left));
    const int texelRow = texelAt(y, from.y, to.y, from.v, to.v);
    const auto alphaOf = [&](int column) {
      return per255(from.color.a * coverAt(atlas, column, texelRow));
    };
    if (isPlain)
      blendRow(row, from.color, alphaOf(texelColumns.front()));
    else
      for (std::size_t i = 0; i < row.size(); ++i)
        if (const unsigned alpha = alphaOf(texelColumns[i])) blend(row[i], from.color, alpha);
  }
}

// --- Triangles -----------------------------------------------------------------------------------

/// Twice the area of a triangle, positive if its corners lie clockwise in the picture.
std::int64_t doubleArea(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// From one corner to the next, clockwise.
struct TriangleEdge {
  const Corner& from;
  const Corner& to;

  bool isTopOrLeft() const { return to.y < from.y || (to.y == from.y && to.x > from.x); }

  /// Leaves of [begin, end) the pixels of a row whose centres are on the triangle's side.
  void cut(int row, int& begin, int& end) const {
    const std::int64_t step = kPerPixel * (to.y - from.y);
    const std::int64_t side =
        doubleArea(from, to, centreOf(0), centreOf(row)) - (isTopOrLeft() ? 0 : 1);
    // Inside is where side - step * x >= 0.
    if (step > 0)
      end = static_cast<int>(std::clamp<std::int64_t>(floorDiv(side, step) + 1, begin, end));
    else if (step < 0)
      begin = static_cast<int>(std::clamp<std::int64_t>(ceilDiv(-side, -step), begin, end));
    else if (side < 0)
      end = begin;
  }
};

/// Three corners, clockwise.
class Triangle {
 public:
  Triangle(const std::array<Corner, 3>& corners, std::int64_t area)
      : corners_(corners), area_(area) {}

  void paint(const Area& clip, const GlyphAtlas& atlas, const PixelRows& picture) const {
    const auto& [a, b, c] = corners_;
    const int top = std::max(clip.top, firstCentreFrom(std::min({a.y, b.y, c.y})));
    const int bottom = std::min(clip.bottom, firstCentreFrom(std::max({a.y, b.y, c.y})));
    for (int y = top; y < bottom; ++y) {
      int begin = clip.left;
      int end = clip.right;
      for (const TriangleEdge& edge : {TriangleEdge{a, b}, TriangleEdge{b, c}, TriangleEdge{c, a}})
        edge.cut(y, begin, end);
      for (int x = begin; x < end; ++x) paintPixel(x, y, atlas, picture);
    }
  }

 private:
  void paintPixel(int x, int y, const GlyphAtlas& atlas, const PixelRows& picture) const {
    const Corner& a = corners_[0];
    const Corner& b = corners_[1];
    const Corner& c = corners_[2];
    const std::array weights = {doubleArea(b, c, centreOf(x), centreOf(y)),
                                doubleArea(c, a, centreOf(x), centreOf(y)),
                                doubleArea(a, b, centreOf(x), centreOf(y))};
    const auto sum = [&](auto part) {
      return weights[0] * part(a) + weights[1] * part(b) + weights[2] * part(c);
    };
    const auto channel = [&](std::uint8_t Rgba::*part) {
      return static_cast<std::uint8_t>(
          (sum([part](const Corner& at) { return at.color.*part; }) + area_ / 2) / area_);
    };
    const auto column = sum([](const Corner& at) { return at.u; }) / area_ / kPerTexel;
    const auto row = sum([](const Corner& at) { return at.v; }) / area_ / kPerTexel;
    const Rgba color{channel(&Rgba::r), channel(&Rgba::g), channel(&Rgba::b), channel(&Rgba::a)};
    const unsigned cover = coverAt(atlas, static_cast<int>(column), static_cast<int>(row));
    blend(*picture.at(x, y), color, per255(color.a * cover));
  }

  std::array<Corner, 3> corners_;
  std::int64_t area_;  ///< twice
};

void paintTriangle(const Corner& a, const Corner& b, const Corner& c, const Area& clip,
                   const GlyphAtlas& atlas, const PixelRows& picture) {
  const std::int64_t area = doubleArea(a, b, c.x, c.y);
  if (area > 0) Triangle({a, b, c}, area).paint(clip, atlas, picture);
  if (area < 0) Triangle({a, c, b}, -area).paint(clip, atlas, picture);
}

// --- Lists ---------------------------------------------------------------------------------------

/// The triangles of one command, as far as its lists have them.
class Triangles {
 public:
  Triangles(const ImDrawList& list, const ImDrawCmd& command, const GlyphAtlas& atlas)
      : vertices_(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.Size)),
        firstVertex_(command.VtxOffset),
        atlas_(atlas) {
    const std::span indices(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size));
    const std::size_t begin = std::min<std::size_t>(command.IdxOffset, indices.size());
    indices_ =
        indices.subspan(begin, std::min<std::size_t>(command.ElemCount, indices.size() - begin));
  }

  std::size_t size() const { return indices_.size() / 3; }

  std::optional<Corner> corner(std::size_t triangle, std::size_t number) const {
    const std::size_t vertex = firstVertex_ + indices_[3 * triangle + number];
    if (vertex >= vertices_.size()) return std::nullopt;
    return cornerOf(vertices_[vertex], atlas_);
  }

  /// Of this triangle and the next, if they are the halves of one: 0 1 2 and 0 2 3.
  std::optional<Rectangle> rectangle(std::size_t triangle) const {
    if (triangle + 1 >= size()) return std::nullopt;
    const auto indices = indices_.subspan(3 * triangle, 6);
    if (indices[0] != indices[3] || indices[2] != indices[4]) return std::nullopt;
    const auto a = corner(triangle, 0);
    const auto b = corner(triangle, 1);
    const auto c = corner(triangle, 2);
    const auto d = corner(triangle + 1, 2);
    if (!a || !b || !c || !d) return std::nullopt;
    return rectangleOf({*a, *b, *c, *d});
  }

 private:
  std::span<const ImDrawVert> vertices_;
  std::span<const ImDrawIdx> indices_;
  std::size_t firstVertex_;
  const GlyphAtlas& atlas_;
};

}  // namespace

void TrianglePainter::paint(const ImDrawData& data, const GlyphAtlas& atlas,
                            const PixelRows& picture) {
  CHECK(atlas.width > 0 && atlas.width <= kMaxTexels, atlas.width);
  CHECK(atlas.height > 0 && atlas.height <= kMaxTexels, atlas.height);
  const auto paintCommand = [&](const Triangles& triangles, const Area& clip) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (const auto rectangle = triangles.rectangle(i)) {
        paintRectangle(*rectangle, clip, atlas, texelColumns_, picture);
        ++i;
        continue;
      }
      const auto a = triangles.corner(i, 0);
      const auto b = triangles.corner(i, 1);
      const auto c = triangles.corner(i, 2);
      if (a && b && c) paintTriangle(*a, *b, *c, clip, atlas, picture);
    }
  };
  for (const ImDrawList* list :
       std::span(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount)))
    for (const ImDrawCmd& command : list->CmdBuffer)
      if (!command.UserCallback)
        paintCommand(Triangles(*list, command, atlas), areaOf(command.ClipRect, picture));
}

}  // namespace hearth
