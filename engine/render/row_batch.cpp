#include "render/row_batch.h"

#include <emmintrin.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "math/planted_bug.h"

namespace hearth {

namespace {

/// Two neighbouring rows at once, with SSE2, which every x86-64 processor has.
using TwoRows = __m128d;

TwoRows both(double value) { return _mm_set1_pd(value); }

TwoRows at(const Affine& along, TwoRows measures) {
  return _mm_add_pd(both(along.atZero), _mm_mul_pd(measures, both(along.per)));
}

TwoRows at(const ImageAxis& along, TwoRows measures) {
  const TwoRows fromOrigin = _mm_sub_pd(at(along.place, measures), both(along.origin));
  return _mm_sub_pd(_mm_mul_pd(fromOrigin, both(along.texelsPerPlace)), both(along.offset));
}

/// Calls `find(k, two)` with the values of `along` at the rows k and k + 1 of the batch.
template <typename Along, typename Find>
void forTwoRows(const RowBatch& batch, const Along& along, Find&& find) {
  for (std::size_t k = 0; k < batch.count; k += 2)
    find(k, at(along, _mm_load_pd(&batch.measure[k])));
}

/// Two numbers of 32 bits.
void store(void* to, __m128i two) { _mm_storel_epi64(static_cast<__m128i*>(to), two); }

/// Added to a number of less than 2^51 it leaves nothing behind the point, and the whole part in
/// the lowest bits.
constexpr double kWholeBits = 0x1.8p52;

TwoRows nearestWhole(TwoRows x) {
  return _mm_sub_pd(_mm_add_pd(x, both(kWholeBits)), both(kWholeBits));
}

/// Texel coordinates as whole numbers; past 2^50, where doubles leave nothing behind the point,
/// those of 2^50.
TwoRows wholeTexels(TwoRows x) {
  const TwoRows kept = _mm_max_pd(_mm_min_pd(x, both(0x1p50)), both(-0x1p50));
  const TwoRows nearest = nearestWhole(kept);
  return _mm_sub_pd(nearest, _mm_and_pd(_mm_cmpgt_pd(nearest, kept), both(1)));
}

/// Of an image whose size is a power of two.
__m128i maskedTexels(TwoRows x, __m128i mask) {
  const __m128i bits = _mm_castpd_si128(_mm_add_pd(wholeTexels(x), both(kWholeBits)));
  return _mm_and_si128(_mm_shuffle_epi32(bits, _MM_SHUFFLE(3, 3, 2, 0)), mask);
}

__m128i dividedTexels(TwoRows x, TwoRows size, TwoRows perTexel) {
  const TwoRows whole = wholeTexels(x);
  const TwoRows repeats = nearestWhole(_mm_mul_pd(whole, perTexel));
  const TwoRows rest = _mm_sub_pd(whole, _mm_mul_pd(repeats, size));  // half a size from 0 at most
  const TwoRows isNegative = _mm_cmplt_pd(rest, both(0));
  return _mm_cvttpd_epi32(_mm_add_pd(rest, _mm_and_pd(isNegative, size)));
}

void findRepeated(RowBatch::Indices& found, const ImageAxis& along, std::int32_t size,
                  const RowBatch& batch) {
  if (along.place.per == 0) return found.fill(repeated(along.at(0), size));
  if (planted(PlantedBug::TruncatingRepeat)) {
    for (std::size_t k = 0; k < batch.count; ++k)
      found[k] = repeated(along.at(batch.measure[k]), size);
  } else if (std::has_single_bit(static_cast<std::uint32_t>(size))) {
    forTwoRows(batch, along, [&, mask = _mm_set1_epi32(size - 1)](std::size_t k, TwoRows x) {
      store(&found[k], maskedTexels(x, mask));
    });
  } else {
    forTwoRows(batch, along, [&](std::size_t k, TwoRows x) {
      store(&found[k], dividedTexels(x, both(size), both(1.0 / size)));
    });
  }
}

void storeShares(float* to, TwoRows shares) { store(to, _mm_castps_si128(_mm_cvtpd_ps(shares))); }

/// Between the centres of texels of an image that repeats. `along` is from the first one's centre.
void findRepeatedPlaces(RowBatch::Places& found, const ImageAxis& along, int texels,
                        const RowBatch& batch) {
  findRepeated(found.texel, along, texels, batch);
  forTwoRows(batch, along, [&](std::size_t k, TwoRows x) {
    storeShares(&found.share[k], _mm_sub_pd(x, wholeTexels(x)));
  });
}

/// The same where nothing repeats: what is beyond the edge is taken back to it, and the texel
/// before the last is the last to have a next one.
template <typename Along>
void findPlaces(RowBatch::Places& found, const Along& along, int texels, const RowBatch& batch) {
  const TwoRows last = both(texels - 1);
  const TwoRows lastBefore = both(std::max(0, texels - 2));
  forTwoRows(batch, along, [&](std::size_t k, TwoRows x) {
    const TwoRows kept = _mm_max_pd(_mm_min_pd(x, last), both(0));
    const __m128i texel = _mm_cvttpd_epi32(_mm_min_pd(kept, lastBefore));
    store(&found.texel[k], texel);
    storeShares(&found.share[k], _mm_sub_pd(kept, _mm_cvtepi32_pd(texel)));
  });
}

/// In texels from the centre of the first one.
ImageAxis fromFirst(ImageAxis along) {
  along.offset += 0.5;
  return along;
}

Affine fromFirst(const Affine& along, int first) {
  const double wrong = planted(PlantedBug::LightmapHalfTexelOff) ? 0.5 : 0;
  return {along.atZero - (first + 0.5) + wrong, along.per};
}

/// Depths at every so many rows, and between them what lies evenly between.
void interpolateDepths(RowBatch& batch, const SpanMapping& mapping, const double* climbs,
                       std::size_t every) {
  const std::size_t last = batch.count - 1;
  double here = mapping.depthAt(climbs[0]);
  for (std::size_t k = 0; k < last; k += every) {
    const std::size_t next = std::min(k + every, last);
    const double there = mapping.depthAt(climbs[next]);
    const double step = (there - here) / static_cast<double>(next - k);
    for (std::size_t i = k; i < next; ++i)
      batch.measure[i] = here + static_cast<double>(i - k) * step;
    here = there;
  }
  batch.measure[last] = here;
}

}  // namespace

void findMeasures(RowBatch& batch, const SpanMapping& mapping, std::span<const double> climbs,
                  int depthEvery) {
  const double* climb = &climbs[static_cast<std::size_t>(batch.firstRow)];
  if (!mapping.isPlane)
    std::copy_n(climb, batch.count, batch.measure.begin());
  else if (depthEvery > 1)
    interpolateDepths(batch, mapping, climb, static_cast<std::size_t>(depthEvery));
  else
    for (std::size_t k = 0; k < batch.count; ++k) batch.measure[k] = mapping.depthAt(climb[k]);
  // Rows are worked out in twos.
  if (batch.count % 2 != 0) batch.measure[batch.count] = batch.measure[batch.count - 1];
}

void findTexels(RowBatch& batch, const SpanMapping& mapping, const Image& image) {
  findRepeated(batch.texelColumn.texel, mapping.u, image.width(), batch);
  if (mapping.isSky) {
    for (std::size_t k = 0; k < batch.count; ++k)
      batch.texelRow.texel[k] = static_cast<std::int32_t>(mapping.skyV(batch.measure[k], image));
  } else {
    findRepeated(batch.texelRow.texel, mapping.v, image.height(), batch);
  }
}

void findMixtures(RowBatch& batch, const SpanMapping& mapping, const Image& image) {
  findRepeatedPlaces(batch.texelColumn, fromFirst(mapping.u), image.width(), batch);
  if (mapping.isSky)
    findPlaces(batch.texelRow, fromFirst(mapping.v), image.height(), batch);
  else
    findRepeatedPlaces(batch.texelRow, fromFirst(mapping.v), image.height(), batch);
}

void findLightPlaces(RowBatch& batch, const SpanMapping& mapping, const TexelRect& rect) {
  findPlaces(batch.lightColumn, fromFirst(mapping.s, rect.i0), rect.width, batch);
  findPlaces(batch.lightRow, fromFirst(mapping.t, rect.j0), rect.height, batch);
  if (planted(PlantedBug::FlatsUnfiltered) && mapping.isPlane)
    for (auto* places : {&batch.lightColumn, &batch.lightRow}) places->share.fill(0);
}

std::int32_t repeated(double x, std::int32_t size) {
  if (planted(PlantedBug::TruncatingRepeat))
    return static_cast<std::int32_t>(std::abs(std::fmod(x, static_cast<double>(size))));
  return _mm_cvtsi128_si32(dividedTexels(both(x), both(size), both(1.0 / size)));
}

}  // namespace hearth
