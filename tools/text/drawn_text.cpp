#include "text/drawn_text.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace hearth {

namespace {

/// A corner of one of the rectangles that letters are made of, as stb writes it.
struct Vertex {
  float x;
  float y;
  float z;
  std::array<unsigned char, 4> color;
};

constexpr std::size_t kVerticesPerLetter = 120;  // no letter has 30 rectangles

std::string printable(std::string_view text) {
  std::string ascii(text);
  std::ranges::replace_if(
      ascii, [](char c) { return c < ' ' || c > '~'; }, '?');
  return ascii;
}

void fill(const PixelRows& picture, int left, int top, int right, int bottom, Rgb color) {
  left = std::max(0, left);
  right = std::min(picture.width, right);
  if (left >= right) return;
  for (int y = std::max(0, top); y < std::min(picture.height, bottom); ++y)
    std::fill(picture.at(left, y), picture.at(right, y), toXrgb(color));
}

}  // namespace

int textWidth(std::string_view text) { return stb_easy_font_width(printable(text).data()); }

void drawText(const PixelRows& picture, int x, int y, std::string_view text, Rgb color, int scale) {
  std::string letters = printable(text);
  std::vector<Vertex> vertices(letters.size() * kVerticesPerLetter);
  const int rectangles = stb_easy_font_print(0, 0, letters.data(), nullptr, vertices.data(),
                                             static_cast<int>(vertices.size() * sizeof(Vertex)));
  const auto scaled = [scale](float pixels) { return scale * static_cast<int>(pixels); };
  // The corners of each run around it from its left top one.
  for (std::size_t i = 0; i < static_cast<std::size_t>(rectangles); ++i) {
    const Vertex& from = vertices[4 * i];
    const Vertex& to = vertices[4 * i + 2];
    fill(picture, x + scaled(from.x), y + scaled(from.y), x + scaled(to.x), y + scaled(to.y),
         color);
  }
}

}  // namespace hearth
