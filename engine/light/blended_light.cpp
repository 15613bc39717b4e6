#include "light/blended_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "level/wall.h"
#include "light/baking/sprite_light.h"
#include "math/parallel.h"

namespace hearth {

namespace {

/// The flat whose edge a step is, by its height; none of other surfaces, which stay in place.
std::optional<double> edgeHeight(const Scene& scene, SurfaceId id) {
  const Surface& surface = scene[id];
  const bool isLower =
      surface.kind == SurfaceKind::LowerStep || surface.kind == SurfaceKind::StackLowerStep;
  const bool isUpper =
      surface.kind == SurfaceKind::UpperStep || surface.kind == SurfaceKind::StackUpperStep;
  if (!isLower && !isUpper) return std::nullopt;
  const Segment& segment = scene[*surface.segment];
  const std::span<const WallSurfaces> walls = scene.level().surfacesOf(segment);
  const auto wall = std::ranges::find(walls, std::optional(id),
                                      isLower ? &WallSurfaces::lower : &WallSurfaces::upper);
  const auto next = targetOf(segment.wall, static_cast<std::uint32_t>(wall - walls.begin()));
  return isLower ? scene.zFloor(scene[*next]) : scene.zCeiling(scene[*next]);
}

/// Three points of a plane, in texel coordinates.
using Corners = std::array<Vec2, 3>;

/// A lightmap of one state, read at texel coordinates of the blended one.
class StateReader {
 public:
  /// What lies at `from` in the blend lies at `to` in the state, where texels `within` belong to
  /// the same part of the surface.
  StateReader(const Lightmap& map, double weight, const Corners& from, const Corners& to,
              const TexelRect& within)
      : map_(&map),
        weight_(weight),
        min_{within.i0 + 0.5, within.j0 + 0.5},
        max_{within.i0 + within.width - 0.5, within.j0 + within.height - 0.5} {
    if (from == to) return;
    const Vec2 u = from[1] - from[0];
    const Vec2 v = from[2] - from[0];
    const double area = cross(u, v);
    axisS_ = (v.y / area) * (to[1] - to[0]) - (u.y / area) * (to[2] - to[0]);
    axisT_ = (u.x / area) * (to[2] - to[0]) - (v.x / area) * (to[1] - to[0]);
    at0_ = to[0] - from[0].x * axisS_ - from[0].y * axisT_;
  }

  double weighted(Vec2 place, int channel) const {
    if (map_->isUniform()) return weight_ * map_->at(0, 0, channel);
    const Vec2 at = at0_ + place.x * axisS_ + place.y * axisT_;
    return weight_ * map_->sample(std::clamp(at.x, min_.x, max_.x),
                                  std::clamp(at.y, min_.y, max_.y), channel);
  }

 private:
  const Lightmap* map_;
  double weight_;
  Vec2 min_;
  Vec2 max_;
  Vec2 at0_{0, 0};
  Vec2 axisS_{1, 0};
  Vec2 axisT_{0, 1};
};

std::uint8_t rounded(double level) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(level + 0.5), 0.0, 255.0));
}

/// Fills some texels of `map` with the sum of what the readers find.
void blendInto(Lightmap& map, const TexelRect& part, std::span<const StateReader> readers) {
  for (int j = part.j0; j < part.j0 + part.height; ++j)
    for (int i = part.i0; i < part.i0 + part.width; ++i)
      for (int channel = 0; channel < map.channels; ++channel) {
        double sum = 0;
        for (const StateReader& reader : readers)
          sum += reader.weighted({i + 0.5, j + 0.5}, channel);
        map.texel(i, j)[channel] = rounded(sum);
      }
}

class Blender {
 public:
  Blender(const Scene& shown, double texel, std::span<const LightAtRest> states, int threads)
      : shown_(shown), states_(states), threads_(threads) {
    light_.surfaces = makeLitSurfaces(shown, texel);
    light_.meshes = makeLitMeshes(shown.level(), texel, threads);
    light_.lightmaps.resize(light_.surfaces.size());
  }

  BakedLight blend() && {
    const Level& level = shown_.level();
    parallelFor(light_.surfaces.size(), threads_, [&](std::size_t i) {
      if (light_.surfaces[i]) blendSurface(SurfaceId(i));
    });
    parallelFor(light_.meshes.size(), threads_,
                [&](std::size_t i) { blendMesh(light_.meshes[i], i); });
    for (const Sprite& sprite : level.sprites) blendSprite(sprite.surface);
    light_.stats = statsOf(light_);
    return std::move(light_);
  }

 private:
  const std::optional<Lightmap>& mapOf(const LightAtRest& state, SurfaceId id) const {
    return state.light->lightmaps[id.index()];
  }

  /// None where all states are dark.
  std::optional<Lightmap> emptyMap(SurfaceId id, const TexelRect& texels) const {
    int channels = 0;
    for (const LightAtRest& state : states_)
      if (const auto& map = mapOf(state, id)) channels = std::max(channels, map->channels);
    return channels == 0 ? std::nullopt : std::optional(Lightmap::dark(texels, channels));
  }

  void blendSurface(SurfaceId id) {
    const LitSurface& lit = *light_.surfaces[id.index()];
    std::optional<Lightmap> map = emptyMap(id, lit.texels);
    if (!map) return;
    const std::optional<double> edge = edgeHeight(shown_, id);
    constexpr Corners kUnit{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}};
    std::vector<StateReader> readers;
    for (const LightAtRest& state : states_) {
      const auto& at = mapOf(state, id);
      if (!at) continue;
      const TexelGrid& grid = state.light->surfaces[id.index()]->grid;
      const Vec3 shift{0, 0, edge ? *edgeHeight(state.scene, id) - *edge : 0};
      Corners there = kUnit;
      if (grid != lit.grid || shift != Vec3{})
        for (Vec2& corner : there) corner = grid.toTexels(lit.grid.toWorld(corner) + shift);
      readers.emplace_back(*at, state.weight, kUnit, there, at->rect);
    }
    blendInto(*map, lit.texels, readers);
    light_.lightmaps[id.index()] = simplified(*std::move(map));
  }

  /// Face by face: where a mesh moves with the floor that it stands on, its patches may lie
  /// elsewhere in the atlas.
  void blendMesh(const LitMesh& mesh, std::size_t index) {
    std::optional<Lightmap> map = emptyMap(mesh.surface, mesh.texels);
    if (!map) return;
    std::vector<std::vector<TexelRect>> rects;  // by state, then by face
    for (const LightAtRest& state : states_)
      rects.push_back(rectsOfFaces(state.light->meshes[index]));
    const auto blendFace = [&](std::uint32_t face, const TexelRect& rect) {
      std::vector<StateReader> readers;
      for (std::size_t i = 0; i < states_.size(); ++i) {
        const auto& at = mapOf(states_[i], mesh.surface);
        const LitMesh& there = states_[i].light->meshes[index];
        // Far from the origin, rounding leaves faces without an area: then it is another mesh.
        if (!at || there.places.size() != mesh.places.size()) continue;
        readers.emplace_back(*at, states_[i].weight, mesh.places[face], there.places[face],
                             rects[i][face]);
      }
      blendInto(*map, rect, readers);
    };
    for (const LitMesh::Patch& patch : mesh.patches) blendFace(patch.faces.front(), rectOf(patch));
    for (const LitMesh::SmallFace& face : mesh.smallFaces) blendFace(face.face, rectOf(face));
    light_.lightmaps[mesh.surface.index()] = simplified(*std::move(map));
  }

  static TexelRect rectOf(const LitMesh::Patch& patch) {
    return {patch.i, patch.j, patch.surface.texels.width, patch.surface.texels.height};
  }
  static TexelRect rectOf(const LitMesh::SmallFace& face) {
    return {face.i, face.j, kSmallFaceSide, kSmallFaceSide};
  }
  /// The texels of an atlas that belong to each face.
  static std::vector<TexelRect> rectsOfFaces(const LitMesh& mesh) {
    std::vector<TexelRect> rects(mesh.places.size());
    for (const LitMesh::Patch& patch : mesh.patches)
      for (const std::uint32_t face : patch.faces) rects[face] = rectOf(patch);
    for (const LitMesh::SmallFace& face : mesh.smallFaces) rects[face.face] = rectOf(face);
    return rects;
  }

  void blendSprite(SurfaceId id) {
    std::optional<Lightmap> map = emptyMap(id, kSpriteTexel);
    if (!map) return;
    std::vector<StateReader> readers;
    for (const LightAtRest& state : states_)
      if (const auto& at = mapOf(state, id))
        readers.emplace_back(*at, state.weight, Corners{}, Corners{}, kSpriteTexel);
    blendInto(*map, kSpriteTexel, readers);
    light_.lightmaps[id.index()] = simplified(*std::move(map));
  }

  const Scene& shown_;
  std::span<const LightAtRest> states_;
  int threads_;
  BakedLight light_;
};

}  // namespace

BakedLight blendedLight(const Scene& shown, double texel, std::span<const LightAtRest> states,
                        int threads) {
  return Blender(shown, texel, states, threads).blend();
}

}  // namespace hearth
