#pragma once

#include <functional>
#include <vector>

#include "image/image.h"
#include "load/load.h"
#include "render/camera.h"
#include "settings/options.h"

namespace hearth {

/// The picture of a camera without any approximation.
struct TruthPicture {
  Camera camera;
  Image picture;
  std::vector<Vec3> light;  ///< in levels 0..255, of the pixels row by row, as `--light only` shows
};

/// The points of a ball of light that every pixel tests: the error is a level or so, at a hundredth
/// of the time of more exact pictures.
inline constexpr int kTruthBallPoints = 256;

/// The pictures of all shots of a level, in order. `done(i)` is called after each.
std::vector<TruthPicture> truthOf(const LoadedLevel& loaded, ImageSize size, int threads,
                                  const std::function<void(std::size_t)>& done);

}  // namespace hearth
