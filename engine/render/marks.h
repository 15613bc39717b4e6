#pragma once

#include <span>

#include "image/pixel_rows.h"
#include "level/scene.h"
#include "render/camera.h"
#include "render/segment_columns.h"
#include "render/shown_columns.h"
#include "render/strip.h"

/// Marks the pixels of a column by what they show.
namespace hearth {

void mark(const Scene& scene, const ShownColumns<ShownTexel>& shown, Strip& strip, int column);
void mark(const Scene& scene, const ShownColumns<ShownSurface>& shown, Strip& strip, int column);
void mark(const Scene& scene, const ShownColumns<ShownTimes>& shown, Strip& strip, int column);

/// Pixels that dots reach beside their middle: they are squares of 3 x 3.
inline constexpr int kDotRadius = 1;

/// Dots the corners of the faces that a column shows, where these show at a corner's pixel or
/// beside it: those parts of the dots that lie in `columns` of the picture.
void markVertices(const Projection& projection, std::span<const ShownFace> shown, int column,
                  ColumnRange columns, const PixelRows& picture);

}  // namespace hearth
