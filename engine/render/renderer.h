#pragma once

#include <vector>

#include "image/image.h"
#include "image/pixel_rows.h"
#include "level/scene.h"
#include "level/sprite_index.h"
#include "light/bakery.h"
#include "math/parallel.h"
#include "render/camera.h"
#include "render/channel.h"
#include "render/draw_settings.h"
#include "render/frame_scratch.h"
#include "render/glow.h"
#include "render/texture.h"

namespace hearth {

/// The colour of a pixel that nothing covers. No enclosed level shows it.
inline constexpr Rgb kHole = {255, 0, 255};

/// Draws a level. Holds no state between frames: many cameras can share one renderer.
class Renderer {
 public:
  /// The scene's level and geometry, and the light, must outlive the renderer. `textures` are made
  /// for the texture filter of the settings.
  Renderer(const Scene& scene, DrawnTextures textures, const BakedLight& light,
           DrawSettings settings);
  /// Makes textures of its own from images, by TextureId.
  Renderer(const Scene& scene, const std::vector<Image>& images, const BakedLight& light,
           DrawSettings settings = {});

  const DrawSettings& settings() const { return settings_; }
  const BakedLight& light() const { return light_; }
  const DrawnTextures& textures() const { return textures_; }
  const Texture& texture(TextureId id) const { return (*textures_)[id.index()].full(); }

  /// The camera's eye is in its sector, within kPositionSlack. `picture` has the camera's size. The
  /// calling thread draws, together with the workers if there are any; the pixels are the same.
  /// Channels and marks are drawn with all pixels, whatever the settings.
  void draw(const Camera& camera, LightMode mode, FrameScratch& scratch, const PixelRows& picture,
            Workers* workers = nullptr) const;
  void draw(const Camera& camera, Channel channel, FrameScratch& scratch, const PixelRows& picture,
            Workers* workers = nullptr) const;
  void draw(const Camera& camera, Marks marks, FrameScratch& scratch, const PixelRows& picture,
            Workers* workers = nullptr) const;
  /// The two phases of a frame, to be timed apart. The first puts spans into the scratch; the
  /// second paints them, for the same camera.
  void findSpans(const Camera& camera, FrameScratch& scratch, Workers* workers = nullptr) const;
  void paintSpans(const Camera& camera, LightMode mode, FrameScratch& scratch,
                  const PixelRows& picture, Workers* workers = nullptr) const;
  /// Single pictures, for files.
  Image draw(const Camera& camera, LightMode mode) const;
  Image draw(const Camera& camera, Channel channel, Workers* workers = nullptr) const;
  Image draw(const Camera& camera, Marks marks, Workers* workers = nullptr) const;

 private:
  /// The first phase of a frame of squares of pixels.
  void findSpans(const Camera& camera, int pixelSize, FrameScratch& scratch,
                 Workers* workers) const;

  Scene scene_;
  SpriteIndex sprites_;
  DrawnTextures textures_;
  const BakedLight& light_;
  Glow glow_;
  DrawSettings settings_;
};

/// The projection of a camera whose eye is moved off the walls that it may touch.
Projection projectionFor(const Scene& scene, const Camera& camera, int pixelSize = 1);

/// The camera with one pixel for each square of pixels of another.
Camera inSquares(Camera camera, int pixelSize);

}  // namespace hearth
