#pragma once

#include <array>
#include <cstdint>

#include "light/lightmap.h"
#include "math/vec.h"
#include "render/draw_settings.h"
#include "render/group_mapping.h"
#include "render/pixel_block.h"
#include "render/texture.h"

namespace hearth {

/// The light of a group's pixels.
struct GroupLight {
  const Lightmap* lightmap;  ///< null if no light reaches the surface
  Vec3 evenLight;            ///< see Material
  /// Down a column all pixels are between the same two columns of the lightmap, as on walls.
  bool keepsColumns;

  /// Whether it differs from pixel to pixel.
  bool varies() const { return lightmap && !lightmap->isUniform(); }
};

/// The texels of a group's pixels.
struct GroupTexels {
  const Texture* image;  ///< from which they are read; null if none are, or of several
  bool areMixed;         ///< four for each pixel
  bool haveHoles;        ///< pixels whose colour has kHoleBit stay as they are
  bool areWhite;         ///< except holes; without holes no colour is read
};

/// The rays of a column, or some of its rows, on a narrow face: all are linear functions of the
/// slope of a ray.
struct FaceColumn {
  Affine nearness;  ///< 1 / depth
  // In texels of an image or a lightmap: at the eye, and what is added to that per metre of depth.
  double uAtEye;
  double vAtEye;
  Affine u;
  Affine v;
};

/// Where rows of a face lie on an image or a lightmap: as PixelBlock has it of its pixels. There is
/// room for a register more than a block has rows.
struct FaceRowPlaces {
  struct alignas(64) Rows : std::array<std::uint32_t, PixelBlock::kRows + PixelBlock::kLanes> {};

  std::array<Rows, 4> texels;  ///< the first ones alone where nothing is mixed, and of lightmaps
  struct Mix {
    Rows across;
    Rows down;
  } mix;
};

/// Loops over the pixels of a block, or over the rows of a face in one column, as many at once as
/// the registers of a processor hold. The results are the same to the bit on every processor.
struct PixelKernels {
  /// The parameters of the pixels.
  void (*findParameters)(PixelBlock& block, const GroupMapping& mapping);
  // The next two find texels in fixed point. They return false where that cannot tell them. Then
  // the others do, from the parameters.
  bool (*findLinearTexels)(PixelBlock& block, const GroupMapping& mapping, const Texture& image);
  bool (*findLinearLightTexels)(PixelBlock& block, const GroupMapping& mapping,
                                const Lightmap& lightmap, LightFilter filter);
  /// The texels that the pixels fall into.
  void (*findTexels)(PixelBlock& block, const GroupMapping& mapping, const Texture& image);
  /// The four texels around the pixels.
  void (*findTexelsAround)(PixelBlock& block, const GroupMapping& mapping, const Texture& image);
  /// Those of a lightmap that is not uniform.
  void (*findLightTexels)(PixelBlock& block, const GroupMapping& mapping, const Lightmap& lightmap,
                          LightFilter filter);
  // The same three of rows of a face.
  void (*findFaceTexels)(const FaceColumn& column, const double* raySlopes, int rows,
                         const Texture& image, FaceRowPlaces& places);
  void (*findFaceTexelsAround)(const FaceColumn& column, const double* raySlopes, int rows,
                               const Texture& image, FaceRowPlaces& places);
  void (*findFaceLight)(const FaceColumn& column, const double* raySlopes, int rows,
                        const Lightmap& lightmap, LightFilter filter, FaceRowPlaces& places);
  /// Writes the pixels of the rows, of which each has eight.
  void (*shade)(const PixelBlock& block, const GroupTexels& texels, const GroupLight& light,
                std::uint32_t* rows);
};

/// The kernels for the widest registers that this processor has.
const PixelKernels& pixelKernels();

}  // namespace hearth
