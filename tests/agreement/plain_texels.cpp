#include "agreement/plain_texels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <utility>

#include "agreement/plain_grids.h"
#include "math/predicates.h"
#include "math/trig.h"

namespace hearth::agreement {

namespace {

constexpr double kInsideEdge = 1e-6;  ///< metres that samples keep from the edges of surfaces

/// Of the lightmap of `of`, the texels around a place.
TexelPatch patchAround(const Texel& of, Vec2 texels) {
  const double i = std::floor(texels.x - 0.5);
  const double j = std::floor(texels.y - 0.5);
  const double fs = texels.x - 0.5 - i;
  const double ft = texels.y - 0.5 - j;
  const auto at = [&](double di, double dj) { return Texel{of.surface, of.piece, i + di, j + dj}; };
  return TexelPatch{{{at(0, 0), at(1, 0), at(0, 1), at(1, 1)}},
                    {(1 - fs) * (1 - ft), fs * (1 - ft), (1 - fs) * ft, fs * ft}};
}

}  // namespace

PlainTexels::PlainTexels(const Scene& scene)
    : scene_(scene),
      meshes_(scene),
      panels_(scene.level().surfaces.size()),
      continuations_(scene.level().surfaces.size()) {
  for (const SurfaceId id : scene.shownSurfaces())
    if (!isSky(scene[id].kind) && !isThing(scene[id].kind))
      panels_[id.index()] = panelOf(scene, id);
  corners_ = cornersOf(scene, panels_);
  grids_ = plainGrids(scene, panels_);
}

std::optional<TexelPatch> PlainTexels::around(const SurfacePoint& hit) {
  if (hit.mesh) return aroundOnMesh(hit);
  const std::optional<std::size_t> surface = surfaceOf(hit);
  if (!surface) return std::nullopt;
  return patchAround({*surface, 0, 0, 0},
                     (1 / scene_.level().bake.texel) * grids_[*surface].of(hit.point));
}

std::optional<TexelPatch> PlainTexels::aroundOnMesh(const SurfacePoint& hit) {
  const MeshPiece& piece = meshes_.pieceOf(*hit.face);
  const Texel texel{hit.mesh->index(), piece.faces.front(), 0, 0};
  if (!piece.isSmall)
    return patchAround(texel, (1 / scene_.level().bake.texel) * piece.panel.axes.of(hit.point));
  const auto& [a, b, c] = scene_.level().meshFaces[*hit.face].corners;
  const Vec3 out = cross(c - a, b - a);
  const auto weight = [&](Vec3 from, Vec3 to) {
    return dot(out, cross(to - hit.point, from - hit.point)) / dot(out, out);
  };
  return patchAround(texel, {weight(c, a) + 0.5, weight(a, b) + 0.5});
}

bool PlainTexels::isFourthOfSmallFace(const Texel& texel) {
  return scene_[SurfaceId(texel.surface)].kind == SurfaceKind::Mesh &&
         meshes_.pieceOf(texel.piece).isSmall && texel.i == 1 && texel.j == 1;
}

bool PlainTexels::hasCornersForSamples(const Texel& texel) {
  const bool isOfMesh = scene_[SurfaceId(texel.surface)].kind == SurfaceKind::Mesh;
  return isOfMesh && meshes_.pieceOf(texel.piece).isSmall;
}

bool PlainTexels::hasAllSamples(const Texel& texel) {
  return hasCornersForSamples(texel) ||
         std::ssize(samplesOf(texel)) == scene_.level().bake.samples.value();
}

/// One that lies in no air takes the light of the next that does.
std::vector<TexelSample> PlainTexels::cornerOf(const MeshPiece& piece, std::size_t corner) const {
  const Mesh& mesh = scene_.level().meshes[piece.mesh];
  const auto& corners = scene_.level().meshFaces[piece.faces.front()].corners;
  SurfacePoint place{SurfaceKind::Mesh,  mesh.sector, {},           {},
                     piece.panel.normal, {},          mesh.surface, piece.faces.front()};
  place.point = corners[corner];
  for (std::size_t k = 0; k < 3; ++k)
    if (const Vec3 at = corners[(corner + k) % 3]; meshes_.isInAir(piece.mesh, at)) {
      place.point = at;
      break;
    }
  return {{place.point, place, {}}};
}

std::vector<TexelSample> PlainTexels::meshSamplesOf(const Texel& texel) {
  const MeshPiece& piece = meshes_.pieceOf(texel.piece);
  if (piece.isSmall) return cornerOf(piece, texel.i > 0 ? 1 : texel.j > 0 ? 2 : 0);
  const Mesh& mesh = scene_.level().meshes[piece.mesh];
  const Panel& panel = piece.panel;
  const double side = std::sqrt(scene_.level().bake.samples.value());
  std::vector<TexelSample> samples;
  for (double t = 0.5; t < side; ++t)
    for (double s = 0.5; s < side; ++s) {
      const Vec2 st = scene_.level().bake.texel * Vec2{texel.i + s / side, texel.j + t / side};
      TexelSample placed{panel.axes.at(st),
                         {SurfaceKind::Mesh,
                          mesh.sector,
                          {},
                          {},
                          panel.normal,
                          {},
                          mesh.surface,
                          piece.faces.front()},
                         {}};
      const std::vector<Vec2> places =
          panel.movedInside(panel.contains(st) ? st : panel.nearestOnEdge(st), kInsideEdge, st);
      placed.place.point = panel.axes.at(places.front());
      for (std::size_t i = 1; i < places.size(); ++i) {
        placed.others.push_back(placed.place);
        placed.others.back().point = panel.axes.at(places[i]);
      }
      samples.push_back(std::move(placed));
    }
  return samples;
}

/// Filtering can read it: its middle is less than a texel beside the surface.
bool PlainTexels::isOnLightmap(const Texel& texel) {
  const bool isOfMesh = scene_[SurfaceId(texel.surface)].kind == SurfaceKind::Mesh;
  const Axes& axes = isOfMesh ? meshes_.pieceOf(texel.piece).panel.axes : grids_[texel.surface];
  const Panel& panel = isOfMesh ? meshes_.pieceOf(texel.piece).panel : *panels_[texel.surface];
  const Vec3 middle = axes.at(scene_.level().bake.texel * Vec2{texel.i + 0.5, texel.j + 0.5});
  return panel.distanceTo(panel.axes.of(middle)) < scene_.level().bake.texel;
}

Texel PlainTexels::nearestWithSamples(const Texel& texel) {
  if (!samplesOf(texel).empty()) return texel;
  constexpr int kFarthest = 64;
  Texel nearest = texel;
  double least = std::numeric_limits<double>::infinity();
  for (int ring = 1; ring <= kFarthest && 1.0 * ring * ring < least; ++ring)
    for (int dj = -ring; dj <= ring; ++dj)
      for (int di = -ring; di <= ring; di += std::abs(dj) == ring ? 1 : 2 * ring) {
        const double distance = 1.0 * di * di + 1.0 * dj * dj;
        const Texel other{texel.surface, texel.piece, texel.i + di, texel.j + dj};
        if (distance >= least || !isOnLightmap(other) || samplesOf(other).empty()) continue;
        least = distance;
        nearest = other;
      }
  return nearest;
}

std::vector<TexelSample> PlainTexels::samplesOf(const Texel& texel) {
  std::vector<TexelSample> samples = allSamplesOf(texel);
  if (hasCornersForSamples(texel)) return samples;
  std::erase_if(samples, [&](const TexelSample& sample) { return isLeftOut(sample.place); });
  return samples;
}

bool PlainTexels::isLeftOut(const SurfacePoint& place) const {
  return place.mesh ? !meshes_.isInAir(scene_.level().meshIndexOf(*place.mesh), place.point)
                    : meshes_.isInsideMesh(place.point, place.normal, place.sector);
}

bool PlainTexels::isInDoubt(const Texel& texel) {
  constexpr double kHair = 2e-6;  // metres
  if (hasCornersForSamples(texel)) return false;
  if (samplesOf(texel).empty()) return true;
  return std::ranges::any_of(allSamplesOf(texel), [&](const TexelSample& sample) {
    std::vector<SurfacePoint> places = sample.others;
    std::ranges::copy(ringAround(sample.place, kHair), std::back_inserter(places));
    const bool isOut = isLeftOut(sample.place);
    return std::ranges::any_of(
        places, [&](const SurfacePoint& place) { return isLeftOut(place) != isOut; });
  });
}

std::vector<TexelSample> PlainTexels::allSamplesOf(const Texel& texel) {
  if (scene_[SurfaceId(texel.surface)].kind == SurfaceKind::Mesh) return meshSamplesOf(texel);
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

std::vector<SurfacePoint> PlainTexels::ringAround(const SurfacePoint& place, double radiusMetres) {
  constexpr int kDirections = 16;
  std::vector<SurfacePoint> ring;
  const Panel& panel =
      place.face ? meshes_.pieceOf(*place.face).panel : *panels_[*surfaceOf(place)];
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
