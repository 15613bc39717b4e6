#include "agreement/plain_texels.h"

#include <algorithm>
#include <cmath>

#include "agreement/plain_grids.h"
#include "math/predicates.h"
#include "math/trig.h"

namespace hearth::agreement {

namespace {

constexpr double kInsideEdge = 1e-6;  ///< metres that samples keep from the edges of surfaces

}  // namespace

PlainTexels::PlainTexels(const Scene& scene)
    : scene_(scene),
      panels_(scene.level().surfaces.size()),
      continuations_(scene.level().surfaces.size()) {
  for (const SurfaceId id : scene.shownSurfaces())
    if (!isSky(scene[id].kind) && !isThing(scene[id].kind))
      panels_[id.index()] = panelOf(scene, id);
  corners_ = cornersOf(scene, panels_);
  grids_ = plainGrids(scene, panels_);
}

std::optional<TexelPatch> PlainTexels::around(const SurfacePoint& hit) const {
  const std::optional<std::size_t> surface = surfaceOf(hit);
  if (!surface) return std::nullopt;
  const Vec2 texels = (1 / scene_.level().bake.texel) * grids_[*surface].of(hit.point);
  const double i = std::floor(texels.x - 0.5);
  const double j = std::floor(texels.y - 0.5);
  const double fs = texels.x - 0.5 - i;
  const double ft = texels.y - 0.5 - j;
  return TexelPatch{
      {{{*surface, i, j}, {*surface, i + 1, j}, {*surface, i, j + 1}, {*surface, i + 1, j + 1}}},
      {(1 - fs) * (1 - ft), fs * (1 - ft), (1 - fs) * ft, fs * ft}};
}

std::vector<TexelSample> PlainTexels::samplesOf(const Texel& texel) {
  const double side = std::sqrt(scene_.level().bake.samples.value());
  std::vector<TexelSample> samples;
  for (double t = 0.5; t < side; ++t)
    for (double s = 0.5; s < side; ++s) {
      const Vec2 inTexels{texel.i + s / side, texel.j + t / side};
      const Vec3 center = grids_[texel.surface].at(scene_.level().bake.texel * inTexels);
      samples.push_back(sampleAt(texel.surface, center));
    }
  return samples;
}

std::vector<SurfacePoint> PlainTexels::ringAround(const SurfacePoint& place,
                                                  double radiusMetres) const {
  constexpr int kDirections = 16;
  std::vector<SurfacePoint> ring;
  const Panel& panel = *panels_[*surfaceOf(place)];
  const Vec2 center = panel.axes.of(place.point);
  for (int i = 0; i < kDirections; ++i) {
    const SinCos turn = sinCosDegrees(360.0 * i / kDirections);
    const Vec2 st = center + radiusMetres * Vec2{turn.cos, turn.sin};
    if (!panel.contains(st)) continue;
    ring.push_back(place);
    ring.back().point = panel.axes.at(st);
  }
  return ring;
}

std::optional<std::size_t> PlainTexels::surfaceOf(const SurfacePoint& hit) const {
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    const Surface& surface = scene_[SurfaceId(i)];
    if (surface.kind != hit.kind || surface.sector != hit.sector) continue;
    if (surface.segment != hit.segment || !panels_[i]) continue;
    if (!surface.segment) return i;
    const SurfaceGeometry& at = scene_.geometryOf(SurfaceId(i));
    if (hit.point.z >= at.zBottom - 1e-6 && hit.point.z <= at.zTop + 1e-6) return i;
  }
  return std::nullopt;
}

/// Of the surface and what continues it near the sample, the point that is nearest to it.
TexelSample PlainTexels::sampleAt(std::size_t surface, Vec3 center) {
  double least = panels_[surface]->distanceTo(panels_[surface]->axes.of(center));
  if (least <= kInsideEdge) least = 0;  // it lies on the surface, up to what samples keep off edges
  for (const std::size_t other : reachableFrom(surface, center, least)) {
    const double distance = panels_[other]->distanceTo(panels_[other]->axes.of(center));
    if (distance >= least - kInsideEdge) continue;
    least = distance;
    surface = other;
  }
  const Panel& panel = *panels_[surface];
  const Vec2 st = panel.axes.of(center);
  const Vec2 nearest = panel.contains(st) ? st : panel.nearestOnEdge(st);
  const Surface& found = scene_[SurfaceId(surface)];
  TexelSample placed{center, {found.kind, found.sector, found.segment, {}, panel.normal}, {}};
  const std::vector<Vec2> places = panel.movedInside(nearest, kInsideEdge, st);
  placed.place.point = panel.axes.at(places.front());
  for (std::size_t i = 1; i < places.size(); ++i) {
    placed.others.push_back(placed.place);
    placed.others.back().point = panel.axes.at(places[i]);
  }
  return placed;
}

/// What continues the surface, reached over common edges no more than `distance` from the sample,
/// up to what samples keep off edges.
std::vector<std::size_t> PlainTexels::reachableFrom(std::size_t surface, Vec3 sample,
                                                    double distance) {
  std::vector<std::size_t> reached{surface};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const Vec2 st = panels_[reached[next]]->axes.of(sample);
    for (const auto& [to, edge] : continuationsOf(reached[next])) {
      if (length(nearestOnSegment(edge.a, edge.b, st) - st) > distance + kInsideEdge) continue;
      if (std::ranges::find(reached, to) == reached.end()) reached.push_back(to);
    }
  }
  return reached;
}

/// Of walls, those of one run are.
bool PlainTexels::areInOnePlane(std::size_t a, std::size_t b) const {
  if (scene_[SurfaceId(a)].segment && scene_[SurfaceId(b)].segment) return grids_[a] == grids_[b];
  return agreement::areInOnePlane(*panels_[a], *panels_[b]);
}

const std::vector<CommonEdge>& PlainTexels::continuationsOf(std::size_t surface) {
  if (!continuations_[surface]) {
    continuations_[surface].emplace();
    for (std::size_t to = 0; to < panels_.size(); ++to) {
      if (to == surface || !panels_[to] || !areInOnePlane(surface, to)) continue;
      // What hangs in an opening is no part of the wall round it.
      if ((scene_[SurfaceId(to)].kind == SurfaceKind::MaskedMiddle) !=
          (scene_[SurfaceId(surface)].kind == SurfaceKind::MaskedMiddle))
        continue;
      for (const Edge& edge : commonEdges(scene_, corners_, *panels_[surface], *panels_[to]))
        continuations_[surface]->push_back({to, edge});
    }
  }
  return *continuations_[surface];
}

}  // namespace hearth::agreement
