// How a span painter colours narrow faces: span by span, without a group for each face.

#include <algorithm>
#include <array>
#include <cstddef>

#include "render/face_mapping.h"
#include "render/footprint.h"
#include "render/span_painter.h"
#include "render/texel_fetch.h"

namespace hearth {

namespace {

/// So many narrow faces ahead, what one shows is fetched.
constexpr std::ptrdiff_t kAhead = 4;

void prefetch(const FaceFront& front) {
  __builtin_prefetch(&front.nearness);
  __builtin_prefetch(&front.v);
}

/// Those rows of a block in which a face shows.
struct FaceRows {
  int begin;
  int count;

  FaceRows(const FaceSpan& span, const PixelBlock& block)
      : begin(std::max(0, span.rowBegin - block.firstRow)),
        count(std::min(block.rows, span.rowEnd - block.firstRow) - begin) {}

  std::size_t firstPixel(const FaceSpan& span) const {
    return static_cast<std::size_t>(begin) * PixelBlock::kLanes + span.lane;
  }
};

/// The rays of a column on a face, along which two numbers change that are so much at the eye.
FaceColumn columnOf(const FaceFront& front, double slant, const FaceGradient& u, double uScale,
                    const FaceGradient& v, double vScale) {
  const auto along = [slant](Vec3 perMetre, double scale) {
    return Affine{scale * (perMetre.x + slant * perMetre.y), scale * perMetre.z};
  };
  return {along(front.nearness, 1), uScale * u.atEye, vScale * v.atEye, along(u.perMetre, uScale),
          along(v.perMetre, vScale)};
}

}  // namespace

void SpanPainter::paintFaces(const SpanGroup& group, LightMode mode, PixelBlock& block,
                             Strip& strip, PaintStats& stats) const {
  if (settings_.textureFilter == TextureFilter::Bilinear)
    return paintSingly(group, mode, block, strip, stats);
  Material material = materialOf(group.surface, group.faces.front().front->texture);
  if (mode == LightMode::None) {
    material.lightmap = nullptr;
    material.sectorLight = 1;
  }
  const bool hasLight = material.hasVaryingLight();
  // Where no face is, the picture stays as it is.
  const GroupTexels texels{&textures_.front().full(), false, true, mode == LightMode::Only};
  std::array<const FaceSpan*, Strip::kColumns + 1> next;  // by lane
  next.fill(group.faces.data() + group.faces.size());
  for (std::size_t i = group.faces.size(); i-- > 0;) next[group.faces[i].lane] = &group.faces[i];
  block.columns.rows.begin.fill(group.rowBegin);
  block.columns.rows.end.fill(group.rowEnd);
  for (int row = group.rowBegin; row < group.rowEnd; row += block.rows) {
    block.firstRow = row;
    block.rows = std::min(PixelBlock::kRows, group.rowEnd - row);
    block.raySlopes = &raySlopes_[static_cast<std::size_t>(row)];
    block.colors[0].fill(kHoleBit);
    if (hasLight) block.lightTexels.fill(0);
    for (std::size_t lane = 0; lane < Strip::kColumns; ++lane) {
      const FaceSpan* const end = group.faces.data() + group.faces.size();
      for (const FaceSpan*& span = next[lane]; span != end && span->lane == lane; ++span) {
        if (span->rowBegin >= row + block.rows) break;
        if (end - span > kAhead) prefetch(*span[kAhead].front);
        const int column = group.firstColumn + static_cast<int>(lane);
        colorFace(*span, column, block);
        if (hasLight) lightFace(*span, column, *material.lit.mesh, *material.lightmap, block);
        if (span->rowEnd > row + block.rows) break;
      }
    }
    if (texels.areWhite)
      for (std::uint32_t& color : block.colors[0]) color |= color == kHoleBit ? 0 : 0xFFFFFF;
    kernels_.shade(block, texels, {material.lightmap, material.sectorLight, false}, strip.row(row));
  }
  for (const FaceSpan& span : group.faces) {
    const auto pixels = static_cast<std::size_t>(span.rowEnd - span.rowBegin);
    stats.pixels += pixels;
    if (!hasLight) continue;
    ++stats.lightmapSpans;
    if (material.lightmap->channels == 3) ++stats.coloredSpans;
    stats.lightmapPixels += pixels;
  }
}

/// Gives those rows of a block their colours in which a face shows.
void SpanPainter::colorFace(const FaceSpan& span, int column, PixelBlock& block) const {
  const FaceRows rows(span, block);
  const FaceFront& front = *span.front;
  const Texture& image = imageOf(span);
  const FaceColumn face = columnOf(front, projection_.slantOf(column + 0.5), front.u, image.width(),
                                   front.v, image.height());
  alignas(64) std::array<std::uint32_t, PixelBlock::kRows + PixelBlock::kLanes> texels;
  kernels_.findFaceTexels(face, block.raySlopes + rows.begin, rows.count, image, texels.data());
  fetchColumn(image, texels.data(), rows.count, &block.colors[0][rows.firstPixel(span)]);
}

/// Gives the same rows their places on the lightmap.
void SpanPainter::lightFace(const FaceSpan& span, int column, const LitMesh& mesh,
                            const Lightmap& lightmap, PixelBlock& block) const {
  const FaceRows rows(span, block);
  const FaceFront& front = *span.front;
  const auto& [a, b, c] = *placesOf(scene_.level(), &mesh, *front.face);
  const FaceCorners corners = cornersBefore(projection_, *front.face);
  const FaceColumn face =
      columnOf(front, projection_.slantOf(column + 0.5), gradientOf(corners, {}, {a.x, b.x, c.x}),
               1, gradientOf(corners, {}, {a.y, b.y, c.y}), 1);
  FaceLightPlaces places;
  kernels_.findFaceLight(face, block.raySlopes + rows.begin, rows.count, lightmap,
                         settings_.lightFilter, places);
  std::size_t pixel = rows.firstPixel(span);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows.count); ++row) {
    block.lightTexels[pixel] = places.texels[row];
    block.betweenLightTexels.across[pixel] = places.across[row];
    block.betweenLightTexels.down[pixel] = places.down[row];
    pixel += PixelBlock::kLanes;
  }
}

/// The size of a face's image that fits its pixels.
const Texture& SpanPainter::imageOf(const FaceSpan& span) const {
  const MipMap& texture = textures_[span.front->texture.index()];
  if (settings_.textureFilter != TextureFilter::Mipmapped) return texture.full();
  const double texels = repeatsOfPixel(projection_, *span.front->face) * texture.full().width() *
                        texture.full().height() * span.depth * span.depth * span.depth;
  return texture.level(mipLevelOf(texels));
}

/// Span by span, as if each were of a wide face.
void SpanPainter::paintSingly(const SpanGroup& group, LightMode mode, PixelBlock& block,
                              Strip& strip, PaintStats& stats) const {
  SpanGroup single = group;
  single.faces = {};
  for (const FaceSpan& span : group.faces) {
    single.face = span.front->face;
    single.lanes = static_cast<LaneSet>(1U << span.lane);
    single.rowBegin = span.rowBegin;
    single.rowEnd = span.rowEnd;
    single.rows = {};
    single.rows.begin[span.lane] = span.rowBegin;
    single.rows.end[span.lane] = span.rowEnd;
    single.depth.fill(span.depth);
    paint(single, mode, block, strip, stats);
  }
}

}  // namespace hearth
