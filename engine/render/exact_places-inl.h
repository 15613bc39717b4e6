// Where the pixels of a block lie on images and lightmaps, each computed in double precision: as
// many at once as a register holds. Included once for each instruction set: see pixel_kernels.cpp,
// and Highway's guide on the guard.

#if defined(HEARTH_RENDER_EXACT_PLACES) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_EXACT_PLACES
#undef HEARTH_RENDER_EXACT_PLACES
#else
#define HEARTH_RENDER_EXACT_PLACES
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "light/lightmap.h"
#include "render/draw_settings.h"
#include "render/pixel_axes-inl.h"
#include "render/pixel_kernels.h"
#include "render/texture.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

constexpr std::size_t kLanes = PixelBlock::kLanes;

/// Calls visit(pixel, lane) for as many pixels at once as a register of doubles holds.
template <typename Visit>
HWY_INLINE void forEachDoubles(const PixelBlock& block, Visit&& visit) {
  for (std::size_t row = 0; row < block.count(); row += kLanes)
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kDouble)) visit(row + lane, lane);
}

inline void findParameters(PixelBlock& block, const GroupMapping& mapping) {
  forEachDoubles(block, [&](std::size_t pixel, std::size_t lane) HWY_ATTR {
    const Doubles raySlope = all(block.raySlopes[pixel / kLanes]);
    if (!mapping.isPlane) return hn::Store(raySlope, kDouble, &block.parameters[pixel]);
    const Doubles farthest = hn::Load(kDouble, &mapping.depth[lane]);
    const Doubles found =
        hn::Div(all(mapping.height), hn::Sub(raySlope, hn::Load(kDouble, &mapping.rise[lane])));
    const auto isInside = hn::And(hn::Ge(found, all(0)), hn::Lt(found, farthest));
    hn::Store(hn::IfThenElse(isInside, found, farthest), kDouble, &block.parameters[pixel]);
  });
}

/// Whole numbers of less than 2^32.
HWY_INLINE void store(Doubles number, std::uint32_t* to) {
  // Of less than 2^52: added to it, they are its lowest bits.
  const LongWords bits = hn::BitCast(kLongWord, hn::Add(number, all(0x1p52)));
  const hn::Rebind<std::uint32_t, decltype(kLongWord)> tag;
  hn::Store(hn::TruncateTo(tag, bits), tag, to);
}

/// The number of a texel at a place of a line: a column of an image, or a row of a lightmap.
HWY_INLINE Doubles texelNumber(Doubles line, Doubles place, int lineLength) {
  return hn::Add(hn::Mul(line, all(lineLength)), place);
}

template <typename Rows>
inline void findTexelsIn(PixelBlock& block, const GroupMapping& mapping, const Texture& image,
                         const Rows& rows) {
  const Repeating columns(image.width());
  forEachDoubles(block, [&](std::size_t pixel, std::size_t lane) HWY_ATTR {
    const Doubles parameter = hn::Load(kDouble, &block.parameters[pixel]);
    store(texelNumber(columns.texel(at(mapping.u, lane, parameter)),
                      rows.texel(at(mapping.v, lane, parameter)), image.height()),
          &block.texels[0][pixel]);
  });
}

inline void findTexels(PixelBlock& block, const GroupMapping& mapping, const Texture& image) {
  if (mapping.isSky) return findTexelsIn(block, mapping, image, SkyRows(image.height()));
  findTexelsIn(block, mapping, image, Repeating(image.height()));
}

HWY_INLINE Doubles at(const Affine& along, Doubles parameter) {
  return hn::Add(all(along.atZero), hn::Mul(parameter, all(along.per)));
}

/// Calls visit(row, u, v) for as many rows at once as a register of doubles holds.
template <typename Visit>
HWY_INLINE void forEachOfFace(const FaceColumn& column, const double* raySlopes, int rows,
                              Visit&& visit) {
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); row += hn::Lanes(kDouble)) {
    const Doubles raySlope = hn::LoadU(kDouble, raySlopes + row);
    const Doubles depth = hn::Div(all(1), at(column.nearness, raySlope));
    const auto texel = [&](double atEye, const Affine& along) HWY_ATTR {
      return hn::Add(all(atEye), hn::Mul(depth, at(along, raySlope)));
    };
    visit(row, texel(column.uAtEye, column.u), texel(column.vAtEye, column.v));
  }
}

inline void findFaceTexels(const FaceColumn& column, const double* raySlopes, int rows,
                           const Texture& image, FaceRowPlaces& places) {
  const Repeating across(image.width());
  const Repeating down(image.height());
  forEachOfFace(column, raySlopes, rows, [&](std::size_t row, Doubles u, Doubles v) HWY_ATTR {
    store(texelNumber(across.texel(u), down.texel(v), image.height()), &places.texels[0][row]);
  });
}

/// A fraction of 0 to 1 as a Mix has it.
HWY_INLINE void storeMinusFraction(Doubles fraction, std::uint32_t* to) {
  const Doubles minus =
      hn::Sub(all(0x10000), hn::Floor(hn::Add(hn::Mul(fraction, all(0x8000)), all(0.5))));
  const Doubles number = hn::IfThenElseZero(hn::Lt(minus, all(0x10000)), minus);
  store(hn::Mul(number, all(0x10001)), to);  // in both fields of the word
}

/// Of pixels of a block or of rows of a face.
template <typename Mix>
HWY_INLINE void storeMix(Doubles across, Doubles down, Mix& mix, std::size_t place) {
  storeMinusFraction(across, &mix.across[place]);
  storeMinusFraction(down, &mix.down[place]);
}

/// The four texels around places on an image of this height, and how they are mixed.
template <typename Texels, typename Mix>
HWY_INLINE void storeAround(const TexelPair& across, const TexelPair& down, int height,
                            Texels& texels, Mix& mix, std::size_t place) {
  store(texelNumber(across.first, down.first, height), &texels[0][place]);
  store(texelNumber(across.next, down.first, height), &texels[1][place]);
  store(texelNumber(across.first, down.next, height), &texels[2][place]);
  store(texelNumber(across.next, down.next, height), &texels[3][place]);
  storeMix(across.fraction, down.fraction, mix, place);
}

template <typename Rows>
inline void findTexelsAroundIn(PixelBlock& block, const GroupMapping& mapping, const Texture& image,
                               const Rows& rows) {
  const Repeating columns(image.width());
  forEachDoubles(block, [&](std::size_t pixel, std::size_t lane) HWY_ATTR {
    const Doubles parameter = hn::Load(kDouble, &block.parameters[pixel]);
    storeAround(columns.around(at(mapping.u, lane, parameter)),
                rows.around(at(mapping.v, lane, parameter)), image.height(), block.texels,
                block.betweenTexels, pixel);
  });
}

inline void findTexelsAround(PixelBlock& block, const GroupMapping& mapping, const Texture& image) {
  if (mapping.isSky) return findTexelsAroundIn(block, mapping, image, SkyRows(image.height()));
  findTexelsAroundIn(block, mapping, image, Repeating(image.height()));
}

inline void findFaceTexelsAround(const FaceColumn& column, const double* raySlopes, int rows,
                                 const Texture& image, FaceRowPlaces& places) {
  const Repeating columns(image.width());
  const Repeating rowsOfImage(image.height());
  forEachOfFace(column, raySlopes, rows, [&](std::size_t row, Doubles u, Doubles v) HWY_ATTR {
    storeAround(columns.around(u), rowsOfImage.around(v), image.height(), places.texels, places.mix,
                row);
  });
}

/// All of the nearer texel where nothing is to be mixed.
HWY_INLINE Doubles filtered(Doubles fraction, LightFilter filter) {
  return filter == LightFilter::Nearest ? hn::Floor(hn::Add(fraction, all(0.5))) : fraction;
}

/// Lightmaps hold the light at the centres of texels.
inline Vec2 centreOfFirst(const TexelRect& rect) { return {rect.i0 + 0.5, rect.j0 + 0.5}; }

inline void findLightTexels(PixelBlock& block, const GroupMapping& mapping,
                            const Lightmap& lightmap, LightFilter filter) {
  const TexelRect& rect = lightmap.rect;
  const Vec2 first = centreOfFirst(rect);
  forEachDoubles(block, [&](std::size_t pixel, std::size_t lane) HWY_ATTR {
    const Doubles parameter = hn::Load(kDouble, &block.parameters[pixel]);
    const TexelPair across =
        keptAround(hn::Sub(at(mapping.s, lane, parameter), all(first.x)), rect.width);
    const TexelPair down =
        keptAround(hn::Sub(at(mapping.t, lane, parameter), all(first.y)), rect.height);
    store(hn::Mul(texelNumber(down.first, across.first, rect.width), all(lightmap.channels)),
          &block.lightTexels[pixel]);
    storeMix(filtered(across.fraction, filter), filtered(down.fraction, filter),
             block.betweenLightTexels, pixel);
  });
}

inline void findFaceLight(const FaceColumn& column, const double* raySlopes, int rows,
                          const Lightmap& lightmap, LightFilter filter, FaceRowPlaces& places) {
  const TexelRect& rect = lightmap.rect;
  const Vec2 first = centreOfFirst(rect);
  forEachOfFace(column, raySlopes, rows, [&](std::size_t row, Doubles s, Doubles t) HWY_ATTR {
    const TexelPair across = keptAround(hn::Sub(s, all(first.x)), rect.width);
    const TexelPair down = keptAround(hn::Sub(t, all(first.y)), rect.height);
    store(hn::Mul(texelNumber(down.first, across.first, rect.width), all(lightmap.channels)),
          &places.texels[0][row]);
    storeMix(filtered(across.fraction, filter), filtered(down.fraction, filter), places.mix, row);
  });
}

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
