#pragma once

#include <functional>
#include <vector>

#include "image/image.h"
#include "load/load.h"
#include "render/camera.h"
#include "settings/options.h"

namespace hearth {

/// What a camera would see if nothing were approximated.
struct TruthPicture {
  Camera camera;
  Image picture;
  std::vector<Vec3> light;  ///< in levels 0..255, of the pixels row by row, as `--light only` shows
};

/// Of a ball of light so many points are looked at from every pixel: it shows as much of itself
/// within a level or so, at a hundredth of the time that more exact pictures take.
inline constexpr int kTruthBallPoints = 256;

/// Of all shots of a level, in their order. `done(i)` is called after each.
std::vector<TruthPicture> truthOf(const LoadedLevel& loaded, PictureSize size, int threads,
                                  const std::function<void(std::size_t)>& done);

}  // namespace hearth
