// Where the pixels of a block lie on images and lightmaps, as far as these places are linear down
// the columns or across the rows: in fixed point. Included once for each instruction set: see
// pixel_kernels.cpp, and Highway's guide on the guard.

#if defined(HEARTH_RENDER_LINEAR_PLACES) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_LINEAR_PLACES
#undef HEARTH_RENDER_LINEAR_PLACES
#else
#define HEARTH_RENDER_LINEAR_PLACES
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/exact_places-inl.h"
#include "render/fixed_point-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

/// How places become whole numbers.
struct Scale {
  double unitsPerOne;
  double largest;  ///< of the places
};

inline Scale repeatScale(int size) { return {kPlacesPerRepeat / size, kMaxRepeats * size}; }
constexpr Scale kSkyScale{1 << FixedSkyRows::kBits, FixedSkyRows::kLargest};
constexpr Scale kLightScale{kPlacesPerLightTexel, kMaxLightTexels};

HWY_INLINE Doubles perOf(const LaneAffine& along, std::size_t lane) {
  return hn::Load(kDouble, &along.per[lane]);
}
HWY_INLINE Doubles perOf(const LaneImageAxis& along, std::size_t lane) {
  return hn::Mul(perOf(along.place, lane), all(along.texelsPerPlace));
}

/// A place before the image's edge is subtracted: there it is rounded. Lightmaps need no such care:
/// their light changes little from one side of a rounded place to the other.
HWY_INLINE Doubles fromZero(const LaneImageAxis& along, std::size_t lane, Doubles parameter) {
  return hn::Mul(at(along.place, lane, parameter), all(along.texelsPerPlace));
}
HWY_INLINE Doubles fromZero(const LaneAffine&, std::size_t, Doubles) { return all(0); }

/// The places, less `offset`, down the columns of what is upright. False if they are too large.
template <typename Along>
inline bool findDown(const PixelBlock& block, const Along& along, double offset, const Scale& scale,
                     ColumnPlaces& down) {
  const double first = block.raySlopes[0];
  const double last = block.raySlopes[block.rows - 1];
  const double perRow = (last - first) / std::max(1, block.rows - 1);
  bool areSmall = true;
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kDouble)) {
    const Doubles start = hn::Sub(at(along, lane, all(first)), all(offset));
    const Doubles end = hn::Sub(at(along, lane, all(last)), all(offset));
    Doubles largest = hn::Max(hn::Abs(start), hn::Abs(end));
    for (const double raySlope : {first, last})
      largest = hn::Max(largest, hn::Abs(fromZero(along, lane, all(raySlope))));
    areSmall = areSmall && hn::AllTrue(kDouble, hn::Lt(largest, all(scale.largest)));
    storeModulo(hn::Mul(start, all(scale.unitsPerOne)), &down.start[lane]);
    storeModulo(hn::Mul(perOf(along, lane), all(perRow * scale.unitsPerOne)), &down.step[lane]);
  }
  return areSmall;
}

/// The depths of a level plane in the rows of a block. Rounding may take them out of the sector,
/// unlike those of SpanMapping::depthAt, but FixedAxis is unsure of all texels that it could
/// change.
struct alignas(64) RowDepths : std::array<double, PixelBlock::kRows> {};

inline void findDepths(const PixelBlock& block, const GroupMapping& mapping, RowDepths& depths) {
  for (std::size_t row = 0; row < static_cast<std::size_t>(block.rows); row += hn::Lanes(kDouble))
    hn::Store(hn::Div(all(mapping.height), hn::LoadU(kDouble, block.raySlopes + row)), kDouble,
              &depths[row]);
}

/// An axis across a row: its place is ((atZero + depth * (per + column * perColumn)) - origin) *
/// scale - offset.
struct RowAxis {
  double atZero;
  double per;
  double perColumn;
  double origin;
  double scale;
  double offset;
  bool isOfImage;

  explicit RowAxis(const LaneAffine& along, double from) : RowAxis(along, from, 1, 0, false) {}
  explicit RowAxis(const LaneImageAxis& along)
      : RowAxis(along.place, along.origin[0], along.texelsPerPlace, along.offset, true) {}

  HWY_INLINE Doubles at(Doubles depth) const {
    const Doubles place = hn::Add(all(atZero), hn::Mul(depth, all(per)));
    return hn::Sub(hn::Mul(hn::Sub(place, all(origin)), all(scale)), all(offset));
  }
  /// The largest place in a row of this depth; of images also before their edge is subtracted.
  double largestAt(double depth) const {
    const auto largerEnd = [&](double first) {
      const double last = first + (kLanes - 1) * depth * perColumn * scale;
      return std::max(std::abs(first), std::abs(last));
    };
    const double place = atZero + depth * per;
    const double largest = largerEnd((place - origin) * scale - offset);
    return isOfImage ? std::max(largest, largerEnd(place * scale)) : largest;
  }

 private:
  RowAxis(const LaneAffine& along, double from, double times, double less, bool ofImage)
      : atZero(along.atZero[0]),
        per(along.per[0]),
        perColumn((along.per[kLanes - 1] - along.per[0]) / (kLanes - 1)),
        origin(from),
        scale(times),
        offset(less),
        isOfImage(ofImage) {}
};

/// The places across the rows of a level plane. False if they are too large, as at the horizon.
inline bool findAcross(const PixelBlock& block, const RowDepths& depths, const RowAxis& along,
                       const Scale& scale, RowPlaces& across) {
  const auto isSmall = [&](double depth) {
    return depth >= 0 && along.largestAt(depth) < scale.largest;
  };
  const auto rows = static_cast<std::size_t>(block.rows);
  if (!isSmall(depths[0]) || !isSmall(depths[rows - 1])) return false;
  const double stepPerDepth = along.perColumn * along.scale * scale.unitsPerOne;
  for (std::size_t row = 0; row < rows; row += hn::Lanes(kDouble)) {
    const Doubles depth = hn::Load(kDouble, &depths[row]);
    storeModulo(hn::Mul(along.at(depth), all(scale.unitsPerOne)), &across.start[row]);
    storeModulo(hn::Mul(depth, all(stepPerDepth)), &across.step[row]);
  }
  return true;
}

/// Calls visit(pixel, lane, place) for as many pixels at once as a register of words holds.
template <typename Visit>
HWY_INLINE void forEachDown(const PixelBlock& block, const ColumnPlaces& down, Visit&& visit) {
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kWord)) {
    Words place = hn::Load(kWord, &down.start[lane]);
    const Words step = hn::Load(kWord, &down.step[lane]);
    for (std::size_t pixel = lane; pixel < block.count(); pixel += kLanes) {
      visit(pixel, lane, place);
      place = hn::Add(place, step);
    }
  }
}

/// Calls visit(pixel, place on the first axis, place on the second one) likewise.
template <typename Visit>
HWY_INLINE void forEachAcross(const PixelBlock& block, const RowPlaces& first,
                              const RowPlaces& second, Visit&& visit) {
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kWord))
    for (std::size_t row = 0; row < static_cast<std::size_t>(block.rows); ++row)
      visit(row * kLanes + lane, first.at(row, lane), second.at(row, lane));
}

template <typename Rows>
inline bool findTexelsDown(PixelBlock& block, const FixedNumbers<kLanes>& columns,
                           const ColumnPlaces& down, Rows rows) {
  forEachDown(block, down, [&](std::size_t pixel, std::size_t lane, Words place) HWY_ATTR {
    const Words number = hn::Add(hn::Load(kWord, &columns[lane]), rows.texel(place));
    hn::Store(number, kWord, &block.texels[0][pixel]);
  });
  return rows.isSure();
}

inline bool findTexelsDown(PixelBlock& block, const GroupMapping& mapping, const Texture& image) {
  const int height = image.height();
  const Scale scale = mapping.isSky ? kSkyScale : repeatScale(height);
  ColumnPlaces down;
  if (!findDown(block, mapping.v, 0, scale, down)) return false;
  const Repeating across(image.width());
  FixedNumbers<kLanes> columns;
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kDouble))
    store(hn::Mul(across.texel(at(mapping.u, lane, all(0))), all(height)), &columns[lane]);
  if (mapping.isSky) return findTexelsDown(block, columns, down, FixedSkyRows(height));
  if (isPowerOfTwo(height)) return findTexelsDown(block, columns, down, FixedAxis<true>(height));
  return findTexelsDown(block, columns, down, FixedAxis<false>(height));
}

template <bool kIsPowerOfTwo>
inline bool findTexelsAcross(PixelBlock& block, const RowPlaces& u, const RowPlaces& v,
                             const Texture& image) {
  FixedAxis<kIsPowerOfTwo> columns(image.width());
  FixedAxis<kIsPowerOfTwo> rows(image.height());
  const int heightBits = std::countr_zero(static_cast<unsigned>(image.height()));
  const Words height = allWords(static_cast<std::uint32_t>(image.height()));
  forEachAcross(block, u, v, [&](std::size_t pixel, Words uPlace, Words vPlace) HWY_ATTR {
    const Words column = columns.texel(uPlace);
    const Words first =
        kIsPowerOfTwo ? hn::ShiftLeftSame(column, heightBits) : hn::Mul(column, height);
    hn::Store(hn::Add(first, rows.texel(vPlace)), kWord, &block.texels[0][pixel]);
  });
  return columns.isSure() && rows.isSure();
}

inline bool findTexelsAcross(PixelBlock& block, const GroupMapping& mapping, const Texture& image) {
  RowDepths depths;
  findDepths(block, mapping, depths);
  RowPlaces u;
  RowPlaces v;
  if (!findAcross(block, depths, RowAxis(mapping.u), repeatScale(image.width()), u)) return false;
  if (!findAcross(block, depths, RowAxis(mapping.v), repeatScale(image.height()), v)) return false;
  return isPowerOfTwo(image.width()) && isPowerOfTwo(image.height())
             ? findTexelsAcross<true>(block, u, v, image)
             : findTexelsAcross<false>(block, u, v, image);
}

inline bool findLinearTexels(PixelBlock& block, const GroupMapping& mapping, const Texture& image) {
  if (!isFixedSize(image.width()) || !isFixedSize(image.height())) return false;
  if (mapping.isSky && image.height() > FixedSkyRows::kLargest) return false;
  if (!mapping.isPlane) return !mapping.isOfFace && findTexelsDown(block, mapping, image);
  return mapping.isLevel && findTexelsAcross(block, mapping, image);
}

/// Stores a place of a lightmap that lies between two of its columns and two of its rows.
HWY_INLINE void storeLight(Words number, Words across, Words down, PixelBlock& block,
                           std::size_t pixel) {
  hn::Store(number, kWord, &block.lightTexels[pixel]);
  hn::Store(across, kWord, &block.betweenLightTexels.across[pixel]);
  hn::Store(down, kWord, &block.betweenLightTexels.down[pixel]);
}

inline bool findLightDown(PixelBlock& block, const GroupMapping& mapping, const Lightmap& lightmap,
                          LightFilter filter) {
  const TexelRect& rect = lightmap.rect;
  const Vec2 first = centreOfFirst(rect);
  ColumnPlaces down;
  if (!findDown(block, mapping.t, first.y, kLightScale, down)) return false;
  FixedNumbers<kLanes> columns;
  FixedNumbers<kLanes> across;
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kDouble)) {
    const TexelPair pair =
        keptAround(hn::Sub(at(mapping.s, lane, all(0)), all(first.x)), rect.width);
    store(hn::Mul(pair.first, all(lightmap.channels)), &columns[lane]);
    storeMinusFraction(filtered(pair.fraction, filter), &across[lane]);
  }
  const FixedLightAxis rows(rect.height, filter);
  const Words bytesPerRow = allWords(static_cast<std::uint32_t>(rect.width * lightmap.channels));
  forEachDown(block, down, [&](std::size_t pixel, std::size_t lane, Words place) HWY_ATTR {
    const LightPlace row = rows.at(hn::BitCast(kSigned, place));
    const Words number =
        hn::Add(hn::Mul(wordsOf(row.first), bytesPerRow), hn::Load(kWord, &columns[lane]));
    storeLight(number, hn::Load(kWord, &across[lane]), row.minusFraction, block, pixel);
  });
  return true;
}

inline bool findLightAcross(PixelBlock& block, const GroupMapping& mapping,
                            const Lightmap& lightmap, LightFilter filter) {
  const TexelRect& rect = lightmap.rect;
  const Vec2 first = centreOfFirst(rect);
  RowDepths depths;
  findDepths(block, mapping, depths);
  RowPlaces s;
  RowPlaces t;
  if (!findAcross(block, depths, RowAxis(mapping.s, first.x), kLightScale, s)) return false;
  if (!findAcross(block, depths, RowAxis(mapping.t, first.y), kLightScale, t)) return false;
  const FixedLightAxis columns(rect.width, filter);
  const FixedLightAxis rows(rect.height, filter);
  const Words bytesPerRow = allWords(static_cast<std::uint32_t>(rect.width * lightmap.channels));
  const Words bytesPerTexel = allWords(static_cast<std::uint32_t>(lightmap.channels));
  forEachAcross(block, s, t, [&](std::size_t pixel, Words sPlace, Words tPlace) HWY_ATTR {
    const LightPlace across = columns.at(hn::BitCast(kSigned, sPlace));
    const LightPlace down = rows.at(hn::BitCast(kSigned, tPlace));
    const Words number = hn::Add(hn::Mul(wordsOf(down.first), bytesPerRow),
                                 hn::Mul(wordsOf(across.first), bytesPerTexel));
    storeLight(number, across.minusFraction, down.minusFraction, block, pixel);
  });
  return true;
}

inline bool findLinearLightTexels(PixelBlock& block, const GroupMapping& mapping,
                                  const Lightmap& lightmap, LightFilter filter) {
  if (std::max(lightmap.rect.width, lightmap.rect.height) > kMaxLightTexels) return false;
  if (!mapping.isPlane) return !mapping.isOfFace && findLightDown(block, mapping, lightmap, filter);
  return mapping.isLevel && findLightAcross(block, mapping, lightmap, filter);
}

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
