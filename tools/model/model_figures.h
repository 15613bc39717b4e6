#pragma once

#include <cstddef>

#include "math/box3.h"

namespace hearth {

/// What a model holds.
struct ModelFigures {
  std::size_t vertices = 0;   ///< of its file
  std::size_t faces = 0;      ///< polygons of its file
  std::size_t triangles = 0;  ///< that these become; those without area are left out
  std::size_t materials = 0;  ///< that faces wear
  std::size_t images = 0;     ///< of the materials, each once
  Box3 box;                   ///< of its triangles, in metres, in the axes of a level

  friend bool operator==(const ModelFigures&, const ModelFigures&) = default;
};

}  // namespace hearth
