#include "hearth/text_image.h"

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

void fill(Image& image, Vertex from, Vertex to, Rgb color) {
  const int right = std::min(image.width(), static_cast<int>(to.x));
  const int bottom = std::min(image.height(), static_cast<int>(to.y));
  for (int y = std::max(0, static_cast<int>(from.y)); y < bottom; ++y)
    for (int x = std::max(0, static_cast<int>(from.x)); x < right; ++x) image.at(x, y) = color;
}

}  // namespace

int textWidth(std::string_view text) { return stb_easy_font_width(printable(text).data()); }

void drawText(Image& image, int x, int y, std::string_view text, Rgb color) {
  std::string letters = printable(text);
  std::vector<Vertex> vertices(letters.size() * kVerticesPerLetter);
  const int rectangles =
      stb_easy_font_print(static_cast<float>(x), static_cast<float>(y), letters.data(), nullptr,
                          vertices.data(), static_cast<int>(vertices.size() * sizeof(Vertex)));
  // The corners of each run around it from its left top one.
  for (std::size_t i = 0; i < static_cast<std::size_t>(rectangles); ++i)
    fill(image, vertices[4 * i], vertices[4 * i + 2], color);
}

}  // namespace hearth
