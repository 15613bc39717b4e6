#pragma once

namespace hearth {

/// Whether a picture shows textures, light or both.
enum class LightMode {
  Both,
  None,  ///< the texture's colour alone
  Only,  ///< the light in place of the texture; sky is white
};

enum class TextureFilter {
  Nearest,    ///< the texel that the pixel's centre falls into
  Bilinear,   ///< a mixture of the four texels around it
  Mipmapped,  ///< the nearest texel of a smaller version, if texels would be smaller than pixels
};

enum class LightFilter {
  Nearest,   ///< the texel of the lightmap that the pixel's centre falls into
  Bilinear,  ///< a mixture of the four texels around it
};

/// What frames may approximate, or smooth. Only larger pixels make them faster. By default frames
/// are as levels/README.md says.
struct DrawSettings {
  TextureFilter textureFilter = TextureFilter::Nearest;
  LightFilter lightFilter = LightFilter::Bilinear;
  /// Squares of so many pixels a side show what their centre sees. At least 1.
  int pixelSize = 1;

  friend bool operator==(const DrawSettings&, const DrawSettings&) = default;
};

}  // namespace hearth
