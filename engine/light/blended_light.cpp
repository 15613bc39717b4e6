#include "light/blended_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "level/wall.h"
#include "light/blended_texels.h"
#include "math/check.h"

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

/// Texels that both lie in, and those between them.
TexelRect around(const TexelRect& a, const TexelRect& b) {
  const int i0 = std::min(a.i0, b.i0);
  const int j0 = std::min(a.j0, b.j0);
  return {i0, j0, std::max(a.i0 + a.width, b.i0 + b.width) - i0,
          std::max(a.j0 + a.height, b.j0 + b.height) - j0};
}

bool areSameTexels(const Lightmap& a, const Lightmap& b) {
  return a.rect == b.rect && a.channels == b.channels && a.levels == b.levels;
}

TexelRect rectOf(const LitMesh::Patch& patch) {
  return {patch.i, patch.j, patch.surface.texels.width, patch.surface.texels.height};
}

TexelRect rectOf(const LitMesh::SmallFace& face) {
  return {face.i, face.j, kSmallFaceSide, kSmallFaceSide};
}

/// The texels of an atlas that belong to each face.
std::vector<TexelRect> rectsOfFaces(const LitMesh& mesh) {
  std::vector<TexelRect> rects(mesh.places.size());
  for (const LitMesh::Patch& patch : mesh.patches)
    for (const std::uint32_t face : patch.faces) rects[face] = rectOf(patch);
  for (const LitMesh::SmallFace& face : mesh.smallFaces) rects[face.face] = rectOf(face);
  return rects;
}

void runEach(std::size_t count, Workers* workers, const std::function<void(std::size_t)>& work) {
  if (workers && count > 1) return workers->run(count, work);  // else it would only wake them
  for (std::size_t i = 0; i < count; ++i) work(i);
}

/// Whether points have the same texel coordinates on both, however high these are.
bool haveSameTexels(const Scene& scene, SurfaceId id, const LitSurface& a, const LitSurface& b) {
  return isLevelFlat(scene[id].kind) || a.grid == b.grid;
}

/// The texels of one surface that some of another lie on.
TexelRect rectOn(const LitSurface& to, const LitSurface& from, const TexelRect& rect) {
  std::vector<Vec2> corners;
  for (const int i : {rect.i0, rect.i0 + rect.width})
    for (const int j : {rect.j0, rect.j0 + rect.height})
      corners.push_back(to.grid.toTexels(from.grid.toWorld(Vec2{1.0 * i, 1.0 * j})));
  return texelsAround({&corners, 1});
}

double sumOf(std::span<const double> weights, std::span<const std::size_t> states) {
  double sum = 0;
  for (const std::size_t state : states) sum += weights[state];
  return sum;
}

constexpr StateTexels::Corners kUnit{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}};

/// Where these points of one surface lie on another, where all is `rise` metres higher.
StateTexels::Corners placesOn(const LitSurface& to, const LitSurface& from, double rise) {
  StateTexels::Corners places = kUnit;
  for (Vec2& place : places) place = to.grid.toTexels(from.grid.toWorld(place) + Vec3{0, 0, rise});
  return places;
}

/// The side of the texels, in metres; any where no state has some.
double texelOf(std::span<const LightAtRest> states) {
  for (const LightAtRest& state : states)
    for (const std::optional<LitSurface>& surface : state.light->surfaces)
      if (surface) return surface->grid.texel;
  return 1;
}

}  // namespace

void BlendedLight::setStates(std::span<const LightAtRest> states) {
  hasOwnSurfaces_ = false;
  states_.assign(states.begin(), states.end());
  setAllLight();
}

void BlendedLight::setStates(std::span<const LightAtRest> states, LitSurfaces surfaces) {
  hasOwnSurfaces_ = true;
  light_.surfaces = std::move(surfaces);
  states_.assign(states.begin(), states.end());
  setAllLight();
}

void BlendedLight::setAllLight() {
  CHECK(!states_.empty(), states_.size());
  blends_.clear();
  meshes_.clear();
  moving_.clear();
  const Level& level = states_.front().scene.level();
  light_.surfaces.resize(level.surfaces.size());
  light_.lightmaps.resize(level.surfaces.size());
  light_.meshes.resize(level.meshes.size());
  light_.stats = states_.front().light->stats;
  for (std::size_t i = 0; i < level.surfaces.size(); ++i) {
    if (!hasOwnSurfaces_) setSurface(SurfaceId(i));
    if (level.surfaces[i].kind != SurfaceKind::Mesh) setLight(SurfaceId(i));
  }
  for (std::size_t i = 0; i < level.meshes.size(); ++i) setMesh(i);
}

/// As it lies in the first state that shows it.
void BlendedLight::setSurface(SurfaceId id) {
  const LitSurface* first = nullptr;
  bool moves = false;
  for (const LightAtRest& state : states_) {
    const auto& lit = state.light->surfaces[id.index()];
    if (!lit) continue;
    if (!first) first = &*lit;
    moves |= lit->grid.origin.z != first->grid.origin.z;
  }
  std::optional<LitSurface>& surface = light_.surfaces[id.index()];
  if (!first)
    surface.reset();
  else if (!surface || surface->grid != first->grid || surface->texels != first->texels)
    surface = *first;
  if (moves && isLevelFlat(states_.front().scene[id].kind)) moving_.push_back(id);
}

/// The light of a surface whose places on its lightmap follow from its grid, or are the same in all
/// states.
void BlendedLight::setLight(SurfaceId id) {
  std::optional<Lightmap>& map = light_.lightmaps[id.index()];
  Blend blend = blendOf(id);
  std::size_t lit = 0;
  int channels = 1;
  for (const Source& source : blend.sources) {
    lit += source.states.size();
    channels = std::max(channels, source.map->channels);
  }
  const bool isLost =
      hasOwnSurfaces_ && !isThing(states_.front().scene[id].kind) && !light_.surfaces[id.index()];
  if (blend.sources.empty() || isLost) return map.reset();
  const TexelRect texels = texelsOf(blend);
  const Lightmap& first = *blend.sources.front().map;
  if (blend.sources.size() == 1 && lit == states_.size() && texels == first.rect) {
    if (!map || !areSameTexels(*map, first)) map = first;
    return;
  }
  map = Lightmap::dark(texels, channels);
  blend.texels.reserve(blend.sources.size());
  blends_.push_back(std::move(blend));
}

BlendedLight::Blend BlendedLight::blendOf(SurfaceId id) const {
  Blend blend{id, {}, {}};
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const auto& map = states_[i].light->lightmaps[id.index()];
    const auto& lit = states_[i].light->surfaces[id.index()];
    if (lit || isThing(states_[i].scene[id].kind)) blend.shownIn.push_back(i);
    if (!map) continue;
    const std::optional<double> edge = edgeHeight(states_[i].scene, id);
    const auto same = std::ranges::find_if(blend.sources, [&](const Source& source) {
      return source.edge == edge &&
             (!lit || haveSameTexels(states_[i].scene, id, *source.lit, *lit)) &&
             areSameTexels(*source.map, *map);
    });
    if (same != blend.sources.end())
      same->states.push_back(i);
    else
      blend.sources.push_back({&*map, lit ? &*lit : nullptr, edge, {i}});
  }
  return blend;
}

/// Those of the surface that was given; else all that it has in some state.
TexelRect BlendedLight::texelsOf(const Blend& blend) const {
  const std::optional<LitSurface>& lit = light_.surfaces[blend.surface.index()];
  if (hasOwnSurfaces_ && lit) return lit->texels;
  TexelRect texels = blend.sources.front().map->rect;
  for (const Source& source : blend.sources) {
    const TexelRect& rect = source.map->rect;
    const bool isSame =
        !lit || haveSameTexels(states_.front().scene, blend.surface, *lit, *source.lit);
    texels = around(texels, isSame ? rect : rectOn(*lit, *source.lit, rect));
  }
  return texels;
}

void BlendedLight::setMesh(std::size_t mesh) {
  const LitMesh& first = states_.front().light->meshes[mesh];
  light_.meshes[mesh] = first;
  const bool isAtOnePlace = std::ranges::all_of(states_, [&](const LightAtRest& state) {
    return state.light->meshes[mesh].places == first.places;
  });
  if (isAtOnePlace) return setLight(first.surface);
  MeshBlend blend{mesh, {}};
  int channels = 0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const auto& map = states_[i].light->lightmaps[first.surface.index()];
    const LitMesh& there = states_[i].light->meshes[mesh];
    // Far from the origin, rounding leaves faces without an area: then it is another mesh.
    if (!map || there.places.size() != first.places.size()) continue;
    blend.sources.push_back({i, rectsOfFaces(there)});
    channels = std::max(channels, map->channels);
  }
  std::optional<Lightmap>& map = light_.lightmaps[first.surface.index()];
  if (channels == 0) return map.reset();
  map = Lightmap::dark(first.texels, channels);
  blend.texels.reserve(blend.sources.size());
  meshes_.push_back(std::move(blend));
}

void BlendedLight::blend(const Scene& shown, std::span<const double> weights, Workers* workers) {
  CHECK(weights.size() == states_.size(), weights.size(), states_.size());
  for (const SurfaceId id : moving_) {
    LitSurface& lit = *light_.surfaces[id.index()];
    lit.grid.origin.z = lit.anchor.z = shown.geometryOf(id).zBottom;
  }
  const auto onSurface = [&](std::size_t i) { blendSurface(shown, weights, blends_[i]); };
  const auto onMesh = [&](std::size_t i) { blendMesh(weights, meshes_[i]); };
  runEach(blends_.size(), workers, std::cref(onSurface));  // a reference takes no memory
  runEach(meshes_.size(), workers, std::cref(onMesh));
}

void BlendedLight::blendSurface(const Scene& shown, std::span<const double> weights, Blend& blend) {
  const std::optional<LitSurface>& lit = light_.surfaces[blend.surface.index()];
  const std::optional<double> edge = edgeHeight(shown, blend.surface);
  const double all = sumOf(weights, blend.shownIn);
  blend.texels.clear();
  for (const Source& source : blend.sources) {
    const double weight = sumOf(weights, source.states) / all;
    if (!(weight > 0)) continue;
    const double rise = edge ? *source.edge - *edge : 0;
    if (!lit)
      blend.texels.emplace_back(*source.map, weight, Vec2{});
    else if (haveSameTexels(shown, blend.surface, *lit, *source.lit))
      blend.texels.emplace_back(*source.map, weight, Vec2{0, rise / lit->grid.texel});
    else
      blend.texels.emplace_back(*source.map, weight, kUnit, placesOn(*source.lit, *lit, rise),
                                source.map->rect);
  }
  Lightmap& map = *light_.lightmaps[blend.surface.index()];
  blendInto(map, map.rect, blend.texels);
}

/// Face by face.
void BlendedLight::blendMesh(std::span<const double> weights, MeshBlend& blend) {
  const LitMesh& mesh = light_.meshes[blend.mesh];
  Lightmap& map = *light_.lightmaps[mesh.surface.index()];
  const auto blendFace = [&](std::uint32_t face, const TexelRect& rect) {
    blend.texels.clear();
    for (const MeshBlend::Source& source : blend.sources) {
      const BakedLight& light = *states_[source.state].light;
      if (weights[source.state] > 0)
        blend.texels.emplace_back(*light.lightmaps[mesh.surface.index()], weights[source.state],
                                  mesh.places[face], light.meshes[blend.mesh].places[face],
                                  source.rectOf[face]);
    }
    blendInto(map, rect, blend.texels);
  };
  for (const LitMesh::Patch& patch : mesh.patches) blendFace(patch.faces.front(), rectOf(patch));
  for (const LitMesh::SmallFace& face : mesh.smallFaces) blendFace(face.face, rectOf(face));
}

BakedLight blendedLight(const Scene& shown, std::span<const LightAtRest> states,
                        std::span<const double> weights, int threads) {
  BlendedLight blended;
  blended.setStates(states, makeLitSurfaces(shown, texelOf(states)));
  Workers workers(threads);
  blended.blend(shown, weights, &workers);
  BakedLight light = blended.light();
  for (std::optional<Lightmap>& map : light.lightmaps)
    if (map) map = simplified(*std::move(map));
  light.stats = statsOf(light);
  return light;
}

}  // namespace hearth
