// How a span painter colours narrow faces: span by span, without a group for each face.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

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

  /// Copies numbers of these rows to the pixels of a lane, from `pixel` on.
  void put(const FaceRowPlaces::Rows& from, std::size_t pixel,
           PixelBlock::Pixels<std::uint32_t>& to) const {
    for (std::size_t row = 0; row < static_cast<std::size_t>(count); ++row)
      to[pixel + row * PixelBlock::kLanes] = from[row];
  }
  void put(const FaceRowPlaces::Mix& from, std::size_t pixel, PixelBlock::Mix& to) const {
    put(from.across, pixel, to.across);
    put(from.down, pixel, to.down);
  }
};

/// How two quantities with these gradients change along the rays of one column.
FaceColumn columnOf(const FaceFront& front, double slant, const FaceGradient& u, double uScale,
                    const FaceGradient& v, double vScale) {
  const auto along = [slant](Vec3 perMetre, double scale) {
    return Affine{scale * (perMetre.x + slant * perMetre.y), scale * perMetre.z};
  };
  return {along(front.nearness, 1), uScale * u.atEye, vScale * v.atEye, along(u.perMetre, uScale),
          along(v.perMetre, vScale)};
}

/// In each lane, the first span that is not painted to its end.
using SpanByLane = std::array<const FaceSpan*, Strip::kColumns>;

/// The spans of a group lie lane by lane.
SpanByLane firstByLane(const FaceGroup& group) {
  SpanByLane first;
  first.fill(group.spans.data() + group.spans.size());
  for (std::size_t i = group.spans.size(); i-- > 0;) first[group.spans[i].lane] = &group.spans[i];
  return first;
}

/// Calls `visit(span, column)` for the spans that have rows in a block, and leaves in `next` those
/// that end below it or lie there.
template <typename Visit>
void forEachSpanIn(const PixelBlock& block, const FaceGroup& group, SpanByLane& next,
                   Visit&& visit) {
  const FaceSpan* const end = group.spans.data() + group.spans.size();
  const int rowEnd = block.firstRow + block.rows;
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane)
    for (const FaceSpan*& span = next[lane]; span != end && span->lane == lane; ++span) {
      if (span->rowBegin >= rowEnd) break;
      if (end - span > kAhead) prefetch(*span[kAhead].front);
      visit(*span, group.firstColumn + static_cast<int>(lane));
      if (span->rowEnd > rowEnd) break;
    }
}

}  // namespace

void SpanPainter::paint(const FaceGroup& group, LightMode mode, PixelBlock& block, Strip& strip,
                        PaintStats& stats) const {
  const std::span<const FaceSpan> spans = group.spans;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const auto isAlike = [&](const FaceSpan& span) { return glowOf(span) == glowOf(spans[i]); };
    if (std::ranges::none_of(spans.first(i), isAlike))
      paintAlike(group, spans[i], mode, block, strip);
  }
  count(materialOf(group.mesh, spans.front().front->texture).shownIn(mode), spans.size(),
        group.pixels, stats);
}

void SpanPainter::paintAlike(const FaceGroup& group, const FaceSpan& first, LightMode mode,
                             PixelBlock& block, Strip& strip) const {
  const Material material = materialOf(group.mesh, first.front->texture).shownIn(mode);
  const bool areWhite = mode == LightMode::Only;
  const bool areMixed = settings_.textureFilter == TextureFilter::Bilinear && !areWhite;
  // Each face has an image of its own. Where no face is, the picture stays as it is.
  const GroupTexels texels{nullptr, areMixed, true, areWhite};
  const GroupLight light{material.lightmap, material.evenLight, false};
  const Vec3 glow = glowOf(first);
  block.columns = {{}, group.rowBegin, group.rowEnd};
  block.columns.rows.begin.fill(group.rowBegin);
  block.columns.rows.end.fill(group.rowEnd);
  SpanByLane next = firstByLane(group);
  forEachBlock(group, block, [&] {
    block.colors[0].fill(kHoleBit);
    if (light.varies()) block.lightTexels.fill(0);
    forEachSpanIn(block, group, next, [&](const FaceSpan& span, int column) {
      if (glowOf(span) != glow) return;
      colorFace(span, column, areMixed, block);
      if (light.varies()) lightFace(span, column, material, block);
    });
    if (areWhite)
      for (std::uint32_t& color : block.colors[0]) color |= color == kHoleBit ? 0 : 0xFFFFFF;
    kernels_.shade(block, texels, light, strip.row(block.firstRow));
  });
}

/// Gives those rows of a block their colours in which a face shows.
void SpanPainter::colorFace(const FaceSpan& span, int column, bool areMixed,
                            PixelBlock& block) const {
  const FaceRows rows(span, block);
  const FaceFront& front = *span.front;
  const Texture& image = imageOf(span);
  const FaceColumn face = columnOf(front, projection_.slantOf(column + 0.5), front.u, image.width(),
                                   front.v, image.height());
  FaceRowPlaces places;
  const auto find = areMixed ? kernels_.findFaceTexelsAround : kernels_.findFaceTexels;
  find(face, block.raySlopes + rows.begin, rows.count, image, places);
  const std::size_t pixel = rows.firstPixel(span);
  for (std::size_t i = 0; i < (areMixed ? 4 : 1); ++i)
    fetchColumn(image, places.texels[i].data(), rows.count, &block.colors[i][pixel]);
  if (areMixed) rows.put(places.mix, pixel, block.betweenTexels);
}

/// Gives the same rows their places on the lightmap.
void SpanPainter::lightFace(const FaceSpan& span, int column, const Material& material,
                            PixelBlock& block) const {
  const FaceRows rows(span, block);
  const FaceFront& front = *span.front;
  const auto& [a, b, c] = *placesOf(scene_.level(), material.lit.mesh, *front.face);
  const FaceCorners corners = cornersBefore(projection_, *front.face);
  const FaceColumn face =
      columnOf(front, projection_.slantOf(column + 0.5), gradientOf(corners, {}, {a.x, b.x, c.x}),
               1, gradientOf(corners, {}, {a.y, b.y, c.y}), 1);
  FaceRowPlaces places;
  kernels_.findFaceLight(face, block.raySlopes + rows.begin, rows.count, *material.lightmap,
                         settings_.lightFilter, places);
  const std::size_t pixel = rows.firstPixel(span);
  rows.put(places.texels[0], pixel, block.lightTexels);
  rows.put(places.mix, pixel, block.betweenLightTexels);
}

/// The size of a face's image that fits its pixels.
const Texture& SpanPainter::imageOf(const FaceSpan& span) const {
  const MipMap& texture = textures_[span.front->texture.index()];
  if (settings_.textureFilter != TextureFilter::Mipmapped) return texture.full();
  return texture.level(
      mipLevelOf(texelsOnFace(projection_, *span.front->face, texture.full(), span.depth)));
}

}  // namespace hearth
