#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "image/image.h"

namespace hearth {

/// A few columns of a picture while they are drawn: so few that the processor's first cache holds
/// them (8 columns of 1080 rows are 26 KB), row by row like the picture that they are copied to.
class Strip {
 public:
  static constexpr int kColumns = 8;

  /// How many strips a picture has.
  static int countIn(int width) { return (width + kColumns - 1) / kColumns; }

  /// Begins a strip of a picture, with all pixels of one colour. It keeps its memory.
  void begin(int index, int height, Rgb color) {
    firstColumn_ = index * kColumns;
    pixels_.assign(static_cast<std::size_t>(height) * kColumns, color);
  }

  /// A pixel by its place in the picture; the one below it is kColumns further on.
  Rgb* at(int column, int row) {
    return &pixels_[static_cast<std::size_t>(row) * kColumns +
                    static_cast<std::size_t>(column - firstColumn_)];
  }

  void copyTo(Image& picture) const {
    const int columns = std::min(kColumns, picture.width() - firstColumn_);
    for (int row = 0; row < picture.height(); ++row)
      std::copy_n(&pixels_[static_cast<std::size_t>(row) * kColumns], columns,
                  &picture.at(firstColumn_, row));
  }

 private:
  int firstColumn_ = 0;
  std::vector<Rgb> pixels_;
};

}  // namespace hearth
