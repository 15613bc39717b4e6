#include "measure/tradeoff/truth_pictures.h"

#include "math/parallel.h"
#include "truth/truth_view.h"

namespace hearth {

namespace {

TruthPicture truthOf(const LoadedLevel& loaded, const Shot& shot, int threads) {
  const TruthView view(loaded.level, loaded.textures, shot, kTruthBallPoints);
  TruthPicture truth{cameraOf(shot), Image(shot.width, shot.height), {}};
  truth.light.resize(truth.picture.pixels().size());
  parallelFor(static_cast<std::size_t>(shot.height), threads, [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < shot.width; ++i) {
      const TruthPixel pixel = view.pixel(i + 0.5, j + 0.5, TruthLightMode::Both);
      truth.picture.at(i, j) = pixel.color;
      truth.light[row * static_cast<std::size_t>(shot.width) + static_cast<std::size_t>(i)] =
          255 * pixel.light;
    }
  });
  return truth;
}

}  // namespace

std::vector<TruthPicture> truthOf(const LoadedLevel& loaded, ImageSize size, int threads,
                                  const std::function<void(std::size_t)>& done) {
  std::vector<TruthPicture> pictures;
  for (Shot shot : loaded.level.shots) {
    shot.width = size.width;
    shot.height = size.height;
    pictures.push_back(truthOf(loaded, shot, threads));
    done(pictures.size());
  }
  return pictures;
}

}  // namespace hearth
