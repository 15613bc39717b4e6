#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "image/image.h"
#include "import/doom/findings.h"
#include "import/doom/materials.h"
#include "import/doom/patch.h"
#include "import/doom/pictures.h"
#include "import/doom/sprite_lumps.h"
#include "import/doom/thing_types.h"

namespace hearth::doom {

/// The smallest picture that holds several images, each with its origin in the same place: the
/// pixels from the origin to each of its edges.
struct SpriteCanvas {
  int left = 0;    ///< to the left
  int right = 0;   ///< to the right
  int top = 0;     ///< up
  int bottom = 0;  ///< up, too: negative if the picture reaches below the origin

  ImageSize size() const { return {left + right, top - bottom}; }
};

/// What all things of one type look like.
struct SpriteLook {
  /// The files of each frame: one, or one for each side, in the order of levels.
  std::vector<std::vector<std::string>> frames;
  double framesPerSecond = 0;
  bool isBright = false;
  SpriteCanvas canvas;  ///< of every file

  bool hasSides() const;
  std::size_t countImages() const;
};

/// Makes the images of sprites.
class Sprites {
 public:
  /// The images become part of `materials`.
  Sprites(const Pictures& pictures, Materials& materials, Findings& findings)
      : pictures_(pictures), materials_(materials), findings_(findings) {}

  /// The images of a type have one size, so that one size and one offset serve every frame from
  /// every side. The error is one sentence that names the sprite.
  tl::expected<SpriteLook, std::string> lookOf(const ThingType& type);

 private:
  struct View {
    std::string file;
    SpriteSide side;
    PatchHeader header;
  };
  using Views = std::vector<View>;

  tl::expected<Views, std::string> viewsOf(const std::string& frame) const;
  tl::expected<void, std::string> drawAll(const Views& views, const SpriteCanvas& canvas);
  Image draw(const View& view, const SpriteCanvas& canvas);

  const Pictures& pictures_;
  Materials& materials_;
  Findings& findings_;
};

}  // namespace hearth::doom
