#pragma once

#include <string>
#include <vector>

#include "image/image.h"
#include "wad_builder.h"

namespace hearth::doom {

/// A stretch of a column: the byte for its row, and its pixels.
struct Post {
  int row;
  std::vector<int> pixels;
};

inline std::string columnOf(const std::vector<Post>& posts) {
  constexpr int kUnused = 77;
  LumpBuilder column;
  for (const Post& post : posts) {
    column.bytes({post.row, static_cast<int>(post.pixels.size()), kUnused});
    for (const int pixel : post.pixels) column.bytes({pixel});
    column.bytes({kUnused});
  }
  return column.bytes({255}).content();
}

/// Where a patch says that its thing stands.
struct Origin {
  int left = 5;
  int top = 6;
};

/// A patch of these columns.
inline std::string patchOf(int height, const std::vector<std::vector<Post>>& columns,
                           Origin origin = {}) {
  LumpBuilder patch;
  patch.int16(static_cast<int>(columns.size())).int16(height);
  patch.int16(origin.left).int16(origin.top);
  LumpBuilder posts;
  for (const auto& column : columns) {
    patch.int32(static_cast<std::int64_t>(8 + 4 * columns.size() + posts.size()));
    posts.append(columnOf(column));
  }
  return patch.append(posts.content()).content();
}

/// A patch without holes, all of one colour.
inline std::string plainPatch(int width, int height, int color, Origin origin = {}) {
  const std::vector<Post> column = {{0, std::vector<int>(static_cast<std::size_t>(height), color)}};
  return patchOf(height, std::vector<std::vector<Post>>(static_cast<std::size_t>(width), column),
                 origin);
}

/// The colour that the tests' palettes have in place `i`: no two are equal, nor any two channels.
inline Rgb colorOf(int i) {
  return {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i + 85),
          static_cast<std::uint8_t>(i + 170)};
}

}  // namespace hearth::doom
