// Frames with a model of many triangles, against a rasteriser of triangles.

#include <fmt/format.h>

#include <memory>

#include "image/compare.h"
#include "peers/frame_phases.h"
#include "peers/llvmpipe.h"
#include "peers/model_scene.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

constexpr int kModelFrames = 10;
/// Of the pixels, in which the two pictures may differ by more than 8 levels: llvmpipe computes in
/// single precision, and moves corners to a 256th of a pixel.
constexpr double kMayDiffer = 0.001;

/// Frames of a scene, each drawn by Hearth and then by llvmpipe.
class ModelFrames {
 public:
  ModelFrames(ModelScene scene, std::shared_ptr<Llvmpipe> peer)
      : scene_(std::move(scene)),
        peer_(std::move(peer)),
        projection_(projectionFor(scene_.level->loaded.scene(), scene_.camera)) {}

  /// The part of the pixels in which the two differ.
  double differing() {
    const Image own = scene_.level->renderer.draw(scene_.camera, LightMode::None);
    const Image other = imageOf(peer_->draw(projection_));
    return static_cast<double>(compare(own, other).over8) /
           static_cast<double>(own.pixels().size());
  }

  Figures measure(const Clock& clock) {
    draw(clock);  // caches that others have used are warm again
    ofHearth_.clear();
    ofPeer_.clear();
    for (int i = 0; i < kModelFrames; ++i) draw(clock);
    const double peer = spreadOf(ofPeer_).median;
    return {ofHearth_.frame() / peer, ofHearth_.frame(), peer, ofHearth_.find(), ofHearth_.color()};
  }

 private:
  void draw(const Clock& clock) {
    canvas_.draw(scene_.level->renderer, scene_.camera, nullptr, ofHearth_, clock);
    const double begin = clock();
    peer_->draw(projection_);
    ofPeer_.push_back(1e3 * (clock() - begin));
  }

  ModelScene scene_;
  std::shared_ptr<Llvmpipe> peer_;
  Projection projection_;
  Canvas canvas_{LightMode::None};
  PhaseTimes ofHearth_;
  std::vector<double> ofPeer_;  ///< milliseconds
};

}  // namespace

Prepared prepareModelFrame(PeerInputs& inputs) {
  auto scene = makeModelScene(inputs);
  if (!scene) return tl::unexpected(scene.error());
  const Camera& camera = scene->camera;
  auto peer =
      Llvmpipe::of(scene->faces, scene->level->loaded.textures, {camera.width, camera.height});
  if (!peer) return tl::unexpected(peer.error());
  const auto frames = std::make_shared<ModelFrames>(*std::move(scene), *std::move(peer));
  if (const double differing = frames->differing(); differing > kMayDiffer)
    return tl::unexpected(
        fmt::format("the two pictures differ in {:.2f} % of the pixels", 100 * differing));
  return [frames, &inputs] { return frames->measure(inputs.clock()); };
}

}  // namespace hearth
