#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/texture.h"

/// How fast spans could be coloured if nothing had to be worked out: a loop that only reads texels
/// and light, mixes, multiplies and writes, in single precision.
namespace hearth {

/// A coordinate that changes evenly with the parameter of a row.
struct KernelAxis {
  float start = 0;
  float step = 0;
};

enum class KernelLight {
  Even,     ///< the same in all rows
  Upright,  ///< between two columns of a lightmap, and no more of its rows than kernelLanes()
  Plane,    ///< anywhere on a lightmap
};

/// Rows of one column that show one surface, with all of their geometry. Coordinates are in texels,
/// those of the lightmap from the middle of its first one, and never less than 0.
struct KernelSpan {
  std::size_t column;  ///< of the picture
  std::size_t rowBegin;
  std::size_t rowEnd;
  const float* parameters;  ///< of its rows, rising or falling; as many more as lanes can be read
  KernelAxis u;             ///< of the image, which repeats
  KernelAxis v;
  const Pixel* texels;  ///< column by column
  std::uint32_t uMask;  ///< sizes less 1: these are powers of two
  std::uint32_t vMask;
  int vBits;
  KernelLight kind;
  KernelAxis s;  ///< of what is upright the start alone
  KernelAxis t;
  const Pixel* light;      ///< red, green and blue, row by row
  std::size_t lightWidth;  ///< texels of a row
  std::size_t lightRows;   ///< of what is upright: how many are needed
  float sectorLight;       ///< 0..1
  float shown[3];          ///< of even light: the fractions of red, green and blue that show
};

/// A frame that can be drawn again and again.
struct KernelFrame {
  static constexpr std::size_t kColumns = 16;  ///< of a strip: a line of the cache

  std::size_t width;   ///< a multiple of kColumns
  std::size_t height;  ///< of 4
  /// By column, in it from top to bottom, so that what is written behind the last row of one is
  /// overwritten by the next.
  std::vector<KernelSpan> spans;
  std::vector<std::size_t> stripBegin;  ///< of strip i are [stripBegin[i], stripBegin[i + 1])
};

/// Rows that are drawn at once: lanes of the widest registers of this processor.
std::size_t kernelLanes();

/// Draws strip by strip into `strip`, and turns each into the picture, row by row.
void drawKernelFrame(const KernelFrame& frame, std::vector<Pixel>& strip,
                     std::vector<Pixel>& picture);

}  // namespace hearth
