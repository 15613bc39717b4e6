#include "peers/kernel_frames.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "math/check.h"

namespace hearth {

namespace {

/// How far a coordinate goes along a span.
struct Stretch {
  double least;
  double most;
};

Stretch stretchOf(const KernelAxis& axis, const KernelSpan& span) {
  const auto at = [&](std::size_t row) {
    return axis.start + static_cast<double>(axis.step) * span.parameters[row];
  };
  const double first = at(0);
  const double last = at(span.rowEnd - span.rowBegin - 1);
  return {std::min(first, last), std::max(first, last)};
}

KernelAxis axisOf(double start, double step) {
  return {static_cast<float>(start), static_cast<float>(step)};
}

/// An axis of an image, moved by whole images so that it is never less than 0.
KernelAxis repeatedAxis(const ImageAxis& along, double perParameter, int size,
                        const KernelSpan& span) {
  const double start = (along.place.atZero - along.origin) * along.texelsPerPlace - along.offset;
  const double step = perParameter * along.place.per * along.texelsPerPlace;
  const double least = stretchOf(axisOf(start, step), span).least;
  return axisOf(start - size * std::floor(least / size), step);
}

int nextPowerOfTwo(int size) {
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(size)));
}

/// The image with sides that are powers of two, as most have: then the lowest bits of a number
/// repeat it.
Image ofPowersOfTwo(const Image& image) {
  Image larger(nextPowerOfTwo(image.width()), nextPowerOfTwo(image.height()));
  for (int y = 0; y < larger.height(); ++y)
    for (int x = 0; x < larger.width(); ++x)
      larger.at(x, y) =
          image.at(x * image.width() / larger.width(), y * image.height() / larger.height());
  return larger;
}

/// With its outermost texels once more around it: what rounding puts beyond them is there.
std::vector<Pixel> bordered(const Lightmap& map) {
  const TexelRect& rect = map.rect;
  std::vector<Pixel> texels;
  for (int j = -1; j <= rect.height; ++j)
    for (int i = -1; i <= rect.width; ++i) {
      const int x = rect.i0 + std::clamp(i, 0, rect.width - 1);
      const int y = rect.j0 + std::clamp(j, 0, rect.height - 1);
      const auto level = [&](int channel) { return map.at(x, y, channel); };
      texels.push_back(pixelOf({level(0), level(1), level(2)}));
    }
  return texels;
}

/// What shows in the same light in all rows, or in none but that of the sector.
void setEvenLight(const Material& material, KernelSpan& kernel) {
  kernel.kind = KernelLight::Even;
  for (int channel = 0; channel < 3; ++channel) {
    const Lightmap* map = material.lightmap;
    const double level = map ? map->at(map->rect.i0, map->rect.j0, channel) : 0;
    kernel.shown[channel] = static_cast<float>(std::min(1.0, level / 255 + material.sectorLight));
  }
}

/// The parts of an upright span that need no more rows of the lightmap than registers hold; the
/// span as if it were a plane where its rows are too few for that.
std::vector<KernelSpan> partsOfUpright(const KernelSpan& whole) {
  const std::size_t lanes = kernelLanes();
  const auto rowAt = [&](std::size_t k) {
    return static_cast<std::ptrdiff_t>(whole.t.start + whole.t.step * whole.parameters[k]);
  };
  std::vector<KernelSpan> parts;
  const std::size_t count = whole.rowEnd - whole.rowBegin;
  for (std::size_t begin = 0; begin < count;) {
    std::size_t end = begin + 1;
    const auto rowsTo = [&](std::size_t k) {
      return static_cast<std::size_t>(std::abs(rowAt(k) - rowAt(begin))) + 2;
    };
    while (end < count && rowsTo(end) <= lanes) ++end;
    KernelSpan part = whole;
    part.rowBegin += begin;
    part.rowEnd = whole.rowBegin + end;
    part.parameters += begin;
    part.lightRows = rowsTo(end - 1);
    const std::ptrdiff_t first = std::min(rowAt(begin), rowAt(end - 1));
    part.light += first * static_cast<std::ptrdiff_t>(whole.lightWidth);
    part.light += static_cast<std::ptrdiff_t>(whole.s.start);
    part.s.start -= std::floor(whole.s.start);
    part.t.start -= static_cast<float>(first);
    parts.push_back(part);
    begin = end;
  }
  if (lanes > 1 && (parts.size() == 1 || parts.size() * lanes < count)) return parts;
  KernelSpan plane = whole;
  plane.kind = KernelLight::Plane;
  return {plane};
}

}  // namespace

KernelFrames::KernelFrames(const PeerLevel& level, ImageSize size)
    : level_(level), lights_(level.loaded.level.surfaces.size()) {
  for (const Image& image : level.loaded.textures) {
    textures_.emplace_back(image);
    images_.emplace_back(ofPowersOfTwo(image));
  }
  for (Camera camera : camerasOf(level.loaded.level)) {
    camera.width = size.width;
    camera.height = size.height;
    frames_.push_back(frameOf(camera));
  }
}

KernelFrame KernelFrames::frameOf(const Camera& camera) {
  FrameScratch scratch;
  level_.renderer.findSpans(camera, scratch);
  const Projection projection = projectionFor(level_.loaded.scene(), camera);
  const DrawSettings settings;
  const SpanPainter painter(level_.loaded.scene(), textures_, level_.light, settings, projection,
                            scratch.raySlopes);
  std::vector<float> raySlopes;
  std::vector<float> reciprocals;
  for (const double raySlope : scratch.raySlopes) {
    raySlopes.push_back(static_cast<float>(raySlope));
    reciprocals.push_back(static_cast<float>(1 / raySlope));
  }
  const Rows rows{scratch.raySlopes, kept(std::move(raySlopes)), kept(std::move(reciprocals))};

  KernelFrame frame{
      static_cast<std::size_t>(camera.width), static_cast<std::size_t>(camera.height), {}, {}};
  scratch.forEachSpan([&](const Span& span) { addSpans(painter, span, rows, frame.spans); });
  std::ranges::sort(frame.spans, {},
                    [](const KernelSpan& span) { return std::pair(span.column, span.rowBegin); });
  for (std::size_t column = 0; column <= frame.width; column += KernelFrame::kColumns) {
    const auto first = std::ranges::lower_bound(frame.spans, column, {}, &KernelSpan::column);
    frame.stripBegin.push_back(static_cast<std::size_t>(first - frame.spans.begin()));
  }
  return frame;
}

void KernelFrames::addSpans(const SpanPainter& painter, const Span& span, const Rows& rows,
                            std::vector<KernelSpan>& spans) {
  const Material material = painter.materialOf(span.surface);
  if (material.surface.kind == SurfaceKind::MaskedMiddle) return;
  const Texture& image = images_[material.surface.mapping.texture.index()];
  const SpanMapping mapping = onImage(painter.mappingOf(material, span), material.image(), image);
  KernelSpan kernel{};
  kernel.column = static_cast<std::size_t>(span.column);
  kernel.rowBegin = static_cast<std::size_t>(span.rowBegin);
  kernel.rowEnd = static_cast<std::size_t>(span.rowEnd);
  kernel.texels = image.texels();
  kernel.uMask = static_cast<std::uint32_t>(image.width() - 1);
  kernel.vMask = static_cast<std::uint32_t>(image.height() - 1);
  kernel.vBits = std::countr_zero(static_cast<unsigned>(image.height()));
  const double perParameter = setParameters(mapping, image, rows, kernel);
  kernel.u = repeatedAxis(mapping.u, perParameter, image.width(), kernel);
  kernel.v = mapping.isSky ? KernelAxis{0, 1}
                           : repeatedAxis(mapping.v, perParameter, image.height(), kernel);
  if (!material.hasVaryingLight()) {
    setEvenLight(material, kernel);
    spans.push_back(kernel);
    return;
  }
  const TexelRect& rect = material.lightmap->rect;
  kernel.s = axisOf(mapping.s.atZero - rect.i0 + 0.5, perParameter * mapping.s.per);
  kernel.t = axisOf(mapping.t.atZero - rect.j0 + 0.5, perParameter * mapping.t.per);
  kernel.light = lightOf(span.surface, *material.lightmap).data();
  kernel.lightWidth = static_cast<std::size_t>(rect.width) + 2;
  kernel.sectorLight = static_cast<float>(material.sectorLight);
  const auto [sLeast, sMost] = stretchOf(kernel.s, kernel);
  const auto [tLeast, tMost] = stretchOf(kernel.t, kernel);
  CHECK(sLeast >= 0 && sMost < rect.width + 1, sLeast, sMost, rect.width);
  CHECK(tLeast >= 0 && tMost < rect.height + 1, tLeast, tMost, rect.height);
  kernel.kind = mapping.isPlane ? KernelLight::Plane : KernelLight::Upright;
  if (mapping.isPlane)
    spans.push_back(kernel);
  else
    for (const KernelSpan& part : partsOfUpright(kernel)) spans.push_back(part);
}

/// Walls and flats use the same parameters all over the frame, slopes and skies their own.
double KernelFrames::setParameters(const SpanMapping& mapping, const Texture& image,
                                   const Rows& rows, KernelSpan& kernel) {
  const auto ofItsOwn = [&](auto&& parameter) {
    std::vector<float> values;
    for (std::size_t row = kernel.rowBegin; row < kernel.rowEnd; ++row)
      values.push_back(static_cast<float>(parameter(rows.raySlopes[row])));
    return kept(std::move(values));
  };
  kernel.parameters = rows.narrowRaySlopes + kernel.rowBegin;
  if (mapping.isSky)
    kernel.parameters = ofItsOwn([&](double raySlope) { return mapping.skyV(raySlope, image); });
  if (!mapping.isPlane) return 1;
  if (mapping.rise != 0) {
    kernel.parameters = ofItsOwn([&](double raySlope) { return mapping.depthAt(raySlope); });
    return 1;
  }
  kernel.parameters = rows.reciprocals + kernel.rowBegin;
  return mapping.height;
}

const float* KernelFrames::kept(std::vector<float> values) {
  values.resize(values.size() + kernelLanes());
  return parameters_.emplace_back(std::move(values)).data();
}

const std::vector<Pixel>& KernelFrames::lightOf(SurfaceId surface, const Lightmap& lightmap) {
  std::vector<Pixel>& light = lights_[surface.index()];
  if (light.empty()) light = bordered(lightmap);
  return light;
}

}  // namespace hearth
