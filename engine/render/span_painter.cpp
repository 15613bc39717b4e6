#include "render/span_painter.h"

#include <algorithm>
#include <bit>

#include "render/face_mapping.h"
#include "render/footprint.h"
#include "render/texel_fetch.h"

namespace hearth {

namespace {

PixelBlock::Columns columnsOf(const SpanGroup& group) {
  return {group.rows, std::ranges::max(group.rows.begin), std::ranges::min(group.rows.end)};
}

/// The column that goes deepest, of those that have a span.
std::size_t deepestLane(const SpanGroup& group) {
  auto deepest = static_cast<std::size_t>(std::countr_zero(group.lanes));
  for (std::size_t lane = deepest; lane < Strip::kColumns; ++lane)
    if (group.has(lane) && group.depth[lane] > group.depth[deepest]) deepest = lane;
  return deepest;
}

/// The mip levels of the rows of a group: those of its deepest column.
class MipLevels {
 public:
  MipLevels(const Scene& scene, const Projection& projection, const SpanGroup& group,
            const MipMap& texture, const GroupMapping& mapping)
      : MipLevels(scene, projection, group.span(deepestLane(group)), texture,
                  mapping.of(deepestLane(group))) {}

  /// That of the first row of a block. Only the rows that it fits stay in the block.
  const Texture& fitting(PixelBlock& block) const {
    const int level = levelIn(block, 0);
    int rows = 1;
    while (rows < block.rows && levelIn(block, rows) == level) ++rows;
    block.rows = rows;
    return texture_.level(level);
  }

 private:
  MipLevels(const Scene& scene, const Projection& projection, const Span& span,
            const MipMap& texture, const SpanMapping& mapping)
      : texture_(texture),
        mapping_(mapping),
        footprint_(scene, projection, span, texture.full(), mapping) {}

  int levelIn(const PixelBlock& block, int row) const {
    return footprint_.mipLevelAt(mapping_.parameterAt(block.raySlopes[row]));
  }

  const MipMap& texture_;
  SpanMapping mapping_;
  Footprint footprint_;
};

}  // namespace

void SpanPainter::paint(const SpanGroup& group, LightMode mode, PixelBlock& block, Strip& strip,
                        PaintStats& stats) const {
  const Material material = materialOf(group).shownIn(mode);
  count(material, static_cast<std::size_t>(group.rows.laneCount()),
        static_cast<std::size_t>(group.rows.rowCount()), stats);
  const GroupMapping mapping =
      hearth::mappingOf(scene_, projection_, group, &material.image(), material.lit);
  const bool keepsColumns = !mapping.isPlane && !mapping.isOfFace;
  const GroupLight light{material.lightmap, material.evenLight, keepsColumns};
  // Between the texels of a hole and of its edge nothing is mixed: it would be half a hole.
  const bool haveHoles = mayHaveHoles(material.surface.kind);
  const TextureFilter filter = haveHoles ? TextureFilter::Nearest : settings_.textureFilter;
  const bool areWhite = mode == LightMode::Only;
  GroupTexels texels{areWhite && !haveHoles ? nullptr : &material.image(),
                     filter == TextureFilter::Bilinear, haveHoles, areWhite};
  block.columns = columnsOf(group);
  const auto shadeRows = [&] {
    if (texels.image) fetchColors(block, texels);
    kernels_.shade(block, texels, light, strip.row(block.firstRow));
  };
  if (filter == TextureFilter::Mipmapped && texels.image) {
    const MipLevels levels(scene_, projection_, group, material.texture, mapping);
    forEachBlock(group, block, [&] {
      texels.image = &levels.fitting(block);
      findPlaces(texels, light, onImage(mapping, material.image(), *texels.image), block);
      shadeRows();
    });
  } else {
    forEachBlock(group, block, [&] {
      findPlaces(texels, light, mapping, block);
      shadeRows();
    });
  }
}

void SpanPainter::count(const Material& material, std::size_t spans, std::size_t pixels,
                        PaintStats& stats) {
  const SurfaceKind kind = material.surface.kind;
  if (isSlope(kind) || isSidewall(kind)) stats.slopeSpans += spans;
  stats.pixels += pixels;
  if (!material.hasVaryingLight()) return;
  stats.lightmapSpans += spans;
  if (material.lightmap->channels == 3) stats.coloredSpans += spans;
  stats.lightmapPixels += pixels;
}

void SpanPainter::findPlaces(const GroupTexels& texels, const GroupLight& light,
                             const GroupMapping& mapping, PixelBlock& block) const {
  const bool hasTexels = !texels.image || findTexelsInFixedPoint(texels, mapping, block);
  const bool hasLight = !light.varies() || findLightInFixedPoint(light, mapping, block);
  if (hasTexels && hasLight) return;
  kernels_.findParameters(block, mapping);
  if (!hasTexels && texels.areMixed) kernels_.findTexelsAround(block, mapping, *texels.image);
  if (!hasTexels && !texels.areMixed) kernels_.findTexels(block, mapping, *texels.image);
  if (!hasLight) kernels_.findLightTexels(block, mapping, *light.lightmap, settings_.lightFilter);
}

/// False where that cannot tell them.
bool SpanPainter::findTexelsInFixedPoint(const GroupTexels& texels, const GroupMapping& mapping,
                                         PixelBlock& block) const {
  return !texels.areMixed && kernels_.findLinearTexels(block, mapping, *texels.image);
}

bool SpanPainter::findLightInFixedPoint(const GroupLight& light, const GroupMapping& mapping,
                                        PixelBlock& block) const {
  return kernels_.findLinearLightTexels(block, mapping, *light.lightmap, settings_.lightFilter);
}

/// `view` is what a sprite shows, `face` is one of a mesh.
TextureId SpanPainter::textureOf(SurfaceId id, const SpriteView* view, const MeshFace* face) const {
  if (view) return view->texture;
  return face ? face->texture : scene_[id].mapping.texture;
}

Material SpanPainter::materialOf(SurfaceId id, TextureId texture) const {
  const Surface& surface = scene_[id];
  const auto& lightmap = light_.lightmaps[id.index()];
  return {surface, textures_[texture.index()], lightmap ? &*lightmap : nullptr, litPlacesOf(id),
          evenLightOn(id, texture)};
}

LitPlaces SpanPainter::litPlacesOf(SurfaceId id) const {
  const SurfaceKind kind = scene_[id].kind;
  if (isSprite(kind)) return {};
  if (kind == SurfaceKind::Mesh)
    return {nullptr, light_.lightmaps[id.index()] ? &light_.meshes[scene_.level().meshIndexOf(id)]
                                                  : nullptr};
  const auto& lit = light_.surfaces[id.index()];
  return {lit ? &*lit : nullptr, nullptr};
}

Vec3 SpanPainter::evenLightOn(SurfaceId id, TextureId texture) const {
  const Surface& surface = scene_[id];
  const bool isBright =
      isSky(surface.kind) || (isSprite(surface.kind) && scene_.level().spriteOf(id).isBright);
  if (isBright) return {1, 1, 1};
  const double sector = scene_[surface.sector].light;
  const Vec3 glow = glow_.of(surface.kind, texture);
  return {std::min(1.0, sector + glow.x), std::min(1.0, sector + glow.y),
          std::min(1.0, sector + glow.z)};
}

}  // namespace hearth
