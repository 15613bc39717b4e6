#include "viewer/overlay/captions.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "text/drawn_text.h"

namespace hearth {

namespace {

constexpr Rgb kNameColor = {255, 208, 112};
constexpr Rgb kTextColor = {255, 255, 255};

// In pixels of letters.
constexpr int kLine = kTextHeight + 1;
constexpr int kMargin = 4;
constexpr int kLineGap = 10;

/// Width or height of a picture, in pixels, for each step of the scale.
constexpr int kWidthPerScale = 480;
constexpr int kPixelsPerScale = 300;

struct KeyListSize {
  int names = 0;  ///< pixels of letters
  int help = 0;
  int line = 0;
  int height = 0;
};

/// Lines are closer where a picture has no room for all of them: all keys fit into 320x200.
KeyListSize keyListSize(std::span<const KeyListRow> rows, int room) {
  const auto count = static_cast<int>(rows.size());
  KeyListSize size;
  size.line = std::clamp((room - 2 * kMargin - 2) / count, kTextHeight, kLine);
  size.height = count * size.line;
  for (const KeyListRow& row : rows) {
    size.names = std::max(size.names, textWidth(row.names));
    size.help = std::max(size.help, textWidth(row.help));
  }
  return size;
}

/// In lines of so many pixels of letters, between words where that is possible.
std::vector<std::string> brokenAt(std::string_view text, int width) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::size_t fits = text.size();
    while (fits > 1 && textWidth(text.substr(0, fits)) > width) --fits;
    if (fits < text.size())
      if (const std::size_t blank = text.rfind(' ', fits); blank != std::string_view::npos && blank)
        fits = blank;
    lines.emplace_back(text.substr(0, fits));
    text.remove_prefix(fits);
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  return lines;
}

}  // namespace

int captionScale(const PixelRows& picture) {
  return std::max(1, std::min(picture.width / kWidthPerScale, picture.height / kPixelsPerScale));
}

void darken(const PixelRows& picture, int left, int top, int right, int bottom) {
  for (int y = std::max(0, top); y < std::min(picture.height, bottom); ++y)
    for (int x = std::max(0, left); x < std::min(picture.width, right); ++x) {
      std::uint32_t& pixel = *picture.at(x, y);
      pixel = pixel >> 2 & 0x3F3F3F;  // a quarter of each channel
    }
}

void drawKeys(const PixelRows& picture, std::span<const KeyListRow> rows) {
  const int scale = captionScale(picture);
  const KeyListSize size = keyListSize(rows, picture.height / scale);
  const int width = scale * (size.names + kLineGap + size.help);
  const int left = std::max(0, (picture.width - width) / 2);
  int y = std::max(0, (picture.height - scale * size.height) / 2);
  const int margin = scale * kMargin;
  darken(picture, left - margin, y - margin, left + width + margin,
         y + scale * size.height + margin);
  for (const KeyListRow& row : rows) {
    drawText(picture, left, y, row.names, kNameColor, scale);
    drawText(picture, left + scale * (size.names + kLineGap), y, row.help, kTextColor, scale);
    y += scale * size.line;
  }
}

void drawNotes(const PixelRows& picture, std::span<const std::string> notes, int width) {
  const int scale = captionScale(picture);
  const int margin = scale * kMargin;
  std::vector<std::string> lines;
  for (const std::string& note : notes) {
    const std::vector<std::string> broken = brokenAt(note, (width - 2 * margin) / scale);
    lines.insert(lines.end(), broken.begin(), broken.end());
  }
  const int most = std::max(1, (picture.height / 2 - 2 * margin) / (scale * kLine));
  if (std::ssize(lines) > most) lines.resize(static_cast<std::size_t>(most));
  darken(picture, 0, 0, width, static_cast<int>(lines.size()) * scale * kLine + 2 * margin);
  int y = margin;
  for (const std::string& line : lines) {
    drawText(picture, margin, y, line, kTextColor, scale);
    y += scale * kLine;
  }
}

void drawMessage(const PixelRows& picture, std::string_view text) {
  const int scale = captionScale(picture);
  const int margin = scale * kMargin;
  const int top = picture.height - scale * kLine - margin;
  darken(picture, 0, top - margin, margin + scale * textWidth(text) + margin, picture.height);
  drawText(picture, margin, top, text, kTextColor, scale);
}

}  // namespace hearth
