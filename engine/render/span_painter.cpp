#include "render/span_painter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "render/face_mapping.h"
#include "render/footprint.h"
#include "render/texel_fetch.h"

namespace hearth {

namespace {

void count(const SpanGroup& group, const Material& material, PaintStats& stats) {
  const SurfaceKind kind = material.surface.kind;
  const auto spans = static_cast<std::size_t>(group.rows.laneCount());
  const auto pixels = static_cast<std::size_t>(group.rows.rowCount());
  if (isSlope(kind) || isSidewall(kind)) stats.slopeSpans += spans;
  stats.pixels += pixels;
  if (!material.hasVaryingLight()) return;
  stats.lightmapSpans += spans;
  if (material.lightmap->channels == 3) stats.coloredSpans += spans;
  stats.lightmapPixels += pixels;
}

PixelBlock::Columns columnsOf(const SpanGroup& group) {
  return {group.rows, std::ranges::max(group.rows.begin), std::ranges::min(group.rows.end)};
}

/// The column that goes deepest, of those that have a span. On a level plane no row that another
/// one shows is deeper than there.
std::size_t deepestLane(const SpanGroup& group) {
  auto deepest = static_cast<std::size_t>(std::countr_zero(group.lanes));
  for (std::size_t lane = deepest; lane < Strip::kColumns; ++lane)
    if (group.has(lane) && group.depth[lane] > group.depth[deepest]) deepest = lane;
  return deepest;
}

/// The sizes of a texture that fit the rows of a group: those that fit one of its columns.
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
  if (!group.faces.empty()) return paintFaces(group, mode, block, strip, stats);
  Material material = materialOf(group);
  if (mode == LightMode::None) {
    material.lightmap = nullptr;
    material.sectorLight = 1;
  }
  // Without light that differs from pixel to pixel there is no lightmap to be mapped to.
  if (!material.hasVaryingLight()) material.lit = {};
  count(group, material, stats);
  const GroupMapping mapping =
      hearth::mappingOf(scene_, projection_, group, &material.image(), material.lit);
  const bool isUpright = !mapping.isPlane && !mapping.isTurned;
  const GroupLight light{material.lightmap, material.sectorLight, isUpright};
  // Between the texels of a hole and of its edge nothing is mixed: it would be half a hole.
  const bool haveHoles = mayHaveHoles(material.surface.kind);
  const TextureFilter filter = haveHoles ? TextureFilter::Nearest : settings_.textureFilter;
  const bool areWhite = mode == LightMode::Only;
  GroupTexels texels{areWhite && !haveHoles ? nullptr : &material.image(),
                     filter == TextureFilter::Bilinear, haveHoles, areWhite};
  std::optional<MipLevels> mipLevels;
  if (filter == TextureFilter::Mipmapped && texels.image)
    mipLevels.emplace(scene_, projection_, group, material.texture, mapping);
  block.columns = columnsOf(group);
  for (int row = group.rowBegin; row < group.rowEnd; row += block.rows) {
    block.firstRow = row;
    block.rows = std::min(PixelBlock::kRows, group.rowEnd - row);
    block.raySlopes = &raySlopes_[static_cast<std::size_t>(row)];
    if (mipLevels) {
      texels.image = &mipLevels->fitting(block);
      findPlaces(texels, light, onImage(mapping, material.image(), *texels.image), block);
    } else {
      findPlaces(texels, light, mapping, block);
    }
    if (texels.image) fetchColors(block, texels);
    kernels_.shade(block, texels, light, strip.row(row));
  }
}

// --- narrow faces
// ---------------------------------------------------------------------------------

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

namespace {

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

// --- places
// ---------------------------------------------------------------------------------------

void SpanPainter::findPlaces(const GroupTexels& texels, const GroupLight& light,
                             const GroupMapping& mapping, PixelBlock& block) const {
  const bool hasTexels = !texels.image || (!texels.areMixed && kernels_.findLinearTexels(
                                                                   block, mapping, *texels.image));
  const bool hasLight =
      !light.varies() ||
      kernels_.findLinearLightTexels(block, mapping, *light.lightmap, settings_.lightFilter);
  if (hasTexels && hasLight) return;
  kernels_.findParameters(block, mapping);
  if (!hasTexels)
    (texels.areMixed ? kernels_.findTexelsAround : kernels_.findTexels)(block, mapping,
                                                                        *texels.image);
  if (!hasLight) kernels_.findLightTexels(block, mapping, *light.lightmap, settings_.lightFilter);
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
          sectorLightOn(id)};
}

LitPlaces SpanPainter::litPlacesOf(SurfaceId id) const {
  if (scene_[id].kind == SurfaceKind::Mesh)
    return {nullptr, light_.lightmaps[id.index()] ? &light_.meshes[scene_.level().meshIndexOf(id)]
                                                  : nullptr};
  const auto& lit = light_.surfaces[id.index()];
  return {lit ? &*lit : nullptr, nullptr};
}

double SpanPainter::sectorLightOn(SurfaceId id) const {
  const Surface& surface = scene_[id];
  const bool isBright =
      isSky(surface.kind) || (isSprite(surface.kind) && scene_.level().spriteOf(id).isBright);
  return isBright ? 1 : scene_[surface.sector].light;
}

}  // namespace hearth
