#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "image/image.h"
#include "image/pixel_rows.h"
#include "level/mesh.h"
#include "render/camera.h"

struct osmesa_context;

namespace hearth {

/// Triangles in Mesa's software rasteriser llvmpipe, which draws them into memory on the calling
/// thread. It is loaded when the program runs: it need not be installed. One is in use at a time.
class Llvmpipe {
 public:
  /// Faces are seen from their fronts; those with one image are drawn together, in the order of
  /// the first of each. `images` are by TextureId. The error says that Mesa is missing, and what
  /// brings it.
  static tl::expected<std::shared_ptr<Llvmpipe>, std::string> of(std::span<const MeshFace> faces,
                                                                 const std::vector<Image>& images,
                                                                 ImageSize size);

  /// A frame as `projection` shows it, each pixel the nearest texel of the nearest face; done when
  /// its pixels are in memory. Valid until the next one.
  PixelRows draw(const Projection& projection);

 private:
  struct Functions;
  /// The triangles with one image.
  struct Batch {
    unsigned texture;
    unsigned vertices;  ///< buffer
    unsigned indices;   ///< buffer
    int count;          ///< of indices
  };

  Llvmpipe(std::shared_ptr<const Functions> gl, ImageSize size);
  bool start();
  void add(std::span<const MeshFace> faces, const Image& image, TextureId texture);

  std::shared_ptr<const Functions> gl_;
  ImageSize size_;
  std::vector<std::uint32_t> pixels_;
  std::shared_ptr<osmesa_context> context_;
  std::vector<Batch> batches_;
};

}  // namespace hearth
