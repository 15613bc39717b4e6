// Compiled once for each instruction set: foreach_target.h includes this file again and again, with
// HWY_NAMESPACE as another name each time. No result depends on the set: lanes are independent,
// and multiplications and additions are never fused.

#include "render/pixel_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/pixel_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/exact_places-inl.h"
#include "render/linear_places-inl.h"
#include "render/pixel_shading-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

const PixelKernels& kernels() {
  static constexpr PixelKernels kKernels{
      .findParameters = findParameters,
      .findLinearTexels = findLinearTexels,
      .findLinearLightTexels = findLinearLightTexels,
      .findTexels = findTexels,
      .findTexelsAround = findTexelsAround,
      .findLightTexels = findLightTexels,
      .findFaceTexels = findFaceTexels,
      .findFaceTexelsAround = findFaceTexelsAround,
      .findFaceLight = findFaceLight,
      .shade = shade,
  };
  return kKernels;
}

}  // namespace
}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hearth {

namespace {
HWY_EXPORT(kernels);
}

const PixelKernels& pixelKernels() { return HWY_DYNAMIC_DISPATCH(kernels)(); }

}  // namespace hearth

#endif
