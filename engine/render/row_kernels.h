#pragma once

#include "light/lightmap.h"
#include "render/draw_settings.h"
#include "render/row_batch.h"
#include "render/span_mapping.h"
#include "render/texture.h"

namespace hearth {

/// What is done with batches of rows, as many rows at once as the registers of a processor hold.
/// Whatever the processor, the results are the same to the bit.
struct RowKernels {
  /// The depths on a plane at ray slopes, as parameters. As many ray slopes can be read as
  /// parameters.
  void (*findDepths)(RowBatch& batch, const SpanMapping& mapping, const double* raySlopes);
  /// The texels of the image that the rows fall into.
  void (*findTexels)(RowBatch& batch, const SpanMapping& mapping, const Texture& image);
  /// The four texels of the image around the rows.
  void (*findTexelsAround)(RowBatch& batch, const SpanMapping& mapping, const Texture& image);
  /// Those of the lightmap, which is not even, of a plane.
  void (*findLightTexels)(RowBatch& batch, const SpanMapping& mapping, const Lightmap& lightmap,
                          LightFilter filter);
  /// The same of what is upright, where they lie in two columns of the lightmap.
  void (*findLightRows)(RowBatch& batch, const SpanMapping& mapping, const Lightmap& lightmap,
                        LightFilter filter);

  /// What is shown in the light of these, on planes and on what is upright.
  void (*findShown)(RowBatch& batch, const Lightmap& lightmap, double sectorLight);
  void (*findShownUpright)(RowBatch& batch, const Lightmap& lightmap, double sectorLight);
  /// What is shown in the same light in all rows; of a lightmap that is even, or null.
  void (*showEvenly)(RowBatch& batch, const Lightmap* lightmap, double sectorLight);

  /// These write the pixels of the rows, which lie one behind the other: what is shown of a colour,
  /// of the texels, and of mixtures of the four.
  void (*shadeColor)(Pixel* pixels, const RowBatch& batch, Rgb color);
  void (*shadeTexels)(Pixel* pixels, const RowBatch& batch, const Texture& image);
  void (*shadeMixtures)(Pixel* pixels, const RowBatch& batch, const Texture& image);
};

/// Those for the widest registers that this processor has.
const RowKernels& rowKernels();

}  // namespace hearth
